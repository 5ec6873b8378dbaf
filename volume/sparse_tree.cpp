#include <fmt/format.h>
#include <isocast/volume/sparse_tree.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <unordered_map>

namespace isocast {
namespace {

using Point = std::array<std::int32_t, 3>;

Point block_of(const Point& p, std::int32_t shift) { return {p[0] >> shift, p[1] >> shift, p[2] >> shift}; }

struct BlockHash {
  std::size_t operator()(const Point& b) const { return root_hash({b[0], b[1], b[2]}); }
};
// Numbers blocks in the order in which they are first asked for.
class Numbering {
 public:
  std::uint32_t of(const Point& block) {
    if (block != last_ || numbers_.empty()) {
      last_ = block;
      number_ = numbers_.try_emplace(block, static_cast<std::uint32_t>(numbers_.size())).first->second;
    }
    return number_;
  }
  [[nodiscard]] const auto& all() const { return numbers_; }

 private:
  std::unordered_map<Point, std::uint32_t, BlockHash> numbers_;
  Point last_ = {};
  std::uint32_t number_ = 0;
};

std::size_t place_in_upper(const Point& lower) {
  return std::size_t((lower[0] & 31) << 10 | (lower[1] & 31) << 5 | (lower[2] & 31));
}
std::size_t place_in_lower(const Point& leaf) {
  return std::size_t((leaf[0] & 15) << 8 | (leaf[1] & 15) << 4 | (leaf[2] & 15));
}

void check_origin(const Point& origin, std::int32_t edge) {
  for (const std::int32_t x : origin)
    if ((x & ((1 << edge) - 1)) != 0 || x < -kMaxGridPoint || x > kMaxGridPoint - (1 << edge))
      throw SparseTreeError(fmt::format(
          "a block of {}^3 samples starts at ({}, {}, {}), expected multiples of {} within {} of the origin",
          1 << edge, origin[0], origin[1], origin[2], 1 << edge, kMaxGridPoint));
}

void fill(SparseEntry& place, SparseEntry entry, const Point& origin) {
  if (place.bits != 0)
    throw SparseTreeError(
        fmt::format("two blocks hold the samples at ({}, {}, {})", origin[0], origin[1], origin[2]));
  place = entry;
}

}  // namespace

std::string_view name_of(SparseType type) {
  constexpr std::string_view names[] = {"f32", "f64", "i16", "i32", "i64", "fp4", "fp8", "fp16", "fpn"};
  return names[static_cast<int>(type)];
}

std::size_t leaf_bytes(SparseType type, int code_bits) {
  return visit_sparse_type(type, [&]<class S>(SparseTag<S>) -> std::size_t {
    if constexpr (std::is_arithmetic_v<S>) return kLeafSamples * sizeof(S);
    else return 16 + std::size_t(code_bits) * kLeafSamples / 8;
  });
}

void SparseTree::FreeEntries::operator()(SparseEntry* entries) const { std::free(entries); }

// Pages that stay untouched, as most of a scattered tree's, take no memory.
SparseTree::Entries SparseTree::zeroed(std::size_t count) {
  Entries entries(
      static_cast<SparseEntry*>(std::calloc(std::max<std::size_t>(count, 1), sizeof(SparseEntry))));
  if (!entries) throw std::bad_alloc();
  return entries;
}

SparseEntry& SparseTree::root_entry(const std::int32_t (&block)[3]) {
  std::uint32_t slot = root_hash(block) & view_.root_mask;
  while (root_[slot].used && !std::ranges::equal(root_[slot].block, block))
    slot = (slot + 1) & view_.root_mask;
  if (!root_[slot].used) root_[slot] = {{block[0], block[1], block[2]}, {}, 1};
  return root_[slot].entry;
}

SparseTree::SparseTree(SparseType type, std::uint64_t background, std::span<const SparseLeaf> leaves,
                       std::span<const TileBlock> tiles, std::shared_ptr<const void> storage)
    : storage_(std::move(storage)), leaves_(leaves.begin(), leaves.end()) {
  first_.fill(kMaxGridPoint);
  last_.fill(-kMaxGridPoint);
  if (std::max(leaves.size(), tiles.size()) >= SparseEntry::kChild - 1)
    throw SparseTreeError("a tree of more than 2^31 blocks");

  // which blocks are needed above the leaves and the smaller tiles
  Numbering upper, lower, root;
  const auto count_above = [&](const Point& origin, std::int32_t edge) {
    check_origin(origin, edge);
    root.of(block_of(origin, kTreeShifts[0]));
    if (edge < kTreeShifts[0]) upper.of(block_of(origin, kTreeShifts[0]));
    if (edge < kTreeShifts[1]) lower.of(block_of(origin, kTreeShifts[1]));
  };
  const auto origin_of = [](const SparseLeaf& leaf) {
    return Point{leaf.origin[0], leaf.origin[1], leaf.origin[2]};
  };
  for (const SparseLeaf& leaf : leaves) count_above(origin_of(leaf), kTreeShifts[2]);
  for (const TileBlock& tile : tiles) count_above(tile.origin, tile.edge);
  upper_count_ = upper.all().size();
  lower_count_ = lower.all().size();
  upper_ = zeroed(upper_count_ * kUpperEntries);
  lower_ = zeroed(lower_count_ * kLowerEntries);

  // the root is at most half full
  const std::size_t slots = std::bit_ceil(2 * root.all().size() + 1);
  if (slots > SparseEntry::kChild) throw SparseTreeError("a root of more than 2^30 blocks");
  root_.resize(slots);
  view_.root_mask = static_cast<std::uint32_t>(slots - 1);
  for (const auto& [block, number] : upper.all())
    root_entry({block[0], block[1], block[2]}).bits = SparseEntry::kChild | number;
  for (const auto& [block, number] : lower.all())
    upper_[upper.of(block_of(block, 5)) * kUpperEntries + place_in_upper(block)].bits =
        SparseEntry::kChild | number;

  // tile 0 is the background; neighbours often share a value
  tiles_.push_back({background, 0});
  for (const TileBlock& block : tiles) {
    if (block.tile.active) {
      active_tiles_.push_back(block);
      const std::int32_t reach = (1 << block.edge) - 1;
      add_bounds(block.origin, {block.origin[0] + reach, block.origin[1] + reach, block.origin[2] + reach});
      active_count_ += std::ldexp(1.0, 3 * block.edge);
    }
    if (block.tile.value == background && !block.tile.active) continue;
    if (tiles_.back().value != block.tile.value || tiles_.back().active != block.tile.active)
      tiles_.push_back(block.tile);
    const SparseEntry entry{static_cast<std::uint32_t>(tiles_.size() - 1)};
    const Point& o = block.origin;
    if (block.edge == kTreeShifts[0]) {
      const Point b = block_of(o, kTreeShifts[0]);
      fill(root_entry({b[0], b[1], b[2]}), entry, o);
    } else if (block.edge == kTreeShifts[1]) {
      fill(upper_[upper.of(block_of(o, 12)) * kUpperEntries + place_in_upper(block_of(o, 7))], entry, o);
    } else {
      fill(lower_[lower.of(block_of(o, 7)) * kLowerEntries + place_in_lower(block_of(o, 3))], entry, o);
    }
  }
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const Point o = origin_of(leaves_[i]);
    fill(lower_[lower.of(block_of(o, 7)) * kLowerEntries + place_in_lower(block_of(o, 3))],
         {SparseEntry::kChild | static_cast<std::uint32_t>(i)}, o);
    count_active(leaves_[i]);
  }

  view_.root = root_.data();
  view_.type = type;
  view_.upper = upper_.get();
  view_.lower = lower_.get();
  view_.leaves = leaves_.data();
  view_.tiles = tiles_.data();
}

void SparseTree::add_bounds(const Point& first, const Point& last) {
  for (int a = 0; a < 3; ++a) {
    first_[a] = std::min(first_[a], first[a]);
    last_[a] = std::max(last_[a], last[a]);
  }
}

// A byte of the mask is a row of eight samples along z.
void SparseTree::count_active(const SparseLeaf& leaf) {
  std::uint8_t rows[64], any_z = 0;
  std::memcpy(rows, leaf.active, sizeof rows);
  Point first = {8, 8, 8}, last = {-1, -1, -1};
  for (int row = 0; row < 64; ++row) {
    if (rows[row] == 0) continue;
    any_z |= rows[row];
    active_count_ += std::popcount(rows[row]);
    first[0] = std::min(first[0], row >> 3);
    last[0] = std::max(last[0], row >> 3);
    first[1] = std::min(first[1], row & 7);
    last[1] = std::max(last[1], row & 7);
  }
  if (any_z == 0) return;
  first[2] = std::countr_zero(any_z);
  last[2] = 7 - std::countl_zero(any_z);
  for (int a = 0; a < 3; ++a) {
    first[a] += leaf.origin[a];
    last[a] += leaf.origin[a];
  }
  add_bounds(first, last);
}

std::size_t SparseTree::bytes() const {
  std::size_t bytes = (upper_count_ * kUpperEntries + lower_count_ * kLowerEntries) * sizeof(SparseEntry) +
                      root_.size() * sizeof(SparseRootSlot) + tiles_.size() * sizeof(SparseTile) +
                      active_tiles_.size() * sizeof(TileBlock);
  for (const SparseLeaf& leaf : leaves_) bytes += leaf_bytes(view_.type, leaf.code_bits) + 64 + sizeof leaf;
  return bytes;
}

}  // namespace isocast
