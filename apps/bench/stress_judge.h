// What a stress case counts beyond right and wrong: proofs, and whether they are true.
#pragma once

#include <isocast/apps/bench/judge.h>
#include <isocast/apps/bench/picture_truth.h>

#include <span>
#include <vector>

namespace isocast::bench {

/// hits, misses  proved
/// false_proofs  that the reference contradicts: a root before the bracket of a proved hit, none of its
///               iso-value in it, or any root where a miss is proved
/// malformed     hits without t_lo <= t <= t_hi, all of them finite and t not behind the ray's start, and t
///               that are not numbers
struct StressCounts {
  std::int64_t hits = 0, misses = 0, false_proofs = 0, malformed = 0;
};

/// Of a surface that proves, certificates were proved_miss before it was asked.
[[nodiscard]] StressCounts count_proofs(const PictureTruth& truth, const std::vector<RayStream>& rays,
                                        const std::vector<HitStream>& hits);
/// Of a method that proves, or not.
[[nodiscard]] StressCounts count_proofs(std::span<const reference::CellReference> truth,
                                        std::span<const Answer> answers, bool proves);

}  // namespace isocast::bench
