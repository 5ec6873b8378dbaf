// Volumes written in one format and another, and read back.
#include <isocast/data_gen/write.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/volume/io/read_volume.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>
#include <cstring>

using namespace isocast;
using namespace isocast::test;

namespace {

Field formula(std::string_view text) { return formula_field(parse_expression(text)); }

#ifdef WITH_NIFTI
const std::vector<std::string> kFormats = {"a.mha", "a.nii"};
#else
const std::vector<std::string> kFormats = {"a.mha"};
#endif

// The same samples, in the same places to within a part of the numbers themselves.
void check_same(const Volume& found, const Volume& expected, double tolerance) {
  CHECK(found.type == expected.type);
  REQUIRE(found.dims == expected.dims);
  CHECK(std::memcmp(found.samples, expected.samples,
                    static_cast<std::size_t>(expected.count()) * size_of(expected.type)) == 0);
  const auto close = [&](double value) { return Approx(value).epsilon(tolerance).margin(0).scale(0); };
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      CHECK(found.world_from_grid.m[r][c] == close(expected.world_from_grid.m[r][c]));
  CHECK(found.slope == close(expected.slope));
  CHECK(found.intercept == close(expected.intercept));
}

}  // namespace

TEST_CASE("what is written is read back, mapped in place, the same in every format and type") {
  const TemporaryFolder folder;
  const SampleGrid grid = {{7, 5, 3}, {{-1.1, 2, 0.3}, {1, 20, 0.7}}};
  const auto type = GENERATE(SampleType::u8, SampleType::i8, SampleType::u16, SampleType::i16,
                             SampleType::u32, SampleType::i32, SampleType::f32, SampleType::f64);
  INFO(name_of(type));
  const auto written = [&](const std::string& name) {
    write_field(formula("x*y - z"), grid, folder / name, {.type = type, .slab_bytes = 100});
    return read_volume(folder / name);
  };
  const Volume expected = written("a.nrrd");
  for (const std::string& name : kFormats) {
    INFO(name);
    const Volume found = written(name);
    CHECK(found.mapped);
    check_same(found, expected, name == "a.mha" ? 0 : 1e-7);
  }
}

TEST_CASE("signed integers use all their numbers") {
  const TemporaryFolder folder;
  const SampleGrid grid = {{256, 2, 2}, {{0, 0, 0}, {255, 1, 1}}};
  const WriteReport report =
      write_field(formula("2*x + 0*sqrt(x - 1)"), grid, folder / "a.mha", {.type = SampleType::i8});
  const Volume volume = read_volume(folder / "a.mha");
  const auto* samples = reinterpret_cast<const signed char*>(volume.samples);
  CHECK(samples[0] == -128);  // a NaN
  CHECK(samples[1] == -128);
  CHECK(samples[255] == 127);
  CHECK(volume.slope == report.slope);
  CHECK(volume.slope * samples[1] + volume.intercept == Approx(2));
  CHECK(volume.slope * samples[255] + volume.intercept == Approx(510));
}

TEST_CASE(".raw has f16, rounded to nearest") {
  const TemporaryFolder folder;
  write_field(formula("1 + x*2^-11"), {{4, 2, 2}, {{0, 0, 0}, {3, 1, 1}}}, folder / "a.raw",
              {.type = SampleType::f16});
  const std::string bytes = bytes_of(folder / "a.raw");
  REQUIRE(bytes.size() == 32);
  std::uint16_t bits[4];
  std::memcpy(bits, bytes.data(), sizeof bits);
  CHECK(bits[0] == 0x3c00);
  CHECK(bits[1] == 0x3c00);  // a tie goes to even
  CHECK(bits[2] == 0x3c01);
  CHECK(bits[3] == 0x3c02);
}

#ifdef WITH_NIFTI
TEST_CASE("NIfTI-2 is written where NIfTI-1 cannot hold the numbers") {
  const TemporaryFolder folder;
  const auto size_of_header = [&](const SampleGrid& grid, const WriteOptions& options = {}) {
    write_field(formula("x"), grid, folder / "a.nii", options);
    write_field(formula("x"), grid, folder / "a.nrrd", options);
    std::int32_t size = 0;
    std::memcpy(&size, bytes_of(folder / "a.nii").data(), sizeof size);
    check_same(read_volume(folder / "a.nii"), read_volume(folder / "a.nrrd"), size == 540 ? 0 : 1e-7);
    return size;
  };
  CHECK(size_of_header({{32767, 2, 2}, {}}) == 348);
  CHECK(size_of_header({{32768, 2, 2}, {}}) == 540);
  CHECK(size_of_header({{2, 2, 40000}, {}}) == 540);

  // far from the origin, tiny, and values finer than floats
  CHECK(size_of_header({{9, 9, 9}, {{1e6 + 0.1, 0, 0}, {1e6 + 0.2, 1, 1}}}) == 540);
  CHECK(size_of_header({{9, 9, 9}, {{0, 0, 0}, {1, 1, 1e-50}}}) == 540);
  const SampleGrid grid = {{9, 9, 9}, {{-0.7, 0, 0}, {1, 1, 1}}};
  CHECK(size_of_header(grid, {.type = SampleType::u16}) == 348);
  CHECK(size_of_header(grid, {.type = SampleType::u32}) == 540);
}
#endif
