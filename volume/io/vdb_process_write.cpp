// Writing through OpenVDB and NanoVDB.
#include <fmt/format.h>
#include <isocast/volume/io/vdb_process.h>
#include <nanovdb/util/IO.h>
#include <nanovdb/util/OpenToNanoVDB.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Prune.h>

#include <cstdio>
#include <stdexcept>

namespace isocast::vdb_process {
namespace {

void receive(void* bytes, std::size_t size) {
  if (std::fread(bytes, 1, size, stdin) != size) throw std::runtime_error("the grid to be written broke off");
}

template <class T> T value_of(std::uint64_t bits) {
  T value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

template <class Tree> void receive_tree(Tree& tree) {
  using Leaf = typename Tree::LeafNodeType;
  using T = typename Tree::ValueType;
  for (;;) {
    VdbPart part;
    receive(&part, sizeof part);
    const openvdb::Coord origin(part.block.origin[0], part.block.origin[1], part.block.origin[2]);
    if (part.kind == VdbPartKind::end) return;
    if (part.kind == VdbPartKind::tile) {
      const openvdb::Coord last = origin.offsetBy((1 << part.block.edge) - 1);
      tree.sparseFill({origin, last}, value_of<T>(part.block.tile.value), part.block.tile.active != 0);
      continue;
    }
    auto* const leaf = new Leaf(origin);
    receive(leaf->buffer().data(), sizeof(T) * kLeafSamples);
    typename Leaf::NodeMaskType active;
    receive(&active.template getWord<std::uint64_t>(0), 64);
    leaf->setValueMask(active);
    tree.addLeaf(leaf);
  }
}

template <class Code, class Grid> void write_nanovdb(const Grid& grid, const std::string& path) {
  using Tree = typename Grid::TreeType;
  nanovdb::io::writeGrid(path, nanovdb::openToNanoVDB<nanovdb::HostBuffer, Tree, Code>(grid));
}

template <class Grid> void write_codes(const Grid& grid, SparseType codes, const std::string& path) {
  using T = typename Grid::ValueType;
  if constexpr (std::is_same_v<T, float>) {
    if (codes == SparseType::fp4) return write_nanovdb<nanovdb::Fp4>(grid, path);
    if (codes == SparseType::fp8) return write_nanovdb<nanovdb::Fp8>(grid, path);
    if (codes == SparseType::fp16) return write_nanovdb<nanovdb::Fp16>(grid, path);
    if (codes == SparseType::fpn) return write_nanovdb<nanovdb::FpN>(grid, path);
  }
  write_nanovdb<T>(grid, path);
}

template <class T> void write_grid(const VdbOrder& order, const std::string& path) {
  using Grid = openvdb::Grid<typename openvdb::tree::Tree4<T, 5, 4, 3>::Type>;
  const typename Grid::Ptr grid = Grid::create(value_of<T>(order.background));
  openvdb::Mat4R world = openvdb::Mat4R::identity();  // of row vectors
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) world(c, r) = order.world_from_grid[r][c];
  grid->setTransform(openvdb::math::Transform::createLinearTransform(world));
  grid->setName(order.name);
  grid->setGridClass(order.level_set ? openvdb::GRID_LEVEL_SET : openvdb::GRID_UNKNOWN);
  receive_tree(grid->tree());
  openvdb::tools::prune(grid->tree());
  if (order.nanovdb) return write_codes(*grid, order.codes, path);
  openvdb::io::File(path).write({grid});
}

}  // namespace

void write(const std::string& path) {
  openvdb::initialize();
  VdbOrder order;
  receive(&order, sizeof order);
  order.name[sizeof order.name - 1] = 0;
  switch (order.type) {
    case SparseType::f32: return write_grid<float>(order, path);
    case SparseType::f64: return write_grid<double>(order, path);
    case SparseType::i16: return write_grid<std::int16_t>(order, path);
    case SparseType::i32: return write_grid<std::int32_t>(order, path);
    case SparseType::i64: return write_grid<std::int64_t>(order, path);
    default:
      throw std::runtime_error(fmt::format("a grid of codes ({}) was sent", static_cast<int>(order.type)));
  }
}

}  // namespace isocast::vdb_process
