// At which resolution a preview is ready in time.
#pragma once

namespace isocast::viewer {

inline constexpr int kCoarsest = 16;

/// Learns what pictures of a view cost and picks the divisor of both sides, 1 to kCoarsest, with which the
/// next one fits into the budget. Full pictures (divisor 1) and previews are found in different ways and are
/// kept apart; what previews cost goes by their pixels.
class FrameBudget {
 public:
  /// A picture with this divisor took so long; a costlier one counts at once, cheaper ones gradually.
  void note(int divisor, double ms);
  /// A picture was ended after so long.
  void note_ended(int divisor, double ms);
  /// Nothing is known any more: another scene or method.
  void forget() { full_ms_ = preview_ms_ = 0; }
  /// The coarsest where nothing is known.
  [[nodiscard]] int divisor(double budget_ms) const;
  /// The full picture takes a few frames only: nothing is worth showing on the way to it.
  [[nodiscard]] bool full_is_near(double budget_ms) const {
    return full_ms_ > 0 && full_ms_ <= 10 * budget_ms;
  }

 private:
  double full_ms_ = 0, preview_ms_ = 0;  // preview_ms_: for all pixels of the full picture
};

}  // namespace isocast::viewer
