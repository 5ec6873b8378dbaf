// NIfTI: both versions, both byte orders, plain and in gzip; the affine, the scaling, and headers that lie.
#include <map>

#include "volume_files.h"

using namespace isocast;
using namespace isocast::test;
using Catch::Contains;

namespace {

// A header field by field at its byte; numbers take the width that the format gives them.
struct NiftiFile {
  int version = 1;
  bool big_endian = false;
  std::vector<std::int64_t> dim = {3, 3, 2, 4};
  int datatype = 2, qform = 0, sform = 0;
  std::vector<double> pixdim = {1, 1, 1, 1}, quatern = {0, 0, 0}, qoffset = {0, 0, 0};
  std::vector<double> srow = std::vector<double>(12);
  double slope = 0, inter = 0, offset = -1;  // of the samples: behind the header unless given
  std::string magic;

  [[nodiscard]] std::string header() const {
    const bool two = version == 2;
    std::string h(two ? 544 : 352, '\0');
    const auto put = [&](std::size_t at, const std::string& bytes) { h.replace(at, bytes.size(), bytes); };
    const auto whole = [&](std::size_t at1, std::size_t at2, std::int64_t v) {
      put(two ? at2 : at1,
          two ? bytes_of(std::int32_t(v), big_endian) : bytes_of(std::int16_t(v), big_endian));
    };
    const auto reals = [&](std::size_t at1, std::size_t at2, const std::vector<double>& values) {
      for (std::size_t i = 0; i < values.size(); ++i)
        put(two ? at2 + 8 * i : at1 + 4 * i,
            two ? bytes_of(values[i], big_endian) : bytes_of(float(values[i]), big_endian));
    };
    put(0, bytes_of(std::int32_t(two ? 540 : 348), big_endian));
    for (std::size_t i = 0; i < dim.size(); ++i)
      put(two ? 16 + 8 * i : 40 + 2 * i,
          two ? bytes_of(dim[i], big_endian) : bytes_of(std::int16_t(dim[i]), big_endian));
    put(two ? 12 : 70, bytes_of(std::int16_t(datatype), big_endian));
    reals(76, 104, pixdim);
    const double at = offset < 0 ? double(h.size()) : offset;
    if (two) put(168, bytes_of(std::int64_t(at), big_endian));
    else reals(108, 0, {at});
    reals(112, 176, {slope, inter});
    whole(252, 344, qform);
    whole(254, 348, sform);
    reals(256, 352, quatern);
    reals(268, 376, qoffset);
    reals(280, 400, srow);
    put(two ? 4 : 344, magic.empty() ? (two ? "n+2" : "n+1") : magic);
    return h;
  }
};

const std::string kBytes(24, '\7');
const std::map<SampleType, int> kDatatypes = {
    {SampleType::u8, 2},    {SampleType::i8, 256}, {SampleType::u16, 512}, {SampleType::i16, 4},
    {SampleType::u32, 768}, {SampleType::i32, 8},  {SampleType::f32, 16},  {SampleType::f64, 64}};

}  // namespace

TEMPLATE_TEST_CASE("NIfTI is read in every type, version, byte order and packing", "[io][nifti]",
                   ISO_FILE_SAMPLE_TYPES) {
  const TemporaryFolder folder;
  const std::vector<TestType> values = pattern<TestType>(3 * 2 * 4);
  NiftiFile file;
  file.version = GENERATE(1, 2);
  file.big_endian = GENERATE(false, true);
  const bool compressed = GENERATE(false, true);
  file.datatype = kDatatypes.at(kTypeOf<TestType>);
  const std::string content = file.header() + bytes_of(values, file.big_endian);
  const Volume volume =
      read_volume(compressed ? folder.write("v.nii.gz", gzip(content)) : folder.write("v.nii", content));
  CHECK(volume.type == kTypeOf<TestType>);
  CHECK(volume.dims == std::array<std::int64_t, 3>{3, 2, 4});
  CHECK(samples_of<TestType>(volume) == values);
  CHECK(volume.mapped == (!compressed && (!file.big_endian || sizeof(TestType) == 1)));
  CHECK(volume.format == "nifti");
  CHECK(volume.slope == 1);
  CHECK(volume.intercept == 0);
}

TEST_CASE("samples may begin late, and unaligned ones are copied", "[io][nifti]") {
  const TemporaryFolder folder;
  NiftiFile file;
  file.dim = {3, 2, 1, 1};
  file.datatype = 16;
  const auto offset = GENERATE(352, 353, 1000);
  file.offset = offset;
  std::string content = file.header();
  content.resize(static_cast<std::size_t>(offset), '#');
  content += bytes_of(std::vector<float>{2.5f, -1});
  const Volume plain = read_volume(folder.write("v.nii", content)),
               packed = read_volume(folder.write("v.nii.gz", gzip(content)));
  CHECK(plain.mapped == (offset % 4 == 0));
  CHECK(samples_of<float>(plain) == std::vector<float>{2.5f, -1});
  CHECK(samples_of<float>(packed) == std::vector<float>{2.5f, -1});
}

TEST_CASE("slope and intercept count unless the slope is 0 or NaN", "[io][nifti]") {
  const TemporaryFolder folder;
  const auto read = [&](double slope, double inter) {
    NiftiFile file;
    file.slope = slope;
    file.inter = inter;
    const Volume volume = read_volume(folder.write("v.nii", file.header() + kBytes));
    return std::pair(volume.slope, volume.intercept);
  };
  CHECK(read(0.5, -1024) == std::pair(0.5, -1024.0));
  CHECK(read(-2, 0) == std::pair(-2.0, 0.0));
  CHECK(read(0, 7) == std::pair(1.0, 0.0));
  CHECK(read(std::nan(""), 7) == std::pair(1.0, 0.0));
}

TEST_CASE("further dimensions must be 1", "[io][nifti]") {
  const TemporaryFolder folder;
  NiftiFile file;
  file.dim = {5, 3, 2, 4, 1, 1};
  CHECK(read_volume(folder.write("v.nii", file.header() + kBytes)).dims ==
        std::array<std::int64_t, 3>{3, 2, 4});
  file.dim = {2, 6, 4};
  CHECK(read_volume(folder.write("v.nii", file.header() + kBytes)).dims ==
        std::array<std::int64_t, 3>{6, 4, 1});
  file.dim = {4, 3, 2, 2, 2};
  CHECK_THAT(error_of(folder.write("v.nii", file.header() + kBytes)),
             Contains("dim[4] is 2, expected one volume"));
}

TEST_CASE("the sform places the grid, else the qform, else the spacings", "[io][nifti]") {
  const TemporaryFolder folder;
  NiftiFile file;
  file.version = GENERATE(1, 2);
  file.pixdim = {1, 2, 3, 4};
  const auto check = [&](const std::array<std::array<double, 4>, 3>& rows) {
    const Transform t = read_volume(folder.write("v.nii", file.header() + kBytes)).world_from_grid;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) {
        INFO("row " << r << " column " << c);
        CHECK(t.m[r][c] == Approx(rows[r][c]).margin(1e-12));
      }
  };
  file.qoffset = {5, 6, 7};
  check({{{2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 0}}});

  // half a turn about z, then the same with a left-handed third axis
  file.qform = 1;
  file.quatern = {0, 0, 1};
  check({{{-2, 0, 0, 5}, {0, -3, 0, 6}, {0, 0, 4, 7}}});
  file.pixdim[0] = -1;
  check({{{-2, 0, 0, 5}, {0, -3, 0, 6}, {0, 0, -4, 7}}});

  // permuted and flipped axes
  file.sform = 2;
  file.srow = {0, 0, -1.5, 80, -2, 0, 0, 90, 0, 2.5, 0, -70};
  check({{{0, 0, -1.5, 80}, {-2, 0, 0, 90}, {0, 2.5, 0, -70}}});
}

TEST_CASE("bad NIfTI headers are told", "[io][nifti]") {
  const TemporaryFolder folder;
  NiftiFile good;
  good.version = GENERATE(1, 2);
  good.big_endian = GENERATE(false, true);
  const auto message = [&](auto change) {
    NiftiFile file = good;
    change(file);
    return error_of(folder.write("bad.nii", file.header() + kBytes));
  };
  CHECK(message([](NiftiFile&) {}).empty());
  CHECK_THAT(message([](NiftiFile& f) { f.dim[0] = 0; }), Contains("dim[0] is 0, expected 1 to 7"));
  CHECK_THAT(message([](NiftiFile& f) { f.dim[0] = 8; }), Contains("dim[0] is 8"));
  CHECK_THAT(message([](NiftiFile& f) { f.dim[1] = 0; }), Contains("dim[1] is 0, expected 1 to"));
  CHECK_THAT(message([](NiftiFile& f) { f.dim[2] = -5; }), Contains("dim[2] is -5"));
  CHECK_THAT(message([](NiftiFile& f) {
               f.dim = {3, 32767, 32767, 32767};
             }),
             Contains("expected 35181150961663 bytes") && Contains("found 24"));
  CHECK_THAT(message([](NiftiFile& f) { f.datatype = 0; }), Contains("datatype 0 is unknown"));
  CHECK_THAT(message([](NiftiFile& f) { f.datatype = 1; }), Contains("bad.nii"));
  CHECK_THAT(message([](NiftiFile& f) { f.datatype = 999; }), Contains("datatype 999 is unknown"));
  CHECK_THAT(message([](NiftiFile& f) { f.datatype = 1024; }),
             Contains("'INT64' is not possible") && Contains("f64"));
  CHECK_THAT(message([](NiftiFile& f) { f.datatype = 128; }),
             Contains("'RGB24' is not possible") && Contains("u8"));
  CHECK_THAT(message([](NiftiFile& f) { f.datatype = 32; }),
             Contains("'COMPLEX64' is not possible") && Contains("f32"));
  CHECK_THAT(message([](NiftiFile& f) { f.offset = 1e12; }), Contains("vox_offset"));
  CHECK_THAT(message([](NiftiFile& f) { f.offset = 100000; }),
             Contains("expected 24 bytes") && Contains("found 0"));
  CHECK_THAT(message([](NiftiFile& f) { f.pixdim[2] = 0; }), Contains("pixdim[2] is 0"));
  CHECK_THAT(message([](NiftiFile& f) { f.pixdim[3] = std::nan(""); }), Contains("pixdim[3] is nan"));
  CHECK_THAT(message([](NiftiFile& f) { f.sform = 1; }), Contains("span no volume"));
  CHECK_THAT(message([](NiftiFile& f) { f.sform = 1, f.srow[3] = std::numeric_limits<float>::infinity(); }),
             Contains("not finite"));
  CHECK_THAT(message([](NiftiFile& f) { f.magic = "xyz"; }), Contains("no NIfTI magic"));
}

TEST_CASE("headers that no number of any version fits are told", "[io][nifti]") {
  const TemporaryFolder folder;
  NiftiFile file;
  file.magic = "ni1";
  CHECK_THAT(error_of(folder.write("a.nii", file.header() + kBytes)), Contains("pair of files"));
  file = {};
  file.offset = std::nan("");
  CHECK_THAT(error_of(folder.write("a.nii", file.header() + kBytes)), Contains("vox_offset is nan"));
  file = {};
  file.version = 2;
  file.dim = {3, 1 << 30, 1 << 30, 1 << 30};
  CHECK_THAT(error_of(folder.write("a.nii", file.header() + kBytes)),
             Contains("more than 64-bit sizes can count"));
  file.dim = {3, std::int64_t(1) << 62, 4, 4};
  CHECK_THAT(error_of(folder.write("a.nii", file.header() + kBytes)),
             Contains("dim[1] is 4611686018427387904, expected 1 to 1073741824"));
  CHECK_THAT(error_of(folder.write("a.nii", NiftiFile{}.header().substr(0, 347))),
             Contains("ends inside its header of 348 bytes"));
  CHECK_THAT(error_of(folder.write("a.nii", file.header().substr(0, 500))),
             Contains("ends inside its header of 540 bytes"));
  CHECK_THAT(error_of(folder.write("a.nii", std::string(1000, 'x'))),
             Contains("does not start with a NIfTI header's size"));
}

TEST_CASE("compressed NIfTI that lies is told", "[io][nifti]") {
  const TemporaryFolder folder;
  NiftiFile file;
  const std::string header = file.header(), good = gzip(header + kBytes);
  const auto message = [&](const std::string& content) {
    return error_of(folder.write("z.nii.gz", content));
  };
  CHECK(message(good).empty());
  CHECK(message(header + kBytes).empty());  // plain in spite of its name
  CHECK_THAT(message(gzip(header + kBytes.substr(1))), Contains("expected 24 bytes") && Contains("found 23"));
  CHECK_THAT(message(good.substr(0, 30)), Contains("ends inside its header"));
  CHECK_THAT(message(good.substr(0, good.size() - 8) + "12345678"), Contains("incorrect data check"));
  CHECK_THAT(message("\x1f\x8b garbage"), Contains("damaged"));
  file.dim = {3, 32767, 32767, 32767};
  CHECK_THAT(message(gzip(file.header() + kBytes)), Contains("at most 200 times as much"));
}
