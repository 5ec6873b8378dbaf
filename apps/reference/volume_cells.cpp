#include <fmt/format.h>
#include <isocast/base/hash.h>
#include <isocast/apps/reference/volume_cells.h>
#include <isocast/base/error.h>
#include <isocast/volume/grid.h>
#include <isocast/volume/sample.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace isocast::reference {
namespace {

template <class S> class DenseCells final : public VolumeCells {
 public:
  explicit DenseCells(std::shared_ptr<const Volume> volume) : volume_(std::move(volume)) {
    const auto& dims = volume_->dims;
    for (std::size_t a = 0; a < 3; ++a) {
      if (dims[a] < 2 || dims[a] > kMaxDim)
        throw InputError(
            fmt::format("a volume of {} x {} x {} samples has no reference: 2 to {} per axis are needed",
                        dims[0], dims[1], dims[2], kMaxDim));
      first[a] = 0;
      last[a] = static_cast<std::int32_t>(dims[a] - 1);
    }
    int shift = 0;
    while (std::int64_t{1} << shift < *std::ranges::max_element(last)) ++shift;
    blocks = {{{0, 0, 0}, shift}};
  }

  bool corners(const Cell& c, double (&f)[8]) const override {
    const auto& dims = volume_->dims;
    const S* const samples = reinterpret_cast<const S*>(volume_->samples);
    bool finite = true;
    for (int k = 0; k < 8; ++k) {
      const std::int64_t x = c[0] + (k & 1), y = c[1] + (k >> 1 & 1), z = c[2] + (k >> 2);
      f[k] = static_cast<double>(number(samples[x + dims[0] * (y + dims[1] * z)]));
      finite = finite && std::isfinite(f[k]);
    }
    return finite;
  }
  std::optional<double> uniform(const CellBlock&) const override { return std::nullopt; }
  std::string identity() const override {
    Hash hash;
    hash.add(std::span(volume_->samples, static_cast<std::size_t>(volume_->bytes())));
    const auto& dims = volume_->dims;
    return fmt::format("{} {} {} {} {}", name_of(volume_->type), dims[0], dims[1], dims[2], hash.text());
  }

 private:
  std::shared_ptr<const Volume> volume_;
};

template <class S> class SparseCells final : public VolumeCells {
 public:
  explicit SparseCells(std::shared_ptr<const Volume> volume)
      : volume_(std::move(volume)), view_(volume_->tree->view()) {
    const SparseTree& tree = *volume_->tree;
    first = tree.first_active(), last = tree.last_active();
    if (first[0] > last[0]) return;
    for (std::size_t a = 0; a < 3; ++a) --first[a], ++last[a];
    // blocks of the root, and their lower neighbours, whose last cells reach into them
    std::set<Cell> origins;
    for (const SparseRootSlot& slot : tree.root())
      for (int k = 0; slot.used && k < 8; ++k)
        origins.insert({(slot.block[0] - (k & 1)) << kTreeShifts[0],
                        (slot.block[1] - (k >> 1 & 1)) << kTreeShifts[0],
                        (slot.block[2] - (k >> 2)) << kTreeShifts[0]});
    for (const Cell& origin : origins) blocks.push_back({origin, kTreeShifts[0]});
  }

  bool corners(const Cell& c, double (&f)[8]) const override {
    bool finite = true, any_active = false;
    for (int k = 0; k < 8; ++k) {
      const std::int32_t p[3] = {c[0] + (k & 1), c[1] + (k >> 1 & 1), c[2] + (k >> 2)},
                         block[3] = {p[0] >> 3, p[1] >> 3, p[2] >> 3};
      const SparseEntry entry = find_entry(view_, kTreeLevels - 1, block).entry;
      f[k] = static_cast<double>(sample_at<S>(view_, p));
      finite = finite && std::isfinite(f[k]);
      any_active = any_active ||
                   (entry.is_child() ? leaf_active(view_.leaves[entry.index()], leaf_index(p[0], p[1], p[2]))
                                     : view_.tiles[entry.index()].active != 0);
    }
    return finite && any_active;
  }
  // The block's samples and those at its far faces lie in eight blocks of the tree, or fewer: all tiles of
  // one value?
  std::optional<double> uniform(const CellBlock& block) const override {
    if (block.shift < kTreeShifts[kTreeLevels - 1]) return std::nullopt;
    int level = kTreeLevels - 1;
    while (level > 0 && kTreeShifts[level] < block.shift) --level;
    std::optional<double> value;
    bool any_active = false;
    for (int k = 0; k < 8; ++k) {
      std::int32_t b[3];
      for (int a = 0; a < 3; ++a)
        b[a] =
            (block.origin[static_cast<std::size_t>(a)] + ((k >> a & 1) << block.shift)) >> kTreeShifts[level];
      const SparseEntry entry = find_entry(view_, level, b).entry;
      if (entry.is_child()) return std::nullopt;
      const SparseTile& tile = view_.tiles[entry.index()];
      const auto own = static_cast<double>(tile_value<S>(tile));
      if (value && !(own == *value)) return std::nullopt;
      value = own;
      any_active = any_active || tile.active;
    }
    return any_active ? value : std::numeric_limits<double>::quiet_NaN();
  }
  std::string identity() const override {
    Hash hash;
    const auto add_entries = [&](const SparseEntry* entries, std::size_t count) {
      hash.add(std::span(entries, count));
      for (std::size_t i = 0; i < count; ++i)
        if (!entries[i].is_child()) hash.add(std::span(view_.tiles + entries[i].index(), 1));
    };
    const SparseTree& tree = *volume_->tree;
    for (const SparseRootSlot& slot : tree.root()) {
      if (!slot.used) continue;
      hash.add(std::span(slot.block));
      add_entries(&slot.entry, 1);
    }
    hash.add(std::span(view_.tiles, 1));  // the background
    add_entries(view_.upper, tree.upper_count() * kUpperEntries);
    add_entries(view_.lower, tree.lower_count() * kLowerEntries);
    for (const SparseLeaf& leaf : tree.leaves()) {
      hash.add(std::span(leaf.origin));
      hash.add(std::span(&leaf.code_bits, 1));
      hash.add(std::span(leaf.values, leaf_bytes(tree.type(), leaf.code_bits)));
      hash.add(std::span(leaf.active, kLeafSamples / 8));
    }
    return fmt::format("sparse {} {}", name_of(tree.type()), hash.text());
  }

 private:
  std::shared_ptr<const Volume> volume_;
  const SparseView& view_;
};

}  // namespace

std::unique_ptr<VolumeCells> cells_of(std::shared_ptr<const Volume> volume) {
  if (volume->tree)
    return visit_sparse_type(volume->tree->type(),
                             [&]<class S>(SparseTag<S>) -> std::unique_ptr<VolumeCells> {
                               return std::make_unique<SparseCells<S>>(volume);
                             });
  return visit_sample_type(volume->type, [&]<class S>(SampleTag<S>) -> std::unique_ptr<VolumeCells> {
    return std::make_unique<DenseCells<S>>(volume);
  });
}

}  // namespace isocast::reference
