// The answers of a reference for many rays, on all cores, kept on disk for the next time.
#pragma once

#include <isocast/apps/reference/ray_reference.h>

#include <filesystem>
#include <span>

namespace isocast::reference {

struct ReferenceRay {
  Double3 o, d;
  double t0, t1;
};

/// $XDG_CACHE_HOME/isocast/reference, else ~/.cache/isocast/reference; empty where neither is known.
[[nodiscard]] std::filesystem::path default_cache_folder();

/// reference.solve for every ray, in parallel; stops at Ctrl-C.
///
/// folder  made if missing. Holds a file for each reference and set of rays, named by a hash of the
///         reference's identity, the bits of the rays and the format. A file that is damaged or of other rays
///         is computed and written anew; where nothing can be written nothing is kept. Empty: no files.
///         Nothing is ever removed
[[nodiscard]] std::vector<RayTruth> solve_all(const RayReference& reference,
                                              std::span<const ReferenceRay> rays,
                                              const std::filesystem::path& folder = default_cache_folder());

}  // namespace isocast::reference
