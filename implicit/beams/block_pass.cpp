#include <isocast/implicit/beams/block_pass.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/render/camera.h>

#include <memory>

namespace isocast {

template <class T>
BlockPass<T>::BlockPass(const View& view, const FormulaQuery<T>& query, const FormulaPassInputs& inputs)
    : view_(view), query_(query), inputs_(inputs), frame_(view, inputs.surface.bounds()) {}

template <class T> BlockRoots<T>& BlockPass<T>::roots() {
  thread_local const auto memory = std::make_unique_for_overwrite<BlockRoots<T>>();
  return *memory;
}
template <class T> void* BlockPass<T>::registers() const {
  return registers_of(inputs_.tape.registers * kernels().register_bytes);
}

template <class T>
void BlockPass<T>::note_components(int tx, int ty, double offset_u, double offset_v, HitStream& found) const {
  if (!inputs_.components) return;
  RayStream rays;
  view_.fill(tx, ty, offset_u, offset_v, rays);
  for (int i = 0; i < kStreamSize; ++i)
    if (is_hit(found, i) && found.object[i] == inputs_.object)
      found.cell[0][i] =
          inputs_.components->at({rays.ox[i] + found.t[i] * rays.dx[i], rays.oy[i] + found.t[i] * rays.dy[i],
                                  rays.oz[i] + found.t[i] * rays.dz[i]},
                                 query_.time);
}

template class BlockPass<float>;
template class BlockPass<double>;

}  // namespace isocast
