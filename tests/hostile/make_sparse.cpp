// Sparse files, written by OpenVDB and NanoVDB themselves.
#define NANOVDB_USE_ZIP
#define NANOVDB_USE_BLOSC
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>
#include <openvdb/openvdb.h>

#include "made_file.h"

namespace isocast::hostile {
namespace {

// A few leaves, a tile of each size, and inactive samples.
template <class Grid> typename Grid::Ptr make_grid(const std::string& name) {
  using T = typename Grid::ValueType;
  const typename Grid::Ptr grid = Grid::create(T(5));
  auto& tree = grid->tree();
  for (int x = -9; x < 17; ++x)
    for (int y = 0; y < 8; y += 1 + (x & 1))
      for (int z = -3; z < 12; ++z) tree.setValue({x, y, z}, static_cast<T>((x * x + y * 3 + z) % 11));
  tree.addTile(1, {256, 0, 0}, T(2), true);
  tree.addTile(2, {0, 128, 0}, T(3), true);
  tree.addTile(3, {4096, 0, 0}, T(4), false);
  grid->setName(name);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(0.5));
  return grid;
}

class Writer {
 public:
  explicit Writer(const std::filesystem::path& folder) : path_(folder / "made") {}

  void vdb(const std::string& name, const openvdb::GridCPtrVec& grids, std::uint32_t compression) {
    openvdb::io::File file(path_);
    file.setCompression(compression);
    file.write(grids);
    file.close();
    take(name, 700);
  }
  template <class Code>
  void nanovdb(const std::string& name, ::nanovdb::io::Codec codec, ::nanovdb::GridClass kind) {
    using Value = typename ::nanovdb::BuildToValueMap<Code>::Type;
    ::nanovdb::GridBuilder<Value, Code> builder(Value(5), kind);
    auto samples = builder.getAccessor();
    for (int x = -9; x < 17; ++x)
      for (int y = 0; y < 8; y += 1 + (x & 1))
        for (int z = 0; z < 15; ++z)
          samples.setValue({x, y, z}, static_cast<Value>((x * x + y * 3 + z) % 11));
    ::nanovdb::io::writeGrid(path_, builder.template getHandle<>(0.5, {0, 0, 0}, "made"), codec);
    take(name, codec == ::nanovdb::io::Codec::NONE ? 1400 : 200);
  }
  std::vector<MadeFile> files;

 private:
  void take(const std::string& name, std::size_t head) {
    const std::string bytes = bytes_of(path_);
    files.push_back({name, bytes, std::min(head, bytes.size()), bytes.size()});
    std::filesystem::remove(path_);
  }
  std::string path_;
};

}  // namespace

std::vector<MadeFile> make_sparse_files(const std::filesystem::path& folder) {
  openvdb::initialize();
  using namespace openvdb::io;
  Writer to(folder);
  const auto grid = make_grid<openvdb::FloatGrid>("made");
  to.vdb("plain.vdb", {grid}, COMPRESS_NONE);
  to.vdb("active.vdb", {grid}, COMPRESS_ACTIVE_MASK);
  to.vdb("zip.vdb", {grid}, COMPRESS_ZIP | COMPRESS_ACTIVE_MASK);
  to.vdb("blosc.vdb", {grid}, COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK);
  to.vdb("int64.vdb", {make_grid<openvdb::Int64Grid>("whole")}, COMPRESS_BLOSC);
  const auto shared = grid->copyGrid();
  shared->setName("shared");
  to.vdb("shared.vdb", {grid, shared, make_grid<openvdb::Int32Grid>("other")}, COMPRESS_ACTIVE_MASK);
  const auto half = grid->deepCopy();
  half->setSaveFloatAsHalf(true);
  to.vdb("half.vdb", {half}, COMPRESS_ZIP);

  using ::nanovdb::GridClass, ::nanovdb::io::Codec;
  to.nanovdb<float>("plain.nvdb", Codec::NONE, GridClass::LevelSet);
  to.nanovdb<std::int16_t>("zip.nvdb", Codec::ZIP, GridClass::Unknown);
  to.nanovdb<double>("blosc.nvdb", Codec::BLOSC, GridClass::FogVolume);
  to.nanovdb<::nanovdb::Fp4>("fp4.nvdb", Codec::NONE, GridClass::LevelSet);
  to.nanovdb<::nanovdb::FpN>("fpn.nvdb", Codec::NONE, GridClass::Unknown);
  return to.files;
}

}  // namespace isocast::hostile
