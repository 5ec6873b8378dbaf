// Sparse volumes made in memory for tests, with the plainest possible look at their samples.
#pragma once

#include <isocast/volume/volume.h>

#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace isocast::test {

using GridPoint = std::array<std::int32_t, 3>;

/// The bits of a value in a type of numbers; of a float for codes.
inline std::uint64_t bits_in(SparseType type, double value) {
  return visit_sparse_type(type, [&]<class S>(SparseTag<S>) {
    const auto number = static_cast<typename SparseSample<S>::Type>(value);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof number);
    return bits;
  });
}

/// Leaves and tiles by name of their samples; numbers only, no codes.
class TreeMaker {
 public:
  explicit TreeMaker(SparseType type, double background = 0) : type_(type), background_(background) {}

  /// A sample of a leaf, which comes into being with the background in its other samples.
  void set(const GridPoint& p, double value, bool active) {
    Leaf& leaf = leaves_.try_emplace({p[0] >> 3, p[1] >> 3, p[2] >> 3}, background_).first->second;
    const int n = leaf_index(p[0], p[1], p[2]);
    leaf.values[static_cast<std::size_t>(n)] = value;
    leaf.active[static_cast<std::size_t>(n)] = active;
  }
  void tile(const GridPoint& origin, std::int32_t edge, double value, bool active) {
    tiles_.push_back({origin, edge, {bits_in(type_, value), active}});
    tile_values_.push_back(value);
  }

  struct Sample {
    double value;
    bool active;
  };
  [[nodiscard]] Sample at(const GridPoint& p) const {
    if (const auto leaf = leaves_.find({p[0] >> 3, p[1] >> 3, p[2] >> 3}); leaf != leaves_.end()) {
      const auto n = static_cast<std::size_t>(leaf_index(p[0], p[1], p[2]));
      return {leaf->second.values[n], leaf->second.active[n] != 0};
    }
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a)
        inside = inside && p[a] >> tiles_[i].edge == tiles_[i].origin[a] >> tiles_[i].edge;
      if (inside) return {tile_values_[i], tiles_[i].tile.active != 0};
    }
    return {background_, false};
  }

  [[nodiscard]] std::shared_ptr<Volume> volume() const {
    const std::size_t size = leaf_bytes(type_, 0), stride = size + 64;
    auto buffer = std::make_shared<std::vector<std::byte>>(leaves_.size() * stride);
    std::vector<SparseLeaf> leaves;
    for (const auto& [block, leaf] : leaves_) {
      std::byte* const values = buffer->data() + leaves.size() * stride;
      for (std::size_t n = 0; n < kLeafSamples; ++n) {
        const std::uint64_t bits = bits_in(type_, leaf.values[n]);
        std::memcpy(values + n * size / kLeafSamples, &bits, size / kLeafSamples);
        if (leaf.active[n]) values[size + n / 8] |= std::byte(1 << n % 8);
      }
      leaves.push_back({values, values + size, {block[0] * 8, block[1] * 8, block[2] * 8}, 0});
    }
    auto volume = std::make_shared<Volume>();
    volume->tree = std::make_shared<SparseTree>(type_, bits_in(type_, background_), leaves, tiles_, buffer);
    for (std::size_t a = 0; a < 3; ++a)
      volume->dims[a] = volume->tree->last_active()[a] - volume->tree->first_active()[a] + 1;
    return volume;
  }

 private:
  struct Leaf {
    explicit Leaf(double background) : values(kLeafSamples, background), active(kLeafSamples, 0) {}
    std::vector<double> values;
    std::vector<char> active;
  };
  SparseType type_;
  double background_;
  std::map<GridPoint, Leaf> leaves_;
  std::vector<TileBlock> tiles_;
  std::vector<double> tile_values_;
};

/// f at every grid point of 0...dims - 1, all active.
inline std::shared_ptr<Volume> make_full_tree(
    const GridPoint& dims, SparseType type, double background,
    const std::function<double(std::int64_t, std::int64_t, std::int64_t)>& f) {
  TreeMaker maker(type, background);
  for (std::int32_t k = 0; k < dims[2]; ++k)
    for (std::int32_t j = 0; j < dims[1]; ++j)
      for (std::int32_t i = 0; i < dims[0]; ++i) maker.set({i, j, k}, f(i, j, k), true);
  return maker.volume();
}

}  // namespace isocast::test
