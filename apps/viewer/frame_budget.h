// At which resolution a preview is ready in time.
#pragma once

namespace isocast::viewer {

/// So coarse that a picture is there in any budget: 4 x 4 pixels of 1024 x 1024.
inline constexpr int kCoarsest = 256;

/// Learns what pictures of a view cost and picks the divisor of both sides, 1 to kCoarsest, with which the
/// next one fits into the budget. Full pictures (divisor 1) and previews are found in different ways and are
/// kept apart; what previews cost goes by their pixels.
class FrameBudget {
 public:
  /// A picture with this divisor took so long; a costlier one counts at once, cheaper ones gradually, but one
  /// that is much finer than all before is believed: they took what every picture takes, whatever its size.
  void note(int divisor, double ms);
  /// A picture was ended after so long: where nothing is known, nothing is learned from it.
  void note_ended(int divisor, double ms);
  /// Nothing is known any more: another scene or method.
  void forget() { *this = {}; }
  [[nodiscard]] bool knows_previews() const { return preview_ms_ > 0; }
  /// The finest that fits; 1 where nothing is known of previews: as far as time allows.
  [[nodiscard]] int divisor(double budget_ms) const;
  /// The full picture takes a few frames only: nothing is worth showing on the way to it.
  [[nodiscard]] bool full_is_near(double budget_ms) const {
    return full_ms_ > 0 && full_ms_ <= 10 * budget_ms;
  }

 private:
  double full_ms_ = 0, preview_ms_ = 0;  // preview_ms_: for all pixels of the full picture
  int finest_ = kCoarsest;               // of the previews noted
};

}  // namespace isocast::viewer
