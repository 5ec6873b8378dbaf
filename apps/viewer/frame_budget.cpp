#include <isocast/apps/viewer/frame_budget.h>

#include <algorithm>

namespace isocast::viewer {

void FrameBudget::note(int divisor, double ms) {
  double& cost = divisor == 1 ? full_ms_ : preview_ms_;
  const double all = ms * divisor * divisor;
  const bool believed = divisor > 1 && 2 * divisor < finest_;
  cost = believed ? all : std::max(all, 0.5 * cost + 0.5 * all);
  if (divisor > 1) finest_ = std::min(finest_, divisor);
}

void FrameBudget::note_ended(int divisor, double ms) {
  double& cost = divisor == 1 ? full_ms_ : preview_ms_;
  if (cost > 0) cost = std::max(cost, ms * divisor * divisor);
}

int FrameBudget::divisor(double budget_ms) const {
  // a full picture that is late costs little: a preview is there
  constexpr double kFull = 0.95, kPreview = 0.7;
  const double limit = kPreview * budget_ms;
  if (!knows_previews() || (full_ms_ > 0 && full_ms_ <= kFull * budget_ms)) return 1;
  int divisor = 2;
  while (divisor < kCoarsest && preview_ms_ / (divisor * divisor) > limit) ++divisor;
  return divisor;
}

}  // namespace isocast::viewer
