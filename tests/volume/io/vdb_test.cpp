// What OpenVDB and NanoVDB write is read as they read it: samples, activity, tiles, place, names.
#define NANOVDB_USE_ZIP
#define NANOVDB_USE_BLOSC
#include <nanovdb/util/IO.h>
#include <nanovdb/util/OpenToNanoVDB.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include "volume_files.h"

using namespace isocast;
using namespace isocast::test;
using Catch::Contains;

namespace {

openvdb::math::Transform::Ptr turned_transform() {
  openvdb::Mat4R m = openvdb::Mat4R::identity();  // of row vectors; mirrored
  m(0, 0) = 0, m(0, 1) = 0.5, m(1, 0) = 2, m(1, 1) = 0, m(2, 2) = 0.25;
  m(3, 0) = 10, m(3, 1) = -20, m(3, 2) = 30;
  return openvdb::math::Transform::createLinearTransform(m);
}

// Leaves across all kinds of borders, inactive samples, tiles of every size.
template <class Grid> typename Grid::Ptr make_grid(const std::string& name) {
  using T = typename Grid::ValueType;
  const typename Grid::Ptr grid = Grid::create(T(-5));
  auto& tree = grid->tree();
  std::mt19937_64 random(7);
  for (int n = 0; n < 4000; ++n) {
    const openvdb::Coord p(int(random() % 40) - 20, int(random() % 60) + 4070, int(random() % 30) - 140);
    const T value = static_cast<T>(random() % 1000) / 4;
    if (random() % 4) tree.setValueOn(p, value);
    else tree.setValueOff(p, value);
  }
  tree.addTile(1, {256, 0, 0}, T(2), true);
  tree.addTile(1, {264, 0, 0}, T(7), false);
  tree.addTile(2, {0, 128, 0}, T(3), true);
  tree.addTile(3, {-8192, 0, 0}, T(4), false);
  grid->setName(name);
  grid->setTransform(turned_transform());
  return grid;
}

template <class S> double sample(const SparseTree& tree, const openvdb::Coord& p) {
  return static_cast<double>(sample_at<S>(tree.view(), {p.x(), p.y(), p.z()}));
}
double sample(const SparseTree& tree, const openvdb::Coord& p) {
  return visit_sparse_type(tree.type(), [&]<class S>(SparseTag<S>) { return sample<S>(tree, p); });
}

template <class Grid> void require_same(const Volume& volume, const Grid& grid, double tolerance = 0) {
  REQUIRE(volume.tree);
  CHECK(volume.grid_name == grid.getName());
  CHECK(volume.tree->active_count() == static_cast<double>(grid.activeVoxelCount()));
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  for (int a = 0; a < 3; ++a) {
    CHECK(volume.tree->first_active()[static_cast<std::size_t>(a)] == box.min()[a]);
    CHECK(volume.tree->last_active()[static_cast<std::size_t>(a)] == box.max()[a]);
  }
  const auto samples = grid.getConstAccessor();
  std::mt19937_64 random(8);
  const auto check = [&](const openvdb::Coord& p) {
    INFO(p.x() << " " << p.y() << " " << p.z());
    const double want = static_cast<double>(samples.getValue(p)), got = sample(*volume.tree, p);
    REQUIRE(std::abs(got - want) <= tolerance);
    const Double3 world = volume.world_from_grid.point({double(p.x()), double(p.y()), double(p.z())});
    const openvdb::Vec3d place = grid.indexToWorld(p);
    for (int a = 0; a < 3; ++a) REQUIRE(world[a] == Approx(place[a]));
  };
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
    for (auto value = leaf->cbeginValueAll(); value; ++value) check(value.getCoord());
  for (int n = 0; n < 2000; ++n)
    check({int(random() % 600) - 100, int(random() % 5000), int(random() % 300) - 150});
  check({-8192, 5, 4095});
  check({100000, -100000, 5});
}

std::string write_vdb(const TemporaryFolder& folder, const openvdb::GridCPtrVec& grids,
                      std::uint32_t compression) {
  const std::string path = folder.path() / "a.vdb";
  openvdb::io::File file(path);
  file.setCompression(compression);
  file.write(grids);
  file.close();
  return path;
}
Volume read_grid(const std::filesystem::path& path, const std::string& grid) {
  ReadOptions options;
  options.grid = grid;
  return read_volume(path, options);
}

}  // namespace

TEMPLATE_TEST_CASE("OpenVDB grids are read as OpenVDB reads them", "[io]", openvdb::FloatGrid,
                   openvdb::DoubleGrid, openvdb::Int32Grid, openvdb::Int64Grid) {
  openvdb::initialize();
  const TemporaryFolder folder;
  const auto grid = make_grid<TestType>("density");
  using namespace openvdb::io;
  for (const int compression :
       {0 + COMPRESS_NONE, 0 + COMPRESS_ACTIVE_MASK, 0 + COMPRESS_ZIP, 0 + COMPRESS_BLOSC,
        COMPRESS_ZIP | COMPRESS_ACTIVE_MASK, COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK}) {
    INFO("compression " << compression);
    const Volume volume = read_volume(write_vdb(folder, {grid}, static_cast<std::uint32_t>(compression)));
    CHECK(volume.format == "vdb");
    CHECK_FALSE(volume.half_on_disk);
    // a mask keeps two values of inactive samples: what was written is what counts
    openvdb::io::File file(folder.path() / "a.vdb");
    file.open(false);
    require_same(volume, *openvdb::gridPtrCast<TestType>(file.readGrid("density")));
  }
}

TEST_CASE("grids of an OpenVDB file are chosen by name, or the first that can be read", "[io]") {
  openvdb::initialize();
  const TemporaryFolder folder;
  const auto density = make_grid<openvdb::FloatGrid>("density");
  density->setGridClass(openvdb::GRID_FOG_VOLUME);
  const auto whole = make_grid<openvdb::Int32Grid>("whole");
  const auto shared = density->copyGrid();
  shared->setName("shared");
  shared->setTransform(openvdb::math::Transform::createLinearTransform(3));
  const auto velocity = openvdb::Vec3SGrid::create();
  velocity->setName("velocity");
  const auto half = density->deepCopy();
  half->setSaveFloatAsHalf(true);
  half->setName("half");
  const std::string path =
      write_vdb(folder, {velocity, density, shared, whole, half}, openvdb::io::COMPRESS_ZIP);

  const Volume first = read_volume(path);
  require_same(first, *density);
  CHECK(first.grid_class == "fog volume");
  CHECK(first.other_grids == std::vector<std::string>{"velocity", "shared", "whole", "half"});
  require_same(read_grid(path, "whole"), *whole);
  require_same(read_grid(path, "shared"), *openvdb::gridConstPtrCast<openvdb::FloatGrid>(shared));
  const Volume halves = read_grid(path, "half");
  CHECK(halves.half_on_disk);
  CHECK(halves.type_name() == "f32");
  require_same(halves, *half, 0.25);  // of values below 512

  const auto message = [&](const std::string& grid) {
    try {
      (void)read_grid(path, grid);
      return std::string();
    } catch (const InputError& error) { return std::string(error.what()); }
  };
  CHECK_THAT(message("none"), Contains("no grid 'none'") && Contains("'density' ('float')"));
  CHECK_THAT(message("velocity"),
             Contains("'velocity'") && Contains("expected float, double, int32 or int64"));
  const auto bent = make_grid<openvdb::FloatGrid>("bent");
  bent->setTransform(
      openvdb::math::Transform::createFrustumTransform(openvdb::BBoxd({0, 0, 0}, {9, 9, 9}), 0.5, 2));
  write_vdb(folder, {bent}, openvdb::io::COMPRESS_NONE);
  CHECK_THAT(message(""), Contains("transform") && Contains("keeps lines straight"));
}

TEST_CASE("an OpenVDB file written as a stream has no table of its grids", "[io]") {
  openvdb::initialize();
  const TemporaryFolder folder;
  const auto grid = make_grid<openvdb::FloatGrid>("density");
  const std::string path = folder.path() / "a.vdb";
  {
    std::ofstream file(path, std::ios::binary);
    openvdb::io::Stream(file).write(openvdb::GridCPtrVec{grid});
  }
  require_same(read_volume(path), *grid);
}

TEMPLATE_TEST_CASE("NanoVDB grids are read as they were made, whatever their compression", "[io]", float,
                   double, std::int32_t, std::int64_t) {
  openvdb::initialize();
  using Grid = openvdb::Grid<typename openvdb::tree::Tree4<TestType, 5, 4, 3>::Type>;
  const TemporaryFolder folder;
  const auto grid = make_grid<Grid>("density");
  const std::string path = folder.path() / "a.nvdb";
  const auto handle = nanovdb::openToNanoVDB<nanovdb::HostBuffer, typename Grid::TreeType, TestType>(*grid);
  for (const auto codec : {nanovdb::io::Codec::NONE, nanovdb::io::Codec::ZIP, nanovdb::io::Codec::BLOSC}) {
    nanovdb::io::writeGrid(path, handle, codec);
    const Volume volume = read_volume(path);
    CHECK(volume.mapped == (codec == nanovdb::io::Codec::NONE));
    require_same(volume, *grid);
  }
}
