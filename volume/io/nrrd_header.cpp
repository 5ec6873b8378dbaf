#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/nrrd_header.h>

#include <algorithm>
#include <map>

namespace isocast {
namespace {

struct Field {
  const std::filesystem::path& path;
  int line;
  std::string name;  // lower case, without blanks
  std::string_view value;

  InputError error(std::string_view what) const {
    return read_error(path, fmt::format("line {}: {}", line, what));
  }
  InputError unexpected(std::string_view expected) const {
    return error(fmt::format("field '{}' has the value {}, expected {}", name, in_quotes(value), expected));
  }
};

// Per-axis fields have one word an axis, and stand after the dimension.
std::vector<std::string_view> words_of_axes(const NrrdHeader& header, const Field& field) {
  if (header.axes.empty()) throw field.error(fmt::format("field '{}' stands before 'dimension'", field.name));
  const std::vector<std::string_view> words = split_words(field.value);
  if (words.size() != header.axes.size()) throw field.unexpected(fmt::format("{} words", header.axes.size()));
  return words;
}

void read_axis_numbers(NrrdHeader& header, const Field& field, double NrrdAxis::*member) {
  const std::vector<std::string_view> words = words_of_axes(header, field);
  for (std::size_t a = 0; a < words.size(); ++a) {
    const std::optional<double> number = to_number<double>(words[a]);
    if (!number) throw field.unexpected("numbers");
    header.axes[a].*member = *number;
  }
}

// "(x,y,z)" at the start of `rest`, which moves on behind it; nothing for "none".
std::optional<Double3> take_vector(std::string_view& rest, const Field& field) {
  rest = trimmed(rest);
  if (rest.starts_with("none")) {
    rest.remove_prefix(4);
    return std::nullopt;
  }
  const std::size_t close = rest.find(')');
  if (!rest.starts_with('(') || close == rest.npos) throw field.unexpected("vectors like (1,0,0) or none");
  std::string inside(rest.substr(1, close - 1));
  std::ranges::replace(inside, ',', ' ');
  const auto numbers = to_numbers<double>(inside, 3);
  if (!numbers) throw field.unexpected("vectors of three numbers");
  rest.remove_prefix(close + 1);
  return Double3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

void read_dimension(NrrdHeader& header, const Field& field) {
  const auto dimension = to_number<std::int64_t>(field.value);
  if (!dimension || *dimension < 1 || *dimension > 16) throw field.unexpected("a number from 1 to 16");
  if (*dimension != 3 && *dimension != 4) throw field.unexpected("3, or 4 with one axis of size 1");
  header.axes.resize(static_cast<std::size_t>(*dimension));
}

void read_sizes(NrrdHeader& header, const Field& field) {
  const std::vector<std::string_view> words = words_of_axes(header, field);
  for (std::size_t a = 0; a < words.size(); ++a) {
    const auto size = to_number<std::int64_t>(words[a]);
    if (!size || *size < 1) throw field.unexpected("whole numbers from 1 on");
    header.axes[a].size = *size;
  }
}

void read_directions(NrrdHeader& header, const Field& field) {
  if (header.axes.empty()) throw field.error("field 'spacedirections' stands before 'dimension'");
  std::string_view rest = field.value;
  for (NrrdAxis& axis : header.axes) axis.direction = take_vector(rest, field);
  if (!trimmed(rest).empty()) throw field.unexpected(fmt::format("{} vectors", header.axes.size()));
  header.has_directions = true;
}

void read_origin(NrrdHeader& header, const Field& field) {
  std::string_view rest = field.value;
  const std::optional<Double3> origin = take_vector(rest, field);
  if (!origin || !trimmed(rest).empty()) throw field.unexpected("a vector like (0,0,0)");
  header.origin = *origin;
}

void read_space_dimension(NrrdHeader&, const Field& field) {
  if (field.value != "3") throw field.unexpected("3");
}

void read_centers(NrrdHeader& header, const Field& field) {
  const std::vector<std::string_view> words = words_of_axes(header, field);
  for (std::size_t a = 0; a < words.size(); ++a) header.axes[a].cell_centered = words[a] == "cell";
}

void read_endian(NrrdHeader& header, const Field& field) {
  const std::string word = lower_case(field.value);
  if (word != "big" && word != "little") throw field.unexpected("little or big");
  header.big_endian = word == "big";
}

void read_line_skip(NrrdHeader& header, const Field& field) {
  const auto skip = to_number<std::int64_t>(field.value);
  if (!skip || *skip < 0) throw field.unexpected("a whole number from 0 on");
  header.line_skip = *skip;
}

void read_byte_skip(NrrdHeader& header, const Field& field) {
  const auto skip = to_number<std::int64_t>(field.value);
  if (!skip || *skip < -1) throw field.unexpected("a whole number from -1 on");
  header.byte_skip = *skip;
}

using Handler = void (*)(NrrdHeader&, const Field&);
const std::map<std::string_view, Handler> kHandlers = {
    {"dimension", read_dimension},
    {"sizes", read_sizes},
    {"type", [](NrrdHeader& header, const Field& field) { header.type = field.value; }},
    {"encoding", [](NrrdHeader& header, const Field& field) { header.encoding = lower_case(field.value); }},
    {"endian", read_endian},
    {"spacings",
     [](NrrdHeader& header, const Field& field) { read_axis_numbers(header, field, &NrrdAxis::spacing); }},
    {"axismins",
     [](NrrdHeader& header, const Field& field) { read_axis_numbers(header, field, &NrrdAxis::min); }},
    {"axismaxs",
     [](NrrdHeader& header, const Field& field) { read_axis_numbers(header, field, &NrrdAxis::max); }},
    {"centers", read_centers},
    {"centerings", read_centers},
    {"spacedimension", read_space_dimension},
    {"spacedirections", read_directions},
    {"spaceorigin", read_origin},
    {"lineskip", read_line_skip},
    {"byteskip", read_byte_skip},
    {"datafile", [](NrrdHeader& header, const Field& field) { header.data_file = field.value; }},
};

void read_key(NrrdHeader& header, const std::filesystem::path& path, int line, std::string_view key,
              std::string_view value) {
  if (key != "isocast_slope" && key != "isocast_intercept") return;
  const std::optional<double> number = to_number<double>(trimmed(value));
  if (!number)
    throw read_error(path, fmt::format("line {}: key '{}' has the value {}, expected a number", line, key,
                                       in_quotes(value)));
  (key == "isocast_slope" ? header.slope : header.intercept) = *number;
}

void read_line(NrrdHeader& header, const std::filesystem::path& path, int line, std::string_view text) {
  if (text.starts_with('#')) return;

  // "field: value" or "key:=value", whichever colon comes first
  const std::size_t colon = text.find(':');
  if (colon == text.npos)
    throw read_error(path, fmt::format("line {}: found {}, expected 'field: value', 'key:=value' or '#'",
                                       line, in_quotes(text)));
  if (text.substr(colon).starts_with(":="))
    return read_key(header, path, line, text.substr(0, colon), text.substr(colon + 2));

  Field field{path, line, lower_case(text.substr(0, colon)), trimmed(text.substr(colon + 1))};
  std::erase(field.name, ' ');
  const auto handler = kHandlers.find(field.name);
  if (handler == kHandlers.end()) return;
  constexpr std::size_t kLongest = 4096;
  if (text.size() > kLongest)
    throw field.error(fmt::format("field '{}' is longer than {} characters", field.name, kLongest));
  handler->second(header, field);
}

}  // namespace

NrrdHeader parse_nrrd_header(std::string_view text, const std::filesystem::path& path) {
  NrrdHeader header;
  for (int line = 1; header.bytes < text.size() && !header.ended; ++line) {
    const std::size_t end = std::min(text.find('\n', header.bytes), text.size());
    std::string_view content = text.substr(header.bytes, end - header.bytes);
    header.bytes = std::min(end + 1, text.size());
    if (content.ends_with('\r')) content.remove_suffix(1);

    // the magic, then fields up to the first empty line
    if (line == 1 &&
        !(content.size() == 8 && content.starts_with("NRRD000") && content[7] >= '1' && content[7] <= '5'))
      throw read_error(path, fmt::format("it starts with {}, expected the magic NRRD0001 to NRRD0005",
                                         in_quotes(content)));
    if (content.empty()) header.ended = true;
    else if (line > 1) read_line(header, path, line, content);
  }
  if (header.bytes == 0) throw read_error(path, "it is empty, expected a NRRD header");

  // what no reader can do without
  for (const auto& [name, missing] :
       {std::pair("dimension", header.axes.empty()), std::pair("type", header.type.empty()),
        std::pair("encoding", header.encoding.empty()),
        std::pair("sizes", !header.axes.empty() && header.axes[0].size == 0)})
    if (missing) throw read_error(path, fmt::format("its header has no field '{}'", name));
  return header;
}

}  // namespace isocast
