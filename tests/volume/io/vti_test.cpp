// VTI: types, the formats of a data array, the affine, and files that lie.
#include "volume_files.h"

using namespace isocast;
using namespace isocast::test;
using Catch::Contains;

namespace {

std::string base64(const std::string& plain) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < plain.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b)
      group = group << 8 | (i + b < plain.size() ? std::uint8_t(plain[i + b]) : 0u);
    for (std::size_t d = 0; d < 4; ++d)
      text += i + d > plain.size() ? '=' : kDigits[group >> (18 - 6 * d) & 63];
  }
  return text;
}

// How a file is written; `array` replaces its data array's attributes and content.
struct VtiFile {
  std::string type = "UInt8", extent = "0 2 0 1 0 3", format = "appended";
  bool big_endian = false, wide = false, compressed = false, raw = true;
  std::string image = R"(Origin="0 0 0" Spacing="1 1 1")", points = R"(Scalars="s")", before, piece_end;

  [[nodiscard]] std::string word(std::uint64_t v) const {
    return wide ? bytes_of(v, big_endian) : bytes_of(std::uint32_t(v), big_endian);
  }
  // The words before the samples and the samples, in zlib blocks of 10 bytes if compressed.
  [[nodiscard]] std::pair<std::string, std::string> payload(const std::string& data) const {
    if (!compressed) return {word(data.size()), data};
    constexpr std::size_t kBlock = 10;
    std::string sizes, blocks;
    std::size_t count = 0;
    for (std::size_t i = 0; i < data.size(); i += kBlock, ++count) {
      const std::string block = zlib(data.substr(i, kBlock));
      sizes += word(block.size());
      blocks += block;
    }
    return {word(count) + word(kBlock) + word(data.size() % kBlock) + sizes, blocks};
  }
  [[nodiscard]] std::string around(const std::string& attributes, const std::string& content,
                                   const std::string& appended) const {
    return std::string(R"(<?xml version="1.0"?><VTKFile type="ImageData" version="1.0" byte_order=")") +
           (big_endian ? "BigEndian" : "LittleEndian") + R"(" header_type=")" + (wide ? "UInt64" : "UInt32") +
           "\"" + (compressed ? R"( compressor="vtkZLibDataCompressor")" : "") +
           "><ImageData WholeExtent=\"" + extent + "\" " + image + "><Piece Extent=\"" + extent +
           "\"><PointData " + points + ">" + before + "<DataArray type=\"" + type + "\" Name=\"s\" " +
           attributes + ">" + content + "</DataArray></PointData><CellData/></Piece>" + piece_end +
           "</ImageData>" + appended + "</VTKFile>";
  }
  // `shift` bytes stand between the underscore and the array.
  [[nodiscard]] std::string text(const std::string& data, std::size_t shift = 0) const {
    const auto [head, body] = payload(data);
    const std::string encoded = compressed ? base64(head) + base64(body) : base64(head + body);
    if (format == "binary") return around(R"(format="binary")", "\n" + encoded + "\n", "");
    return around("format=\"appended\" offset=\"" + std::to_string(shift) + "\"", "",
                  std::string("<AppendedData encoding=\"") + (raw ? "raw" : "base64") + "\">\n  _" +
                      std::string(shift, 'A') + (raw ? head + body : encoded) + "\n</AppendedData>");
  }
};

template <class S> std::string vti_type() {
  const std::string names[] = {"UInt8", "Int8", "UInt16",  "Int16",  "UInt32",
                               "Int32", "",     "Float32", "Float64"};
  return names[int(kTypeOf<S>)];
}

const std::string kBytes = [] {
  std::string bytes;
  for (int i = 0; i < 24; ++i) bytes += static_cast<char>(i);
  return bytes;
}();

std::string ascii(const std::string& numbers, VtiFile file = {}) {
  return file.around(R"(format="ascii")", numbers, "");
}

}  // namespace

TEMPLATE_TEST_CASE("a .vti is read in every type, format and byte order", "[io][vti]",
                   ISO_FILE_SAMPLE_TYPES) {
  const TemporaryFolder folder;
  const std::vector<TestType> values = pattern<TestType>(3 * 2 * 4);
  VtiFile file;
  file.type = vti_type<TestType>();
  file.big_endian = GENERATE(false, true);
  file.wide = GENERATE(false, true);
  file.compressed = GENERATE(false, true);
  const int kind = GENERATE(0, 1, 2);
  if (kind == 1) file.raw = false;
  if (kind == 2) file.format = "binary";
  const Volume volume = read_volume(folder.write("v.vti", file.text(bytes_of(values, file.big_endian))));
  CHECK(volume.type == kTypeOf<TestType>);
  CHECK(volume.dims == std::array<std::int64_t, 3>{3, 2, 4});
  CHECK(volume.format == "vti");
  CHECK(samples_of<TestType>(volume) == values);
}

TEMPLATE_TEST_CASE("a .vti in ascii is read in every type", "[io][vti]", ISO_FILE_SAMPLE_TYPES) {
  const TemporaryFolder folder;
  const std::vector<TestType> values = pattern<TestType>(3 * 2 * 4);
  std::string numbers = "\n ";
  char word[64];
  for (const TestType v : values) {
    std::snprintf(word, sizeof word, "%.17g\t", double(v));
    numbers += word;
  }
  VtiFile file;
  file.type = vti_type<TestType>();
  CHECK(samples_of<TestType>(read_volume(folder.write("v.vti", ascii(numbers, file)))) == values);
}

TEST_CASE("appended raw samples are mapped where they are aligned", "[io][vti]") {
  const TemporaryFolder folder;
  VtiFile file;
  file.type = "Float32";
  file.extent = "0 1 0 0 0 0";
  int mapped = 0;
  for (std::size_t shift = 0; shift < 4; ++shift) {
    const Volume volume =
        read_volume(folder.write("v.vti", file.text(bytes_of(std::vector<float>{0.5f, 8}), shift)));
    CHECK(samples_of<float>(volume) == std::vector<float>{0.5f, 8});
    mapped += volume.mapped;
  }
  CHECK(mapped == 1);
}

TEST_CASE("origin, spacing, direction and extent make the affine", "[io][vti]") {
  const TemporaryFolder folder;
  VtiFile file;
  file.extent = "10 12 -5 -4 0 3";
  file.image = R"(Origin="1 2 3" Spacing="0.5 2 -4" Direction="0 1 0  0 0 -1  1 0 0")";
  const Transform t = read_volume(folder.write("v.vti", file.text(kBytes))).world_from_grid;
  const double rows[3][4] = {{0, 2, 0, 1 - 10}, {0, 0, 4, 2}, {0.5, 0, 0, 3 + 5}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) CHECK(t.m[r][c] == rows[r][c]);
  CHECK(t.determinant() == 4);

  file = {};
  file.image = R"(Direction="-1 0 0 0 1 0 0 0 1")";
  CHECK(read_volume(folder.write("v.vti", file.text(kBytes))).world_from_grid.determinant() == -1);
}

TEST_CASE("the active scalars are read, else the first array of one component", "[io][vti]") {
  const TemporaryFolder folder;
  VtiFile file;
  const std::string other =
      R"(<DataArray type="Int16" Name="a" NumberOfComponents="3" format="ascii">1</DataArray>)"
      R"(<DataArray type="Float32" Name="b" NumberOfComponents="1" format="ascii">)" +
      std::string(48, '1') + "</DataArray>";
  file.before = other;
  CHECK(read_volume(folder.write("v.vti", file.text(kBytes))).type == SampleType::u8);
  file.points = "";
  CHECK_THAT(error_of(folder.write("v.vti", file.text(kBytes))),
             Contains("found 1"));  // of "b", which comes first
  file.before =
      replaced(other, std::string(48, '1'), "1 2 3 4 5 6 7 8 9 10 11 12 1 2 3 4 5 6 7 8 9 10 11 12.5");
  CHECK(samples_of<float>(read_volume(folder.write("v.vti", file.text(kBytes)))).back() == 12.5f);
  file.points = R"(Scalars="a")";
  CHECK_THAT(error_of(folder.write("v.vti", file.text(kBytes))),
             Contains("'a' has 3 components, expected scalars"));
  file.points = R"(Scalars="z")";
  CHECK_THAT(error_of(folder.write("v.vti", file.text(kBytes))), Contains("no array 'z'"));
}

TEST_CASE("bad VTI elements and attributes are told", "[io][vti]") {
  const TemporaryFolder folder;
  const std::string good = VtiFile{}.text(kBytes);
  const auto message = [&](const std::string& from, const std::string& to) {
    return error_of(folder.write("bad.vti", replaced(good, from, to)));
  };
  CHECK(message("s", "s").empty());
  CHECK_THAT(message("<ImageData", "<UnstructuredGrid"), Contains("XML is damaged"));
  CHECK_THAT(error_of(folder.write("a.vti", "<VTKFile><PolyData/></VTKFile>")),
             Contains("no element ImageData"));
  CHECK_THAT(error_of(folder.write("a.vti", "no xml at all")),
             Contains("XML is damaged") || Contains("no element ImageData"));
  CHECK_THAT(error_of(folder.write("a.vti", "  \n")), Contains("it is empty"));
  CHECK_THAT(error_of(folder.write("a.vti", good.substr(0, 200))), Contains("XML is damaged at byte"));
  std::string many = "<VTKFile>";
  while (many.size() < 4'100'000) many += "<a/>";
  CHECK_THAT(error_of(folder.write("a.vti", many)),
             Contains("elements and attributes, expected at most 1000000"));
  CHECK_THAT(message("<Piece Extent=\"0 2 0 1 0 3\"", "<Piece Extent=\"0 2 0 1 0\""),
             Contains("attribute Extent of Piece is '0 2 0 1 0', expected 6 numbers"));
  CHECK_THAT(message("<Piece Extent=\"0 2", "<Piece Extent=\"3 2"), Contains("from 3 to 2 on axis 0"));
  CHECK_THAT(message("<Piece Extent=\"0 2", "<Piece Extent=\"-9223372036854775807 9223372036854775807"),
             Contains("on axis 0"));
  CHECK_THAT(message("<Piece Extent=\"0 2", "<Piece Extent=\"0 2147483647"),
             Contains("2147483648 x 2 x 4") && Contains("between 1 and"));
  CHECK_THAT(message("<Piece Extent=\"0 2 0 1 0 3", "<Piece Extent=\"0 1073741823 0 1073741823 0 1073741823"),
             Contains("more than 64-bit"));
  CHECK_THAT(message("<Piece Extent=\"0 2", "<Piece Extent=\"0 999999999"),
             Contains("expected 8000000000 bytes") && Contains("found 24"));
  CHECK_THAT(message("Spacing=\"1 1 1\"", "Spacing=\"1 x 1\""),
             Contains("attribute Spacing of ImageData is '1 x 1'"));
  CHECK_THAT(message("Spacing=\"1 1 1\"", "Spacing=\"1 0 1\""), Contains("span no volume"));
  CHECK_THAT(message("Spacing=\"1 1 1\"", "Spacing=\"1 nan 1\""), Contains("not finite"));
  CHECK_THAT(message("</Piece>", "</Piece><Piece/>"), Contains("exactly one element Piece"));
  CHECK_THAT(message("UInt8\"", "Int64\""), Contains("'Int64' is not possible") && Contains("f64"));
  CHECK_THAT(message("UInt8\"", "String\""), Contains("unknown sample type 'String'"));
  CHECK_THAT(message("UInt8\"", "half\""), Contains("nearest that is possible is f32"));
  CHECK_THAT(message("UInt32\"", "UInt16\""),
             Contains("attribute header_type of VTKFile is 'UInt16', expected UInt32 or UInt64"));
  CHECK_THAT(message("LittleEndian", "Middle"), Contains("byte_order"));
  CHECK_THAT(message(" byte_order", " compressor=\"vtkLZ4DataCompressor\" byte_order"),
             Contains("'vtkLZ4DataCompressor' is not supported"));
  CHECK_THAT(message("\"appended\"", "\"other\""), Contains("expected ascii, binary or appended"));
  CHECK_THAT(message("offset=\"0\"", "offset=\"-1\""), Contains("attribute offset of DataArray is '-1'"));
  CHECK_THAT(message("offset=\"0\"", "offset=\"99999\""), Contains("expected a number up to"));
  CHECK_THAT(message("encoding=\"raw\"", "encoding=\"hex\""), Contains("'hex', expected base64 or raw"));
  CHECK_THAT(message("  _", "  "), Contains("underscore"));
  CHECK_THAT(error_of(folder.write("a.vti", good.substr(0, good.find("encoding=")))),
             Contains("AppendedData is cut short"));
  CHECK_THAT(error_of(folder.write("a.vti", VtiFile{}.around(R"(format="appended" offset="0")", "", ""))),
             Contains("no element AppendedData"));
  CHECK_THAT(error_of(folder.write("a.vti", replaced(replaced(good, "<PointData", "<CellData"),
                                                     "</PointData><CellData/>", "</CellData>"))),
             Contains("data for cells only"));
  CHECK_THAT(error_of(folder.write("a.vti",
                                   replaced(good,
                                            good.substr(good.find("<DataArray"),
                                                        good.find("</PointData>") - good.find("<DataArray")),
                                            ""))),
             Contains("no array of point data"));
}

TEST_CASE("bad VTI data is told", "[io][vti]") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& content) { return error_of(folder.write("bad.vti", content)); };
  VtiFile plain, packed, text;
  packed.compressed = true;
  text.format = "binary";

  // plain
  CHECK_THAT(message(plain.text(kBytes.substr(1))),
             Contains("expected 24 bytes for 3 x 2 x 4 samples of type u8, found 23"));
  const std::string raw = plain.text(kBytes);
  CHECK_THAT(message(raw.substr(0, raw.find("  _") + 12)),
             Contains("expected 24 bytes") && Contains("found 5"));
  CHECK_THAT(message(raw.substr(0, raw.find("  _") + 5)), Contains("ends inside its header"));

  // zlib blocks: the words of the header are count, size, size of the last, sizes
  const std::string good = packed.text(kBytes);
  const std::size_t words = good.find("  _") + 3;
  const auto with_word = [&](std::size_t i, std::uint32_t value) {
    return message(std::string(good).replace(words + 4 * i, 4, bytes_of(value)));
  };
  CHECK(message(good).empty());
  CHECK_THAT(with_word(0, 2), Contains("expected 24 bytes") && Contains("found 20"));
  CHECK_THAT(with_word(0, 0xffffffff), Contains("ends inside its header of 4294967298 words"));
  CHECK_THAT(with_word(1, 0), Contains("found 0"));
  CHECK_THAT(with_word(1, 9), Contains("bad.vti"));
  CHECK_THAT(with_word(1, 12), Contains("block 0 of the data array holds 10 bytes, expected 12") ||
                                   Contains("block 1 of the data array holds 10 bytes, expected 12"));
  CHECK_THAT(with_word(3, 0xffffffff), Contains("bytes of compressed data, found"));
  CHECK_THAT(with_word(4, 0), Contains("block 1"));
  CHECK_THAT(message(std::string(good).replace(words + 4 * 6 + 4, 3, "abc")), Contains("damaged"));
  VtiFile large = packed;
  large.extent = "0 9999 0 9999 0 999";
  CHECK_THAT(message(large.text(kBytes)), Contains("expected 100000000000 bytes"));
  std::string one_block = large.text(std::string(10, 'x'));
  one_block.replace(one_block.find("  _") + 3 + 4, 4, bytes_of(std::uint32_t(0xffffffff)));
  one_block =
      replaced(one_block, "<Piece Extent=\"0 9999 0 9999 0 999\"", "<Piece Extent=\"0 999 0 999 0 999\"");
  CHECK_THAT(message(one_block), Contains("expected 1000000000 bytes") && Contains("at most 200 times"));

  // base64
  const std::string encoded = text.text(kBytes), digits = encoded.substr(encoded.find('\n') + 1, 40);
  CHECK(message(encoded).empty());
  CHECK_THAT(message(replaced(encoded, digits.substr(8, 4), "ab!d")),
             Contains("base64") && Contains("unexpected '!'"));
  CHECK_THAT(message(replaced(encoded, digits.substr(8, 4), "=abc")), Contains("misplaced padding"));
  CHECK_THAT(message(replaced(encoded, digits.substr(8, 4), "ab=c")), Contains("misplaced padding"));
  CHECK_THAT(message(replaced(encoded, digits, digits.substr(0, 21))), Contains("cut short"));
  CHECK_THAT(message(replaced(encoded, digits, digits.substr(0, 20))),
             Contains("expected 24 bytes") && Contains("found 11"));

  // numbers
  CHECK_THAT(message(ascii("1 2 3")), Contains("expected 24 numbers") && Contains("found at most 3"));
  CHECK_THAT(message(ascii("1 2 3 " + std::string(60, ' '))), Contains("expected 24 numbers"));
  CHECK_THAT(message(ascii("1 2 300" + std::string(60, '1'))),
             Contains("number 2 of the data array is '300111") && Contains("expected one of type u8"));
  CHECK_THAT(message(ascii("1 x" + std::string(60, '1'))), Contains("number 1 of the data array is 'x111"));
}
