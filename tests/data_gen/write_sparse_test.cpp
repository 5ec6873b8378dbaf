// What sample writes as .vdb and .nvdb comes back as it was: samples, place, band, codes within their
// quantum.
#include <isocast/base/error.h>
#include <isocast/data_gen/write_sparse.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/volume/io/read_volume.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>
#include <cmath>

using namespace isocast;
using namespace isocast::test;

namespace {

const SampleGrid kGrid = {{21, 17, 30}, {{-1, 0, 2}, {1, 0.5, 4}}};

Field field() { return formula_field(parse_expression("100*sin(3*x)*y + z^2 - 9", {})); }

// The field at a sample, NaN outside of the grid.
double exact(const Field& field, std::int32_t i, std::int32_t j, std::int32_t k) {
  std::vector<double> row(static_cast<std::size_t>(kGrid.dims[0]));
  field(kGrid, j, k, row);
  return row[static_cast<std::size_t>(i)];
}

double sample(const SparseTree& tree, std::int32_t i, std::int32_t j, std::int32_t k) {
  return visit_sparse_type(tree.type(), [&]<class S>(SparseTag<S>) {
    return static_cast<double>(sample_at<S>(tree.view(), {i, j, k}));
  });
}

template <class Check> void for_samples(const Check& check) {
  for (std::int32_t k = 0; k < kGrid.dims[2]; ++k)
    for (std::int32_t j = 0; j < kGrid.dims[1]; ++j)
      for (std::int32_t i = 0; i < kGrid.dims[0]; ++i) check(i, j, k);
}

}  // namespace

TEST_CASE("sparse files hold the samples in every type", "[io]") {
  const TemporaryFolder folder;
  const Field f = field();
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"a.vdb", {"f32", "f64", "i32", "i64"}},
           {"a.nvdb", {"f32", "f64", "i16", "i32", "i64", "fp4", "fp8", "fp16", "fpn"}}})
    for (const std::string& word : words) {
      INFO(file << " " << word);
      SparseWriteOptions options;
      options.type = sparse_type_for(file, word);
      options.background = -7;
      const WriteReport report = write_sparse_field(f, kGrid, folder.path / file, options);
      const Volume volume = read_volume(folder.path / file);
      REQUIRE(volume.tree);
      CHECK(volume.type_name() == word);
      CHECK(volume.grid_name == "a");
      CHECK(volume.dims == kGrid.dims);
      CHECK(volume.tree->active_count() == 21 * 17 * 30);
      for (int a = 0; a < 3; ++a) {
        CHECK(volume.world_from_grid.m[a][a] == Approx(kGrid.spacing(a)));
        CHECK(volume.world_from_grid.m[a][3] == Approx(kGrid.domain.lo[a]));
      }
      // codes: a step of the leaf's range
      const double step = word == "fp4"   ? 15
                          : word == "fp8" ? 255
                                          : 65535,
                   range = report.values.hi - report.values.lo;
      for_samples([&](std::int32_t i, std::int32_t j, std::int32_t k) {
        const double want = exact(f, i, j, k), got = sample(*volume.tree, i, j, k);
        if (word == "f64") REQUIRE(got == want);
        else if (word == "f32") REQUIRE(got == static_cast<float>(want));
        else if (word[0] == 'i') REQUIRE(got == std::nearbyint(want));
        else if (word == "fpn") REQUIRE(std::abs(got - want) <= 0.01 * range);
        else REQUIRE(std::abs(got - want) <= range / step);
      });
      CHECK(sample(*volume.tree, -1, 0, 0) == -7);
      CHECK(sample(*volume.tree, 5000, 0, 0) == -7);
    }
}

TEST_CASE("a narrow band keeps what is near the surface, and the side of the rest", "[io]") {
  const TemporaryFolder folder;
  const Field f = formula_field(parse_expression("sqrt(x^2+y^2+z^2) - 0.7", {}));
  const SampleGrid grid = {{70, 70, 70}, {{-1, -1, -1}, {1, 1, 1}}};
  for (const char* file : {"ball.vdb", "ball.nvdb"}) {
    SparseWriteOptions options;
    options.band = 0.06;
    write_sparse_field(f, grid, folder.path / file, options);
    const Volume volume = read_volume(folder.path / file);
    CHECK(volume.grid_class == "level set");
    CHECK(volume.tree->leaves().size() < 500);
    std::vector<double> row(70);
    double active = 0;
    for (std::int32_t k = 0; k < 70; ++k)
      for (std::int32_t j = 0; j < 70; ++j) {
        f(grid, j, k, row);
        for (std::int32_t i = 0; i < 70; ++i) {
          const double v = row[static_cast<std::size_t>(i)];
          active += std::abs(v) <= 0.06;
          REQUIRE(sample(*volume.tree, i, j, k) == static_cast<float>(std::clamp(v, -0.06, 0.06)));
        }
      }
    CHECK(volume.tree->active_count() == active);
  }
}

TEST_CASE("sparse files that cannot be written are refused in one sentence", "[io]") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(sparse_type_for("a.vdb", "u8"),
                    Catch::Contains("u8 for .vdb") && Catch::Contains("nearest is i32"));
  CHECK_THROWS_WITH(sparse_type_for("a.nvdb", "f16"), Catch::Contains("nearest is f32"));
  CHECK_THROWS_WITH(write_sparse_field(field(), kGrid, folder.path / "none" / "a.vdb", {}),
                    Catch::Contains("none"));
  SparseWriteOptions options;
  options.band = -1;
  CHECK_THROWS_WITH(write_sparse_field(field(), kGrid, folder.path / "a.vdb", options),
                    Catch::Contains("band of -1"));
  CHECK(std::filesystem::is_empty(folder.path));
}
