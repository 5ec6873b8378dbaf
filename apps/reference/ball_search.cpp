#include <isocast/apps/reference/ball_search.h>

#include <algorithm>
#include <utility>

namespace isocast::reference {
namespace {

constexpr int kDeepest = 60;
// Parts where no sign is known at any point, though f has a value there, are not divided further.
constexpr int kFlatDepth = 7;

struct Part {
  Ball lo, hi, f_lo, f_hi;
  int depth;
};

class Search {
 public:
  Search(FormulaBalls& f, double width, const ReferenceOptions& options)
      : f_(f), width_(width), options_(options) {}

  SearchResult run() {
    parts_.push_back({Ball(0), Ball(1), at(Ball(0)), at(Ball(1)), 0});
    while (!parts_.empty() && result_.roots.size() < options_.max_roots) {
      const Part part = std::move(parts_.back());
      parts_.pop_back();
      look_at(part);
    }
    return std::move(result_);
  }

 private:
  Ball at(const Ball& s) {
    Ball value = f_.at(s, options_.max_bits);
    result_.bits = std::max(result_.bits, f_.bits());
    return value;
  }

  void look_at(const Part& part) {
    if (f_.operations() > options_.max_operations) return doubt(part, Doubt::work);
    Ball middle = between(part.lo, part.hi, 0.5), f_middle = at(middle);
    const slong bits = std::min<slong>(f_.bits() + 2 * part.depth, options_.max_bits);
    Ball s;
    arb_union(s.set(), part.lo.get(), part.hi.get(), bits + 64);
    const Enclosure f = f_.over(s, bits, true);
    if (f.empty || f.value.sign() != 0) return;
    if (f.value.is_zero() && f.continuous) return doubt(part, Doubt::zero);
    const bool smooth = f.continuous && f.slope.is_finite();
    if (smooth && mean_value_excludes_zero(s, middle, f_middle, f.slope, bits)) return;
    if (smooth && f.slope.sign() != 0 && decided_by_ends(part)) return;
    if (part.depth >= kDeepest) {
      if (f.continuous && part.f_lo.sign() * part.f_hi.sign() < 0)
        return result_.roots.push_back({{part.lo, part.hi}, true});
      return doubt(part, f.continuous ? Doubt::touch : f.defined ? Doubt::jump : Doubt::undefined);
    }
    // another place where no sign is known in the middle: f may vanish there by design
    bool flat = seems_zero(f_middle);
    for (const double place : {0.4375, 0.5625}) {
      if (f_middle.sign() != 0) break;
      Ball beside = between(part.lo, part.hi, place), f_beside = at(beside);
      flat = flat && seems_zero(f_beside);
      if (f_beside.sign() == 0) continue;
      middle = std::move(beside);
      f_middle = std::move(f_beside);
    }
    if (flat && part.depth >= kFlatDepth) return doubt(part, f.defined ? Doubt::zero : Doubt::undefined);
    parts_.push_back({middle, part.hi, f_middle, part.f_hi, part.depth + 1});
    parts_.push_back({part.lo, std::move(middle), part.f_lo, std::move(f_middle), part.depth + 1});
  }

  static bool mean_value_excludes_zero(const Ball& s, const Ball& middle, const Ball& f_middle,
                                       const Ball& slope, slong bits) {
    Ball value;
    arb_sub(value.set(), s.get(), middle.get(), bits);
    arb_mul(value.set(), value.get(), slope.get(), bits);
    arb_add(value.set(), value.get(), f_middle.get(), bits);
    return value.sign() != 0;
  }

  // Of a part where f is monotone. A zero at an end other than 0 and 1 belongs to neither side's signs: such
  // ends have none.
  bool decided_by_ends(const Part& part) {
    const auto root_at = [&](const Ball& end) { result_.roots.push_back({{end, end}, true}); };
    if (part.f_lo.is_zero() && is_end(part.lo)) {
      root_at(part.lo);
      return true;
    }
    if (part.f_hi.is_zero() && is_end(part.hi)) {
      root_at(part.hi);
      return true;
    }
    if (part.f_lo.sign() == 0 || part.f_hi.sign() == 0) return false;
    if (part.f_lo.sign() == part.f_hi.sign()) return true;
    const auto value_at = [&](const Ball& s) { return at(s); };
    result_.roots.push_back({refine(value_at, {part.lo, part.hi}, part.f_lo, part.f_hi, width_), true});
    return true;
  }
  static bool seems_zero(const Ball& f) { return f.is_number() && f.sign() == 0; }
  static bool is_end(const Ball& s) { return s.is_zero() || arb_is_one(s.get()); }

  // Ranges side by side become one.
  void doubt(const Part& part, Doubt doubt) {
    auto& doubts = result_.doubts;
    if (!doubts.empty() && arb_equal(doubts.back().s.hi.get(), part.lo.get())) {
      doubts.back().s.hi = part.hi;
      if (doubts.back().doubt == Doubt::touch) doubts.back().doubt = doubt;
    } else {
      doubts.push_back({{part.lo, part.hi}, doubt});
    }
  }

  FormulaBalls& f_;
  double width_;
  const ReferenceOptions& options_;
  std::vector<Part> parts_;
  SearchResult result_;
};

}  // namespace

SearchResult search(FormulaBalls& f, double width, const ReferenceOptions& options) {
  return Search(f, width, options).run();
}

}  // namespace isocast::reference
