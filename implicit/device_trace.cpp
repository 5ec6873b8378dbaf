// Rays of a formula that a device solves: many streams at a time, in one part.
#include <isocast/base/error.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/traced_ray.h>

namespace isocast {

void ImplicitSurface::use_device() {
  const FormulaMethodChoice& method = options_.method;
  const int isos = static_cast<int>(options_.iso.size());
  const bool casts = method.pass == FormulaPass::beam_uniform || method.pass == FormulaPass::beam_adaptive;
  const SegmentSolverKey key = {method.method, options_.double_precision, method.nearest, isos};
  const BeamCastKey beam_key = {casts ? method.affine_beams : method.method == FormulaMethod::affine,
                                options_.double_precision, isos};
  const bool other = options_.device != device_;
  if (!options_.device || method.has_form()) segment_solver_ = nullptr;
  else if (method.options.packets)
    throw InputError("--set packets=1 is for packets of rays, and --isa cuda solves them one by one");
  else if (other || !segment_solver_ || !(key == solver_key_))
    segment_solver_ = options_.device->solver_of(key, tape_);
  if (!segment_solver_ || !(casts || (method.pass == FormulaPass::certified && method.proves())))
    beam_caster_ = nullptr;
  else if (other || !beam_caster_ || !(beam_key == beam_key_))
    beam_caster_ = options_.device->beam_caster_of(beam_key, tape_);
  device_ = options_.device;
  solver_key_ = key, beam_key_ = beam_key;
}

template <class T>
void ImplicitSurface::trace_on_device(const FormulaQuery<T>& query, bool next,
                                      std::span<const RayStream> rays, std::span<HitStream* const> hits,
                                      TraceCounts& counts) const {
  struct Work {
    TracedRay traced[kStreamSize];
    TracedPart<T> part;
  };
  std::vector<std::unique_ptr<Work>> works;
  std::vector<std::size_t> streams;
  std::vector<const SegmentStream<T>*> segments;
  std::vector<SegmentRoots<T>*> roots;
  for (std::size_t s = 0; s < rays.size(); ++s) {
    auto work = std::make_unique_for_overwrite<Work>();
    begin(next, rays[s], *hits[s], work->traced);
    if (!set_part(1.0, rays[s], work->traced, work->part)) continue;
    segments.push_back(&work->part.segments);
    roots.push_back(&work->part.roots);
    streams.push_back(s);
    works.push_back(std::move(work));
  }
  if (works.empty()) return;
  segment_solver_->solve(query, segments, roots);
  for (std::size_t n = 0; n < works.size(); ++n)
    take_roots(1.0, works[n]->part, works[n]->traced, *hits[streams[n]], counts);
}

void ImplicitSurface::trace_on_device(bool next, std::span<const RayStream> rays,
                                      std::span<HitStream* const> hits, TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  if (options_.double_precision) trace_on_device(double_query_, next, rays, hits, counts);
  else trace_on_device(float_query_, next, rays, hits, counts);
}

}  // namespace isocast
