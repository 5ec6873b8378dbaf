// MetaImage: types, encodings, where the data lies, the affine, and headers that lie.
#include "volume_files.h"

using namespace isocast;
using namespace isocast::test;
using Catch::Contains;

namespace {

const std::string kSamples("\0\1\2\3\4\5\6\7", 8);
const std::vector<std::uint8_t> kExpected = {0, 1, 2, 3, 4, 5, 6, 7};
const std::string kHeader =
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 2 2 2\nElementType = MET_UCHAR\n";
// A whole .mha.
const std::string kPlain = kHeader + "ElementDataFile = LOCAL\n" + kSamples;

// world_from_grid of a header with these lines, read through a file.
Transform world_of(const TemporaryFolder& folder, const std::string& lines) {
  return read_volume(folder.write("w.mha", replaced(kPlain, "ElementType", lines + "ElementType")))
      .world_from_grid;
}

void check_rows(const Transform& t, const std::array<std::array<double, 4>, 3>& rows) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      INFO("row " << r << " column " << c);
      CHECK(t.m[r][c] == rows[r][c]);
    }
}

}  // namespace

TEMPLATE_TEST_CASE("a .mha is read in every type, byte order and encoding", "[io][metaimage]",
                   ISO_FILE_SAMPLE_TYPES) {
  const TemporaryFolder folder;
  const std::vector<TestType> values = pattern<TestType>(3 * 2 * 5);
  const bool big_endian = GENERATE(false, true), compressed = GENERATE(false, true);
  const char* const names[] = {"UCHAR", "CHAR", "USHORT", "SHORT", "UINT", "INT", "", "FLOAT", "DOUBLE"};
  const char* const order = GENERATE("BinaryDataByteOrderMSB", "ElementByteOrderMSB");
  const std::string data = bytes_of(values, big_endian), packed = zlib(data);
  std::string header = std::string("NDims = 3\nDimSize = 3 2 5\nElementType = MET_") +
                       names[int(kTypeOf<TestType>)] + "\n" + order + " = " +
                       (big_endian ? "True" : "False") + "\nUnknown = x\n";
  if (compressed)
    header += "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n";
  header += "Comment = ";
  const std::string end = "\nElementDataFile = LOCAL\n";
  header += std::string(8 - (header.size() + end.size()) % 8, '.') + end;
  const Volume volume =
      read_volume(folder.write("v.mha", header + (compressed ? packed + "what follows" : data)));
  CHECK(volume.type == kTypeOf<TestType>);
  CHECK(volume.dims == std::array<std::int64_t, 3>{3, 2, 5});
  CHECK(samples_of<TestType>(volume) == values);
  CHECK(volume.mapped == (!compressed && (!big_endian || sizeof(TestType) == 1)));
  CHECK(volume.format == "metaimage");
}

TEST_CASE("MET_LONG has 32 bits, as MetaIO writes it", "[io][metaimage]") {
  const TemporaryFolder folder;
  const std::string header = "NDims = 3\nDimSize = 2 1 1\nElementType = MET_LONG\nElementDataFile = LOCAL\n";
  CHECK(samples_of<std::int32_t>(
            read_volume(folder.write("v.mha", header + bytes_of(std::vector<std::int32_t>{-5, 7})))) ==
        std::vector<std::int32_t>{-5, 7});
}

TEST_CASE("data files, HeaderSize, line ends and streams of unknown size", "[io][metaimage]") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& lines) {
    return samples_of<std::uint8_t>(read_volume(folder.write("h.mhd", kHeader + lines)));
  };
  folder.write("plain.raw", kSamples);
  CHECK(read("\nElementDataFile = plain.raw") == kExpected);
  CHECK(read("ElementDataFile:plain.raw \r\nwhatever follows") == kExpected);
  CHECK(read("ElementDataFile = " + (folder.path() / "plain.raw").string()) == kExpected);
  folder.write("late.raw", "0123456789" + kSamples + "z");
  CHECK(read("HeaderSize = 10\nElementDataFile = late.raw") == kExpected);
  folder.write("end.raw", "a header of unknown length" + kSamples);
  CHECK(read("HeaderSize = -1\nElementDataFile = end.raw") == kExpected);
  CHECK(read("HeaderSize = -1\nElementDataFile = LOCAL\n.." + kSamples) == kExpected);
  CHECK(read("HeaderSize = 200\nElementDataFile = LOCAL\n" + std::string(200 - kHeader.size() - 41, ' ') +
             kSamples) == kExpected);
  CHECK(read("CompressedData = True\nElementDataFile = LOCAL\r\n" + zlib(kSamples)) == kExpected);
  folder.write("late.zraw", "1234" + zlib(kSamples));
  CHECK(read("CompressedData = True\nCompressedDataSize = 0\nHeaderSize = 4\nElementDataFile = late.zraw") ==
        kExpected);
}

TEST_CASE("a fourth dimension of 1 is dropped", "[io][metaimage]") {
  const TemporaryFolder folder;
  const std::string four = replaced(replaced(kPlain, "NDims = 3", "NDims = 4"), "2 2 2\n",
                                    "2 2 2 1\nTransformMatrix = 0 1 0 0 1 0 0 0 0 0 1 0 0 0 0 1\n"
                                    "Offset = 5 6 7 8\nElementSpacing = 2 3 4 9\n");
  const Volume volume = read_volume(folder.write("v.mha", four));
  CHECK(volume.dims == std::array<std::int64_t, 3>{2, 2, 2});
  check_rows(volume.world_from_grid, {{{0, 3, 0, 5}, {2, 0, 0, 6}, {0, 0, 4, 7}}});
  CHECK_THAT(error_of(folder.write("v.mha", replaced(four, "2 2 2 1", "2 2 1 2"))),
             Contains("line 4") && Contains("a fourth dimension of 1"));
}

TEST_CASE("row i of the matrix is the direction of axis i", "[io][metaimage]") {
  const TemporaryFolder folder;
  check_rows(world_of(folder, ""), {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  const char* const matrix = GENERATE("TransformMatrix", "Rotation", "Orientation");
  const char* const offset = GENERATE("Offset", "Position", "Origin");
  const Transform left_handed =
      world_of(folder, std::string(matrix) + " = 0 0 1 -1 0 0 0 1 0\n" + offset + " = 10 20 -30.5\n" +
                           "ElementSpacing = 2 3 0.5\nElementSize = 9 9 9\n");
  check_rows(left_handed, {{{0, -3, 0, 10}, {0, 0, 0.5, 20}, {2, 0, 0, -30.5}}});
  CHECK(left_handed.determinant() < 0);
  check_rows(world_of(folder, "ElementSize = 2 3 4\n"), {{{2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 0}}});
}

TEST_CASE("slope and offset scale the values", "[io][metaimage]") {
  const TemporaryFolder folder;
  const Volume volume = read_volume(folder.write(
      "v.mha", replaced(kPlain, "ElementType",
                        "ElementToIntensityFunctionSlope = 0.25\nElementToIntensityFunctionOffset = -3\n"
                        "ElementType")));
  CHECK(volume.slope == 0.25);
  CHECK(volume.intercept == -3);
}

TEST_CASE("bad MetaImage headers are told with their line", "[io][metaimage]") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& from, const std::string& to) {
    return error_of(folder.write("bad.mha", replaced(kPlain, from, to)));
  };
  CHECK_THAT(message("ObjectType = Image", "just text"), Contains("line 1: found 'just text', expected"));
  CHECK_THAT(message("= Image", "= Tube"), Contains("line 1") && Contains("'Tube', expected Image"));
  CHECK_THAT(message("NDims = 3\n", ""), Contains("no field 'NDims'"));
  CHECK_THAT(message("DimSize = 2 2 2\n", ""), Contains("no field 'DimSize'"));
  CHECK_THAT(message("ElementType = MET_UCHAR\n", ""), Contains("no field 'ElementType'"));
  CHECK_THAT(message("ElementDataFile", "Elementdatafile"), Contains("bad.mha"));
  CHECK_THAT(error_of(folder.write("short.mha", kHeader)), Contains("no field 'ElementDataFile'"));
  CHECK_THAT(message("NDims = 3", "NDims = 2"), Contains("line 2") && Contains("'2', expected 3, or 4"));
  CHECK_THAT(message("True", "False"), Contains("line 3: field 'BinaryData'") && Contains("expected True"));
  CHECK_THAT(message("True", "maybe"), Contains("'maybe', expected True or False"));
  CHECK_THAT(message("2 2 2", "2 2"), Contains("line 4") && Contains("expected 3 whole numbers"));
  CHECK_THAT(message("2 2 2", "2 0 2"), Contains("expected 3 whole numbers from 1 on"));
  CHECK_THAT(message("2 2 2", "2 99999999999999999999 2"), Contains("expected 3 whole numbers"));
  CHECK_THAT(message("2 2 2", "1073741824 1073741824 1073741824"),
             Contains("more than 64-bit sizes can count"));
  CHECK_THAT(message("2 2 2", "4294967296 1 1"), Contains("expected dimensions between 1 and"));
  CHECK_THAT(message("2 2 2", "2 2 3"), Contains("expected 12 bytes") && Contains("found 8"));
  CHECK_THAT(message("MET_UCHAR", "uchar"), Contains("'uchar', expected a type like MET_SHORT"));
  CHECK_THAT(message("MET_UCHAR", "MET_LONG_LONG"), Contains("is not possible") && Contains("f64"));
  CHECK_THAT(message("MET_UCHAR", "MET_STRING"), Contains("unknown sample type 'MET_STRING'"));
  CHECK_THAT(message("LOCAL", "LIST"), Contains("several files ('LIST'), expected one data file"));
  CHECK_THAT(message("LOCAL", "a%03d.raw 1 9 1"), Contains("several files"));
  CHECK_THAT(message("LOCAL", "missing.raw"), Contains("missing.raw: No such file"));

  // fields that are put in
  const auto with = [&](const std::string& line) { return message("ElementType", line + "\nElementType"); };
  CHECK_THAT(with("ElementNumberOfChannels = 3"), Contains("line 5") && Contains("'3', expected 1"));
  CHECK_THAT(with("HeaderSize = -2"), Contains("expected a whole number from -1 on"));
  CHECK_THAT(with("HeaderSize = 9223372036854775807"), Contains("found 0"));
  CHECK_THAT(with("CompressedData = True\nHeaderSize = -1"), Contains("0 or more for compressed data"));
  CHECK_THAT(with("CompressedData = True"), Contains("damaged"));
  CHECK_THAT(with("CompressedData = True\nHeaderSize = 9223372036854775807"), Contains("found 0"));
  CHECK_THAT(with("CompressedData = True\nCompressedDataSize = 9"),
             Contains("expected 9 bytes of compressed data, found 8"));
  CHECK_THAT(with("TransformMatrix = 1 0 0 1"), Contains("'1 0 0 1', expected 9 numbers"));
  CHECK_THAT(with("TransformMatrix = 1 0 0 0 1 0 1 1 0"), Contains("span no volume"));
  CHECK_THAT(with("ElementSpacing = 1 0 1"), Contains("span no volume"));
  CHECK_THAT(with("Offset = 0 nan 0"), Contains("not finite"));
  CHECK_THAT(with("ElementToIntensityFunctionSlope = 0"), Contains("slope other than 0"));
  CHECK_THAT(with("Offset = " + std::string(5000, '1')), Contains("longer than 4096 characters"));
}

TEST_CASE("compressed MetaImage data that lies is told", "[io][metaimage]") {
  const TemporaryFolder folder;
  const std::string header = kHeader + "CompressedData = True\nElementDataFile = LOCAL\n",
                    stream = zlib(kSamples);
  const auto message = [&](const std::string& content) { return error_of(folder.write("z.mha", content)); };
  CHECK(message(header + stream).empty());
  CHECK_THAT(message(header + stream.substr(0, stream.size() - 6)), Contains("expected 8 bytes"));
  CHECK_THAT(message(header + zlib(kSamples.substr(1))), Contains("expected 8 bytes") && Contains("found 7"));
  CHECK_THAT(message(header + stream.substr(0, stream.size() - 4) + "1234"),
             Contains("incorrect data check"));
  CHECK_THAT(message(replaced(header, "2 2 2", "1000 1000 200") + stream), Contains("found 8"));
  CHECK_THAT(message(replaced(header, "2 2 2", "1000 1000 201") + stream),
             Contains("expected 201000000 bytes") && Contains("at most 200 times as much"));
}
