#include <isocast/apps/viewer/frame_budget.h>

#include <algorithm>

namespace isocast::viewer {

void FrameBudget::note(int divisor, double ms) {
  const double full = ms * divisor * divisor;
  full_ms_ = std::max(full, 0.5 * full_ms_ + 0.5 * full);
}

void FrameBudget::note_ended(int divisor, double ms) {
  full_ms_ = std::max(full_ms_, ms * divisor * divisor);
}

int FrameBudget::divisor(double budget_ms) const {
  if (full_ms_ == 0) return kCoarsest;
  constexpr double kReserve = 0.75;
  int divisor = 1;
  while (divisor < kCoarsest && expected_ms(divisor) > kReserve * budget_ms) ++divisor;
  return divisor;
}

}  // namespace isocast::viewer
