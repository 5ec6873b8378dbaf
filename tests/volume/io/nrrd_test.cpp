// NRRD: types, encodings, axes, and headers that lie.
#include "volume_files.h"

using namespace isocast;
using namespace isocast::test;
using Catch::Contains;

namespace {

const std::string kMagic = "NRRD0004\n";
// A whole file of 2 x 2 x 2 bytes, 0 to 7.
const std::string kPlain = kMagic + "type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n" +
                           std::string("\0\1\2\3\4\5\6\7", 8);

// What Transform of a header with these lines is, read through a file.
Transform world_of(const TemporaryFolder& folder, const std::string& lines) {
  return read_volume(folder.write("w.nrrd", replaced(kPlain, "encoding", lines + "encoding")))
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

TEMPLATE_TEST_CASE("a .nrrd is read in every type, byte order and encoding", "[io][nrrd]",
                   ISO_FILE_SAMPLE_TYPES) {
  const TemporaryFolder folder;
  const std::vector<TestType> values = pattern<TestType>(3 * 2 * 5);
  const bool big_endian = GENERATE(false, true), compressed = GENERATE(false, true);
  const char* const names[] = {
      "unsigned char", "int8_t", "ushort", "signed short int", "unsigned int", "int", "", "float", "double"};
  std::string header =
      kMagic + "# a comment\ntype: " + names[int(kTypeOf<TestType>)] +
      "\ndimension: 3\nsizes: 3 2 5\nsome key:=some value: here\nunknown field: x\nendian: " +
      (big_endian ? "big" : "little") + "\nencoding: " + (compressed ? "gzip" : "raw") + "\n";
  header += std::string(9 - (header.size() + 3) % 8, '#') + "\n";  // so that samples are aligned
  const std::string data = bytes_of(values, big_endian);
  const Volume volume = read_volume(folder.write("v.nrrd", header + "\n" + (compressed ? gzip(data) : data)));
  CHECK(volume.type == kTypeOf<TestType>);
  CHECK(volume.dims == std::array<std::int64_t, 3>{3, 2, 5});
  CHECK(samples_of<TestType>(volume) == values);
  CHECK(volume.mapped == (!compressed && (!big_endian || sizeof(TestType) == 1)));
  CHECK(volume.format == "nrrd");
}

TEST_CASE("samples that are not aligned in the file are copied", "[io][nrrd]") {
  const TemporaryFolder folder;
  for (int shift = 0; shift < 4; ++shift) {
    const std::string header = kMagic + "#" + std::string(shift, '#') +
                               "\ntype: float\ndimension: 3\nsizes: 2 1 1\nendian: little\nencoding: raw\n\n";
    const Volume volume =
        read_volume(folder.write("v.nrrd", header + bytes_of(std::vector<float>{1.5f, -2})));
    CHECK(samples_of<float>(volume) == std::vector<float>{1.5f, -2});
    CHECK(volume.mapped == (header.size() % 4 == 0));
  }
}

TEST_CASE("detached headers, skips and line ends", "[io][nrrd]") {
  const TemporaryFolder folder;
  const std::string samples("\0\1\2\3\4\5\6\7", 8),
      fields = "type: uint8\r\ndimension: 3\r\nsizes: 2 2 2\r\n";
  const auto read = [&](const std::string& lines) {
    return samples_of<std::uint8_t>(read_volume(folder.write("h.nhdr", kMagic + fields + lines)));
  };
  const std::vector<std::uint8_t> expected = {0, 1, 2, 3, 4, 5, 6, 7};
  folder.write("plain.raw", samples);
  CHECK(read("encoding: raw\r\ndata file: plain.raw\r\n") == expected);
  folder.write("skip.raw", "line\nother\nxyz" + samples + "z");
  CHECK(read("encoding: raw\nline skip: 2\nbyte skip: 3\ndatafile: skip.raw\n\n") == expected);
  folder.write("end.raw", "a\nheader of unknown length" + samples);
  CHECK(read("encoding: raw\nbyte skip: -1\ndata file: end.raw") == expected);
  folder.write("lines.gz", "line\n" + gzip("abc" + samples));
  CHECK(read("encoding: gzip\nlineskip: 1\nbyteskip: 3\ndata file: lines.gz") == expected);
  folder.write("members.gz", gzip(samples.substr(0, 5)) + gzip(samples.substr(5)));
  CHECK(read("encoding: gz\ndata file: members.gz") == expected);
}

TEST_CASE("a fourth axis of size 1 is dropped, wherever it is", "[io][nrrd]") {
  const TemporaryFolder folder;
  const auto dims_of = [&](const std::string& sizes, const std::string& more = "") {
    return read_volume(folder.write("v.nrrd", replaced(replaced(kPlain, "3\nsizes: 2 2 2\n",
                                                                "4\nsizes: " + sizes + "\n"),
                                                       "encoding", more + "encoding")))
        .dims;
  };
  using Dims = std::array<std::int64_t, 3>;
  CHECK(dims_of("1 4 2 1") == Dims{1, 4, 2});
  CHECK(dims_of("1 4 2 1", "space directions: none (1,0,0) (0,1,0) (0,0,1)\n") == Dims{4, 2, 1});
  CHECK(dims_of("1 2 4 1", "space directions: (1,0,0) (0,1,0) (0,0,1) none\n") == Dims{1, 2, 4});
  CHECK(dims_of("1 2 2 2") == Dims{2, 2, 2});
  CHECK_THAT(error_of(folder.write("w.nrrd", replaced(kPlain, "3\nsizes: 2 2 2", "4\nsizes: 2 1 2 2"))),
             Contains("2 1 2 2") && Contains("first or the last"));
}

TEST_CASE("space directions, origins, spacings and minima make the affine", "[io][nrrd]") {
  const TemporaryFolder folder;
  check_rows(world_of(folder, ""), {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  check_rows(world_of(folder,
                      "space: left-posterior-superior\nspace directions: (0,2,0) (0, 0, -3) (0.5,0,0)\nspace "
                      "origin: (10,20,-30.5)\n"),
             {{{0, 0, 0.5, 10}, {2, 0, 0, 20}, {0, -3, 0, -30.5}}});
  check_rows(world_of(folder, "spacings: 1.5 nan -2\naxis mins: 3 4 nan\n"),
             {{{1.5, 0, 0, 3}, {0, 1, 0, 4}, {0, 0, -2, 0}}});
  check_rows(world_of(folder, "spacings: 2 2 2\naxis mins: 0 0 0\ncenters: cell node ???\n"),
             {{{2, 0, 0, 1}, {0, 2, 0, 0}, {0, 0, 2, 0}}});
  check_rows(world_of(folder, "axismins: -1 -1 -1\naxismaxs: 1 3 5\ncenterings: cell node node\n"),
             {{{1, 0, 0, -0.5}, {0, 4, 0, -1}, {0, 0, 6, -1}}});
  CHECK(world_of(folder, "space directions: (-1,0,0) (0,1,0) (0,0,1)\n").determinant() == -1);
}

TEST_CASE("scaled values of our own files are read back", "[io][nrrd]") {
  const TemporaryFolder folder;
  const Volume volume = read_volume(
      folder.write("v.nrrd", replaced(kPlain, "\n\n", "\nisocast_slope:=0.25\nisocast_intercept:= -3\n\n")));
  CHECK(volume.slope == 0.25);
  CHECK(volume.intercept == -3);
  CHECK_THAT(error_of(folder.write("v.nrrd", replaced(kPlain, "\n\n", "\nisocast_slope:=0\n\n"))),
             Contains("slope other than 0"));
}

TEST_CASE("bad NRRD headers are told with their line", "[io][nrrd]") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& from, const std::string& to) {
    return error_of(folder.write("bad.nrrd", replaced(kPlain, from, to)));
  };
  CHECK_THAT(message("NRRD0004", "NRRD0009"),
             Contains("'NRRD0009'") && Contains("expected the magic NRRD0001"));
  CHECK_THAT(message("type: uchar", "just text"),
             Contains("line 2: found 'just text', expected 'field: value'"));
  CHECK_THAT(message("type: uchar\n", ""), Contains("no field 'type'"));
  CHECK_THAT(message("encoding: raw\n", ""), Contains("no field 'encoding'"));
  CHECK_THAT(message("sizes: 2 2 2\n", ""), Contains("no field 'sizes'"));
  CHECK_THAT(message("dimension: 3\nsizes: 2 2 2\n", ""), Contains("no field 'dimension'"));
  CHECK_THAT(message("dimension: 3\nsizes", "sizes"),
             Contains("line 3: field 'sizes' stands before 'dimension'"));
  CHECK_THAT(message("dimension: 3", "dimension: 2"),
             Contains("line 3") && Contains("'2'") && Contains("expected 3, or 4"));
  CHECK_THAT(message("dimension: 3", "dimension: 99999999999"), Contains("expected a number from 1 to 16"));
  CHECK_THAT(message("2 2 2", "2 2"), Contains("line 4: field 'sizes'") && Contains("expected 3 words"));
  CHECK_THAT(message("2 2 2", "2 -2 2"), Contains("'2 -2 2', expected whole numbers from 1 on"));
  CHECK_THAT(message("2 2 2", "2 0 2"), Contains("expected whole numbers from 1 on"));
  CHECK_THAT(message("2 2 2", "2 99999999999999999999 2"), Contains("expected whole numbers from 1 on"));
  CHECK_THAT(message("2 2 2", "1073741824 1073741824 1073741824"),
             Contains("more than 64-bit sizes can count"));
  CHECK_THAT(message("2 2 2", "1073741824 1073741824 1"),
             Contains("expected 1152921504606846976 bytes") && Contains("found 8"));
  CHECK_THAT(message("uchar", "short"), Contains("no field 'endian'"));
  CHECK_THAT(message("uchar", "longlong"), Contains("'longlong' is not possible") && Contains("f64"));
  CHECK_THAT(message("uchar", "half"), Contains("nearest that is possible is f32"));
  CHECK_THAT(message("uchar", "block"), Contains("unknown sample type 'block'"));
  CHECK_THAT(message("type", "endian: middle\ntype"), Contains("'middle', expected little or big"));
  CHECK_THAT(message("raw", "hex"), Contains("encoding 'hex' is not supported, expected raw or gzip"));
  CHECK_THAT(message("raw", "bzip2"), Contains("encoding 'bzip2' is not supported"));
  CHECK_THAT(message("raw", "gzip"), Contains("damaged"));
  CHECK_THAT(message("encoding", "byte skip: -2\nencoding"), Contains("expected a whole number from -1 on"));
  CHECK_THAT(message("encoding", "byte skip: 9223372036854775807\nencoding"), Contains("found 0"));
  CHECK_THAT(message("encoding", "line skip: 9\nencoding"), Contains("lines to skip"));
  CHECK_THAT(message("encoding", "space dimension: 2\nencoding"), Contains("expected 3"));
  CHECK_THAT(message("encoding", "spacings: 1 zero 1\nencoding"), Contains("'1 zero 1', expected numbers"));
  CHECK_THAT(message("encoding", "spacings: 1 0 1\nencoding"), Contains("span no volume"));
  CHECK_THAT(message("encoding", "spacings: 1 inf 1\nencoding"), Contains("not finite"));
  CHECK_THAT(message("encoding", "space directions: (1,0,0) (0,nan,0) (0,0,1)\nencoding"),
             Contains("not finite"));
  CHECK_THAT(message("encoding", "space directions: (1,0,0) (2,0,0) (0,0,1)\nencoding"),
             Contains("span no volume"));
  CHECK_THAT(message("encoding", "space directions: (1,0,0) (0,1,0)\nencoding"),
             Contains("expected vectors like"));
  CHECK_THAT(message("encoding", "space directions: (1,0) (0,1) (1,1)\nencoding"),
             Contains("vectors of three numbers"));
  CHECK_THAT(message("encoding", "space directions: none (0,1,0) (1,0,0)\nencoding"),
             Contains("axis 0 has no space direction"));
  CHECK_THAT(message("encoding", "space origin: none\nencoding"), Contains("expected a vector"));
  CHECK_THAT(message("encoding", "data file: LIST\nencoding"), Contains("several files"));
  CHECK_THAT(message("encoding", "data file: slice%03d.raw 1 9 1\nencoding"), Contains("several files"));
  CHECK_THAT(message("encoding", "data file: absent.raw\nencoding"),
             Contains("absent.raw") && Contains("No such file"));
  CHECK_THAT(message("encoding", "data file: a\x1b[2Jb\nencoding"),
             Contains("'a?[2Jb', expected a name without control characters"));
  CHECK_THAT(message("encoding", "spacings: " + std::string(5000, '1') + "\nencoding"),
             Contains("longer than 4096"));
  CHECK_THAT(message("encoding", "\x1b[2J\nencoding"), Contains("'?[2J'"));
  CHECK_THAT(error_of(folder.write("cut.nrrd", kPlain.substr(0, kPlain.size() - 9))),
             Contains("does not end with an empty line"));
  CHECK_THAT(error_of(folder.write("cut.nrrd", kPlain.substr(0, kPlain.size() - 3))),
             Contains("expected 8 bytes") && Contains("found 5"));
  CHECK_THAT(error_of(folder.write("none.nrrd", "")), Contains("it is empty"));
}

TEST_CASE("compressed NRRD data that lies is told", "[io][nrrd]") {
  const TemporaryFolder folder;
  const std::string header = kMagic + "type: uint8\ndimension: 3\nencoding: gzip\n";
  const auto message = [&](const std::string& sizes, const std::string& data) {
    return error_of(folder.write("z.nrrd", header + "sizes: " + sizes + "\n\n" + data));
  };
  const std::string noise = test::noise(1000);
  const std::string good = gzip(noise);
  CHECK(message("10 10 10", good).empty());
  CHECK_THAT(message("10 10 11", good), Contains("expected 1100 bytes") && Contains("found 1000"));
  CHECK_THAT(message("10 10 10", good.substr(0, 500)), Contains("expected 1000 bytes") && Contains("found"));
  CHECK_THAT(message("10 10 10", replaced(good, good.substr(300, 4), "\1\2\3\4")), Contains("damaged"));
  CHECK_THAT(message("10 10 10", good.substr(0, good.size() - 8) + std::string(8, '\0')),
             Contains("incorrect data check"));
  CHECK_THAT(message("100000 100000 1000", good),
             Contains("expected 10000000000000 bytes") && Contains("above 200 MB at most 200 times as much"));
  CHECK_THAT(message("1000 1000 200", good), Contains("found 1000"));

  // a bomb: little is kept of what it holds, and nothing is taken for what it claims
  const std::string bomb = gzip(std::string(50 << 20, '\0'));
  CHECK(message("10 10 10", bomb).empty());
  CHECK_THAT(message("100000 100000 1000", bomb), Contains("at most 200 times as much"));
  CHECK_THAT(message("10 10 10\nbyte skip: 9223372036854775807", bomb),
             Contains("at most 200 times as much"));
}
