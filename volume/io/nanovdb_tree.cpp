#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/nanovdb_tree.h>
#include <isocast/volume/io/sparse_volume.h>
#include <nanovdb/NanoVDB.h>

#include <algorithm>
#include <cstring>

namespace isocast {
namespace {

using Point = std::array<std::int32_t, 3>;

// Fields of NanoVDB's structures at byte offsets of a grid, which need not be aligned.
class GridBytes {
 public:
  explicit GridBytes(std::span<const std::byte> bytes) : bytes_(bytes) {}

  const std::byte* at(std::uint64_t offset, std::uint64_t size, const char* what) const {
    if (offset > bytes_.size() || size > bytes_.size() - offset)
      throw SparseTreeError(fmt::format("{} at bytes {} to {} of a grid of {} bytes", what, offset,
                                        offset + size, bytes_.size()));
    return bytes_.data() + offset;
  }
  template <class N> N number(std::uint64_t offset, const char* what) const {
    N value;
    std::memcpy(&value, at(offset, sizeof value, what), sizeof value);
    return value;
  }
  // Bytes from `node` by a signed offset.
  std::uint64_t follow(std::uint64_t node, std::int64_t offset, const char* what) const {
    std::int64_t to = 0;
    if (__builtin_add_overflow(static_cast<std::int64_t>(node), offset, &to) || to < 0)
      throw SparseTreeError(fmt::format("{} {} bytes from byte {}, before its grid", what, offset, node));
    return static_cast<std::uint64_t>(to);
  }
  // No grid has more nodes of a kind than fit into it side by side.
  void count(std::uint64_t& met, std::uint64_t size, const char* what) const {
    if (++met > bytes_.size() / size) throw SparseTreeError(fmt::format("{} more than once", what));
  }

 private:
  std::span<const std::byte> bytes_;
};

bool bit(const std::byte* mask, std::uint32_t n) { return std::uint32_t(mask[n >> 3]) >> (n & 7) & 1; }

// The nodes of a grid whose NanoVDB type is Build.
template <class Build> class TreeParts {
  using Leaf = typename nanovdb::NanoLeaf<Build>::DataType;
  using Lower = typename nanovdb::NanoLower<Build>::DataType;
  using Upper = typename nanovdb::NanoUpper<Build>::DataType;
  using Root = typename nanovdb::NanoRoot<Build>::DataType;
  using Value = typename Leaf::ValueType;
  static constexpr bool kCoded = !std::is_arithmetic_v<Build>;

 public:
  std::vector<SparseLeaf> leaves;
  std::vector<TileBlock> tiles;
  std::uint64_t background;

  TreeParts(const GridBytes& bytes, std::uint64_t root) : bytes_(bytes) {
    background = bits(root + offsetof(Root, mBackground));
    const auto count = bytes_.template number<std::uint32_t>(root + offsetof(Root, mTableSize), "its root");
    for (std::uint32_t n = 0; n < count; ++n) {
      const std::uint64_t tile = root + sizeof(Root) + n * sizeof(typename Root::Tile);
      const auto key = bytes_.template number<std::uint64_t>(tile, "its root's table");
      const auto coordinate = [&](int shift) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(key >> shift & 0x1fffff) << 12);
      };
      const Point origin = {coordinate(42), coordinate(21), coordinate(0)};
      const auto child = bytes_.template number<std::int64_t>(tile + offsetof(typename Root::Tile, child),
                                                              "its root's table");
      if (child != 0) {
        add_node<Upper>(bytes_.follow(root, child, "an upper node"), origin, upper_, 5, 7, "an upper node");
        continue;
      }
      const auto state = bytes_.template number<std::uint32_t>(tile + offsetof(typename Root::Tile, state),
                                                               "its root's table");
      add_tile(origin, 12, bits(tile + offsetof(typename Root::Tile, value)), state != 0);
    }
  }

 private:
  std::uint64_t bits(std::uint64_t at) const {
    const auto value = bytes_.template number<Value>(at, "a value");
    std::uint64_t result = 0;
    std::memcpy(&result, &value, sizeof value);
    return result;
  }
  void add_tile(const Point& origin, std::int32_t edge, std::uint64_t value, bool active) {
    if (active || value != background) tiles.push_back({origin, edge, {value, active}});
  }

  // An upper or lower node with 2^log2 children along an edge, each of 2^edge samples.
  template <class Node>
  void add_node(std::uint64_t at, const Point& origin, std::uint64_t& met, int log2, int edge,
                const char* what) {
    bytes_.count(met, sizeof(Node), what);
    const std::byte* const node = bytes_.at(at, sizeof(Node), what);
    const int low = (1 << log2) - 1;
    for (int n = 0; n < 1 << 3 * log2; ++n) {
      const std::uint64_t entry =
          offsetof(Node, mTable) + static_cast<std::uint64_t>(n) * sizeof(typename Node::Tile);
      const bool child = bit(node + offsetof(Node, mChildMask), n),
                 active = bit(node + offsetof(Node, mValueMask), n);
      const Point place = {origin[0] + ((n >> 2 * log2) << edge), origin[1] + ((n >> log2 & low) << edge),
                           origin[2] + ((n & low) << edge)};
      if (!child) {
        add_tile(place, edge, bits(at + entry), active);
        continue;
      }
      const std::uint64_t to =
          bytes_.follow(at, bytes_.template number<std::int64_t>(at + entry, what), "a child");
      if constexpr (std::is_same_v<Node, Upper>) add_node<Lower>(to, place, lower_, 4, 3, "a lower node");
      else add_leaf(to, place);
    }
  }

  void add_leaf(std::uint64_t at, const Point& origin) {
    using Base = nanovdb::LeafFnBase<nanovdb::Coord, nanovdb::Mask, 3>;
    constexpr const char* kWhat = "a leaf";
    bytes_.count(leaf_, sizeof(Leaf), kWhat);
    const std::byte* const leaf = bytes_.at(at, sizeof(Leaf), kWhat);
    const std::byte* const active = leaf + offsetof(Base, mValueMask);
    if constexpr (kCoded) {
      int code_bits = 0;
      if constexpr (std::is_same_v<Build, nanovdb::FpN>) {
        const int log2 = static_cast<int>(leaf[offsetof(Base, mFlags)]) >> 5;
        if (log2 > 4)
          throw SparseTreeError(fmt::format("a leaf of {} bits a code, expected 1 to 16", 1 << log2));
        code_bits = 1 << log2;
      } else {
        code_bits = Leaf::bitWidth();
      }
      bytes_.at(at, sizeof(Base) + static_cast<std::uint64_t>(code_bits) * 64, kWhat);
      leaves.push_back(
          {leaf + offsetof(Base, mMinimum), active, {origin[0], origin[1], origin[2]}, code_bits});
    } else {
      leaves.push_back({leaf + offsetof(Leaf, mValues), active, {origin[0], origin[1], origin[2]}, 0});
    }
  }

  GridBytes bytes_;
  std::uint64_t upper_ = 0, lower_ = 0, leaf_ = 0;
};

template <class Build>
void set_parts(Volume& volume, SparseType type, const GridBytes& bytes, std::uint64_t root,
               std::shared_ptr<const void> storage) {
  const TreeParts<Build> parts(bytes, root);
  set_tree(volume, type, parts.background, parts.leaves, parts.tiles, std::move(storage));
}

void place(Volume& volume, const GridBytes& bytes) {
  using nanovdb::GridData, nanovdb::Map;
  for (int r = 0; r < 3; ++r) {
    const std::uint64_t map = offsetof(GridData, mMap);
    for (int c = 0; c < 3; ++c)
      volume.world_from_grid.m[r][c] = bytes.number<double>(
          map + offsetof(Map, mMatD) + static_cast<std::uint64_t>(3 * r + c) * 8, "its map");
    volume.world_from_grid.m[r][3] =
        bytes.number<double>(map + offsetof(Map, mVecD) + static_cast<std::uint64_t>(r) * 8, "its map");
  }
}

}  // namespace

void set_nanovdb_tree(Volume& volume, std::span<const std::byte> grid, std::shared_ptr<const void> storage) {
  using nanovdb::GridData, nanovdb::GridType, nanovdb::TreeData;
  const GridBytes bytes(grid);
  bytes.at(0, sizeof(GridData) + sizeof(TreeData<3>), "its header");
  if (const auto magic = bytes.number<std::uint64_t>(0, "its magic number"); magic != NANOVDB_MAGIC_NUMBER)
    throw SparseTreeError(
        fmt::format("the magic number {:#x}, expected NanoVDB's {:#x}", magic, NANOVDB_MAGIC_NUMBER));
  const auto version = bytes.number<std::uint32_t>(offsetof(GridData, mVersion), "its version") >> 21;
  if (version != NANOVDB_MAJOR_VERSION_NUMBER)
    throw SparseTreeError(fmt::format("the version {}, expected {}", version, NANOVDB_MAJOR_VERSION_NUMBER));
  place(volume, bytes);
  const char* const name = reinterpret_cast<const char*>(grid.data()) + offsetof(GridData, mGridName);
  volume.grid_name.assign(name, std::find(name, name + GridData::MaxNameSize, '\0'));
  const auto grid_class = bytes.number<std::uint32_t>(offsetof(GridData, mGridClass), "its class");
  if (grid_class == static_cast<std::uint32_t>(nanovdb::GridClass::LevelSet)) volume.grid_class = "level set";
  if (grid_class == static_cast<std::uint32_t>(nanovdb::GridClass::FogVolume))
    volume.grid_class = "fog volume";

  const std::uint64_t tree = sizeof(GridData);
  const auto to_root = bytes.number<std::uint64_t>(tree + 3 * sizeof(std::uint64_t), "its tree");
  const std::uint64_t root = bytes.follow(tree, static_cast<std::int64_t>(to_root), "its root");
  const auto type = bytes.number<std::uint32_t>(offsetof(GridData, mGridType), "its type");
  const auto use = [&]<class Build>(SparseType sparse) {
    set_parts<Build>(volume, sparse, bytes, root, storage);
  };
  switch (static_cast<GridType>(type)) {
    case GridType::Float: return use.operator()<float>(SparseType::f32);
    case GridType::Double: return use.operator()<double>(SparseType::f64);
    case GridType::Int16: return use.operator()<std::int16_t>(SparseType::i16);
    case GridType::Int32: return use.operator()<std::int32_t>(SparseType::i32);
    case GridType::Int64: return use.operator()<std::int64_t>(SparseType::i64);
    case GridType::Fp4: return use.operator()<nanovdb::Fp4>(SparseType::fp4);
    case GridType::Fp8: return use.operator()<nanovdb::Fp8>(SparseType::fp8);
    case GridType::Fp16: return use.operator()<nanovdb::Fp16>(SparseType::fp16);
    case GridType::FpN: return use.operator()<nanovdb::FpN>(SparseType::fpn);
    default:
      throw SparseTreeError(fmt::format(
          "the type {}, expected Float, Double, Int16, Int32, Int64, Fp4, Fp8, Fp16 or FpN", type));
  }
}

}  // namespace isocast
