#include <isocast/implicit/beams/pruned_block.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/math/rounding.h>
#include <isocast/render/camera.h>

#include <array>

namespace isocast {
namespace {

// Tapes of so few instructions are not pruned further.
constexpr std::size_t kShort = 24;
constexpr int kMostLevels = 8;

}  // namespace

template <class T>
PrunedBlock<T>::PrunedBlock(const FormulaQuery<T>& query, const FormulaPassInputs& inputs,
                            const BlockKernels<T>& kernels, const Box& domain, const BlockRays<T>& rays,
                            BlockRoots<T>& roots)
    : query_(query),
      inputs_(inputs),
      kernels_(kernels),
      domain_(domain),
      rays_(rays),
      roots_(roots),
      registers_(registers_of(inputs.tape.registers * kernels.register_bytes)) {}

template <class T>
void PrunedBlock<T>::search(const Tape& tape, int x, int y, int size, DepthRange<T> part, int level) {
  if (roots_.is_unwanted() || x >= rays_.columns || y >= rays_.rows || !meets(x, y, size, part)) return;
  const Tape& mine = pruned(tape, x, y, size, widened(part), level);
  const bool is_long = mine.code.size() > kShort && level + 1 < kMostLevels;
  const T width = T(size) * (rays_.pixel + part.to * rays_.pixel_spread),
          middle = T(0.5) * (part.from + part.to);
  if (is_long && part.length() > width) {
    search(mine, x, y, size, {part.from, middle}, level + 1);
    search(mine, x, y, size, {middle, part.to}, level + 1);
  } else if (is_long && size > kTileSize) {
    const int half = size / 2;
    for (int q = 0; q < 4; ++q) search(mine, x + q % 2 * half, y + q / 2 * half, half, part, level + 1);
  } else {
    query_.tape = mine.view();
    kernels_.trace(query_, rays_, node_of(x, y, size, part), widened(part), roots_, registers_);
    for (int v = y; v < y + size; v += kTileSize)
      for (int u = x; u < x + size; u += kTileSize)
        kernels_.polish(query_, rays_, pixel_slot(u, v) / kStreamSize, part, roots_, registers_);
  }
}

template <class T> DepthRange<T> PrunedBlock<T>::widened(DepthRange<T> part) const {
  const T over = part.length() / 8 + rays_.eps;
  return {part.from - over, part.to + over};
}
template <class T> bool PrunedBlock<T>::meets(int x, int y, int size, DepthRange<T> part) const {
  const Box box = BlockFrame::box_around(rays_, x, y, size, part);
  for (int a = 0; a < 3; ++a)
    if (box.lo[a] > domain_.hi[a] || box.hi[a] < domain_.lo[a]) return false;
  return true;
}

template <class T>
const Tape& PrunedBlock<T>::pruned(const Tape& tape, int x, int y, int size, DepthRange<T> part, int level) {
  thread_local std::array<Pruner<T>, kMostLevels> pruners;
  const Box around = BlockFrame::box_around(rays_, x, y, size, part);
  Interval<double> box[3];
  for (int a = 0; a < 3; ++a) box[a] = Interval<double>(around.lo[a], around.hi[a]);
  return pruners[static_cast<std::size_t>(level)].prune(tape, box, query_.time, inputs_.levels);
}

template class PrunedBlock<float>;
template class PrunedBlock<double>;

}  // namespace isocast
