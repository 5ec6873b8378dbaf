#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/header_text.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace isocast {

InputError read_error(const std::filesystem::path& path, const std::string& what) {
  return InputError(fmt::format("cannot read {}: {}", path.string(), what));
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  return first == text.npos ? std::string_view{}
                            : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::vector<std::string_view> split_words(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  std::size_t end = 0;
  for (std::size_t begin = text.find_first_not_of(separators); begin != text.npos;
       begin = text.find_first_not_of(separators, end)) {
    end = std::min(text.find_first_of(separators, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
  }
  return words;
}

std::filesystem::path data_file_beside(const std::filesystem::path& header, std::string_view name) {
  if (name == "LIST" || name.starts_with("LIST ") || name.find('%') != name.npos)
    throw read_error(header,
                     "its samples lie in several files (" + in_quotes(name) + "), expected one data file");
  if (std::ranges::any_of(name, [](unsigned char c) { return std::iscntrl(c); }))
    throw read_error(
        header, "its samples lie in " + in_quotes(name) + ", expected a name without control characters");
  return header.parent_path() / name;
}

template <class N> std::optional<N> to_number(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  N value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

template <class N> std::optional<std::vector<N>> to_numbers(std::string_view text, std::size_t count) {
  const std::vector<std::string_view> words = split_words(text);
  if (words.size() != count) return std::nullopt;
  std::vector<N> numbers;
  for (const std::string_view word : words) {
    const std::optional<N> number = to_number<N>(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

template std::optional<std::int64_t> to_number(std::string_view);
template std::optional<std::uint64_t> to_number(std::string_view);
template std::optional<double> to_number(std::string_view);
template std::optional<std::vector<std::int64_t>> to_numbers(std::string_view, std::size_t);
template std::optional<std::vector<double>> to_numbers(std::string_view, std::size_t);

}  // namespace isocast
