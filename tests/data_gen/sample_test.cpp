// Volumes written from fields: values, bytes, headers, refusals.
#include <isocast/base/error.h>
#include <isocast/data_gen/test_volumes.h>
#include <isocast/data_gen/write.h>
#include <isocast/implicit/expression/parse.h>
#include <oneapi/tbb/global_control.h>
#include <temporary_folder.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

using namespace isocast;
using namespace isocast::test;

namespace {

template <class S> std::vector<S> as_samples(const std::string& bytes) {
  std::vector<S> samples(bytes.size() / sizeof(S));
  std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(S));
  return samples;
}

Field formula(std::string_view text) { return formula_field(parse_expression(text)); }

SampleGrid grid_of(std::int64_t x, std::int64_t y, std::int64_t z, const Domain& domain = {}) {
  return {{x, y, z}, domain};
}

}  // namespace

TEST_CASE("samples are the formula at the grid's positions, x fastest") {
  const TemporaryFolder folder;
  const SampleGrid grid = grid_of(300, 4, 5, {{-3, 0, 10}, {3, 1, 20}});
  const WriteReport report =
      write_field(formula("x + 100*y + 10000*z"), grid, folder / "a.raw", {.type = SampleType::f64});
  const std::vector<double> samples = as_samples<double>(bytes_of(folder / "a.raw"));
  REQUIRE(samples.size() == 300 * 4 * 5);
  CHECK(samples.front() == 100000 - 3);
  CHECK(samples.back() == 200000 + 100 + 3);
  CHECK(samples[299] == 100000 + 3);
  for (std::int64_t k = 0; k < 5; ++k)
    for (std::int64_t j = 0; j < 4; ++j)
      for (std::int64_t i = 0; i < 300; ++i) {
        const double x = -3 + 6.0 * double(i) / 299, y = double(j) / 3, z = 10 + 10 * double(k) / 4;
        REQUIRE(samples[std::size_t(i + 300 * (j + 4 * k))] ==
                Approx(x + 100 * y + 10000 * z).epsilon(1e-14));
      }
  CHECK(report.bytes == 8 * 300 * 4 * 5);
  CHECK(report.values.lo == samples.front());
  CHECK(report.values.hi == samples.back());
  CHECK(report.slope == 1);
}

TEST_CASE("w is time, and float samples are rounded doubles") {
  const TemporaryFolder folder;
  write_field(formula_field(parse_expression("x/3 + w"), 0.1), grid_of(2, 2, 2), folder / "a.raw", {});
  CHECK(as_samples<float>(bytes_of(folder / "a.raw"))[1] == float(1.0 / 3 + 0.1));
}

TEST_CASE("neither slabs nor threads change a byte") {
  const TemporaryFolder folder;
  const SampleGrid grid = grid_of(33, 17, 9);
  for (const SampleType type : {SampleType::f32, SampleType::u8, SampleType::u16, SampleType::f64}) {
    std::set<std::string> contents;
    for (const char* name : {"noise", "gyroid", "vessel"}) {
      contents.clear();
      const Field field = test_volume_field(*find_test_volume(name), {});
      for (const std::int64_t slab_bytes : {1, 500, 3001, 64 << 20}) {
        write_field(field, grid, folder / "a.nrrd", {.type = type, .slab_bytes = slab_bytes});
        contents.insert(bytes_of(folder / "a.nrrd"));
      }
      const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
      write_field(field, grid, folder / "a.nrrd", {.type = type});
      contents.insert(bytes_of(folder / "a.nrrd"));
      CHECK(contents.size() == 1);
    }
  }
}

TEST_CASE("integers are the range mapped linearly, clamped, NaN as 0") {
  const TemporaryFolder folder;
  const SampleGrid grid = grid_of(256, 2, 2, {{0, 0, 0}, {255, 1, 1}});
  const auto bytes = [&](const Field& field, const WriteOptions& options, WriteReport* report = nullptr) {
    const WriteReport written = write_field(field, grid, folder / "a.raw", options);
    if (report) *report = written;
    return bytes_of(folder / "a.raw");
  };

  // the sampled range, and the same range given
  WriteReport report;
  const std::vector<std::uint8_t> found =
      as_samples<std::uint8_t>(bytes(formula("2*x - 10"), {.type = SampleType::u8}, &report));
  for (std::size_t i = 0; i < 256; ++i) REQUIRE(found[i] == i);
  CHECK(report.slope == 2);
  CHECK(report.intercept == -10);
  const ValueRange range = {-10, 500};
  CHECK(as_samples<std::uint8_t>(bytes(formula("2*x - 10"), {.type = SampleType::u8, .range = range})) ==
        found);

  // rounding, clamping, 16 bits
  const auto rounded = as_samples<std::uint8_t>(
      bytes(formula("x"), {.type = SampleType::u8, .range = ValueRange{100, 200}}, &report));
  for (std::size_t i = 0; i < 256; ++i)
    REQUIRE(rounded[i] == std::clamp(std::floor((double(i) - 100) * 2.55 + 0.5), 0.0, 255.0));
  CHECK(report.slope == Approx(100.0 / 255));
  CHECK(report.values.hi == 255);
  const auto wide = as_samples<std::uint16_t>(bytes(formula("x"), {.type = SampleType::u16}, &report));
  for (std::size_t i = 0; i < 256; ++i) REQUIRE(wide[i] == 257 * i);

  // NaN, infinity, one value
  const auto holes =
      as_samples<std::uint8_t>(bytes(formula("x + 0*sqrt(x - 10)"), {.type = SampleType::u8}, &report));
  CHECK(report.values.nan_count == 40);
  CHECK(holes[9] == 0);
  CHECK(holes[10] == 0);
  CHECK(holes[255] == 255);
  const auto poles = as_samples<std::uint8_t>(bytes(formula("-1/x"), {.type = SampleType::u8}, &report));
  CHECK(poles[0] == 0);
  CHECK(report.values.lo == -1);
  const auto flat = as_samples<std::uint8_t>(bytes(formula("7"), {.type = SampleType::u8}, &report));
  CHECK(flat[100] == 0);
  CHECK(report.slope * flat[100] + report.intercept == 7);
  CHECK(as_samples<std::uint8_t>(bytes(formula("sqrt(-1 - x)"), {.type = SampleType::u8}, &report))[3] == 0);
  CHECK(report.values.nan_count == 1024);
}

TEST_CASE("an NRRD header says where the samples lie and how they are scaled") {
  const TemporaryFolder folder;
  const SampleGrid grid = grid_of(3, 5, 2, {{-1, -2, 0}, {1, 2, 0.5}});
  write_field(formula("x"), grid, folder / "a.nrrd", {});
  const std::string floats = bytes_of(folder / "a.nrrd");
  const std::string expected =
      "NRRD0005\n# sampled by isocast\ntype: float\ndimension: 3\nspace dimension: 3\nsizes: 3 5 2\nendian: "
      "little\n"
      "encoding: raw\nspace directions: (1,0,0) (0,1,0) (0,0,0.5)\nspace origin: (-1,-2,0)\n#";
  CHECK(floats.starts_with(expected));
  CHECK((floats.size() - 30 * 4) % 64 == 0);  // aligned, so that readers can map it
  CHECK(floats.substr(floats.size() - 30 * 4 - 2, 2) == "\n\n");
  write_field(formula("x"), grid, folder / "a.nrrd", {.type = SampleType::u8, .range = ValueRange{-51, 204}});
  const std::string integers = bytes_of(folder / "a.nrrd");
  CHECK(integers.find("type: uint8\n") != std::string::npos);
  CHECK(integers.find("\nold min: -51\nold max: 204\nisocast_slope:=1\nisocast_intercept:=-51\n#") !=
        std::string::npos);
}

TEST_CASE("what cannot be written is refused and leaves the old file") {
  const TemporaryFolder folder;
  const std::filesystem::path target = folder / "a.raw";
  std::ofstream(target) << "old";
  const auto write = [&](const SampleGrid& grid, const WriteOptions& options) {
    write_field(formula("x"), grid, target, options);
  };
  CHECK_THROWS_WITH(write_field(formula("x"), grid_of(2, 2, 2), "a.vdb", {}),
                    "found the output a.vdb, expected a name that ends in one of .nrrd .raw .nii .mha");
  CHECK_THROWS_WITH(write_field(formula("x"), grid_of(2, 2, 2), folder / "a.nrrd", {.type = SampleType::f16}),
                    "found the sample type f16 for .nrrd, expected one of u8 i8 u16 i16 u32 i32 f32 f64 (the "
                    "nearest is f32)");
  CHECK_THROWS_WITH(write(grid_of(2, 1, 2), {}),
                    "found a resolution of 1 along y, expected 2 to 1048576 samples");
  CHECK_THROWS_WITH(write(grid_of(2, 2, 1 << 21), {}),
                    "found a resolution of 2097152 along z, expected 2 to 1048576 samples");
  CHECK_THROWS_WITH(
      write(grid_of(1 << 20, 1 << 20, 1 << 20), {.type = SampleType::f64}),
      "found a resolution of 1048576x1048576x1048576, expected less than 2^63 bytes of samples");
  CHECK_THROWS_WITH(write(grid_of(2, 2, 2, {{0, 1, 0}, {1, 1, 1}}), {}),
                    "found the domain 1,1 along y, expected a finite LO below HI");
  CHECK_THROWS_WITH(write(grid_of(2, 2, 2, {{0, 0, -1e308}, {1, 1, 1e308}}), {}),
                    Catch::Contains("expected a finite LO below HI"));
  CHECK_THROWS_WITH(write(grid_of(2, 2, 2), {.type = SampleType::u8, .range = ValueRange{1, 0}}),
                    "found the range 1,0, expected a finite LO not above HI");
  CHECK_THROWS_WITH(write_field(formula("x"), grid_of(2, 2, 2), folder / "none/a.raw", {}),
                    Catch::Contains("does not exist"));
  CHECK(bytes_of(target) == "old");
  CHECK(folder.entries() == 1);
}
