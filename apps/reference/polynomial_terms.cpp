#include <flint/fmpq_mpoly.h>
#include <fmt/format.h>
#include <isocast/apps/reference/enclosure.h>
#include <isocast/apps/reference/exact_formula.h>
#include <isocast/apps/reference/polynomial_terms.h>
#include <isocast/implicit/expression/degree.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace isocast::reference {
namespace {

// x, y, z and the irrational numbers of the formula.
constexpr slong kVariables = 3, kMostNumbers = 8, kGenerators = kVariables + kMostNumbers;
constexpr slong kBits = 256, kMostTerms = 100000;

struct Context {
  fmpq_mpoly_ctx_t get;
  Context() { fmpq_mpoly_ctx_init(get, kGenerators, ORD_LEX); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { fmpq_mpoly_ctx_clear(get); }
};

// A polynomial of FLINT that frees itself.
class Polynomial {
 public:
  explicit Polynomial(const Context& context) : context_(&context) { fmpq_mpoly_init(value_, context.get); }
  Polynomial(const Polynomial& other) : Polynomial(*other.context_) {
    fmpq_mpoly_set(value_, other.value_, context_->get);
  }
  Polynomial& operator=(Polynomial other) noexcept {
    fmpq_mpoly_swap(value_, other.value_, context_->get);
    return *this;
  }
  ~Polynomial() { fmpq_mpoly_clear(value_, context_->get); }
  [[nodiscard]] const fmpq_mpoly_struct* get() const { return value_; }
  [[nodiscard]] fmpq_mpoly_struct* set() { return value_; }
  [[nodiscard]] slong length() const { return fmpq_mpoly_length(value_, context_->get); }

 private:
  const Context* context_;
  fmpq_mpoly_t value_;
};

// A node: a polynomial; of a number also what it is about.
struct Value {
  Polynomial polynomial;
  std::optional<Ball> number;
};

class Expansion {
 public:
  explicit Expansion(const ExactFormula& formula) : formula_(formula) {}

  PolynomialTerms run() {
    PolynomialTerms result;
    std::vector<Value> values;
    for (const Node& node : formula_.nodes) {
      std::optional<Value> value = of(node, values);
      if (!value) {
        result.reason = reason_;
        return result;
      }
      values.push_back(std::move(*value));
    }
    collect(reduced(values.back().polynomial), result);
    return result;
  }

 private:
  const fmpq_mpoly_ctx_struct* context() const { return context_.get; }

  // A new generator for an irrational number. relation: a polynomial in it that is zero.
  std::optional<Value> generator(const Ball& number) {
    if (numbers_.size() == static_cast<std::size_t>(kMostNumbers)) {
      reason_ = fmt::format("more than {} irrational numbers", kMostNumbers);
      return std::nullopt;
    }
    Value value{Polynomial(context_), number};
    fmpq_mpoly_gen(value.polynomial.set(), kVariables + static_cast<slong>(numbers_.size()), context());
    numbers_.push_back(number);
    return value;
  }

  std::optional<Value> constant(const ExactConstant& constant) {
    if (!constant.name.empty()) {
      for (const auto& [name, known] : named_)
        if (name == constant.name) return known;
      auto value = generator(ball_of(constant, kBits));
      if (!value) return value;
      named_.emplace_back(constant.name, *value);
      if (constant.name == "phi") {
        // phi^2 = phi + 1
        Polynomial relation(context_);
        fmpq_mpoly_mul(relation.set(), value->polynomial.get(), value->polynomial.get(), context());
        fmpq_mpoly_sub(relation.set(), relation.get(), value->polynomial.get(), context());
        fmpq_mpoly_sub_si(relation.set(), relation.get(), 1, context());
        relations_.push_back(relation);
      }
      return value;
    }
    Value value{Polynomial(context_), ball_of(constant, kBits)};
    fmpq_mpoly_set_fmpq(value.polynomial.set(), constant.value.get(), context());
    return value;
  }

  std::optional<Value> of(const Node& node, const std::vector<Value>& values) {
    if (node.op == Op::constant) return constant(formula_.constants[node.a]);
    Value y{Polynomial(context_), std::nullopt};
    fmpq_mpoly_struct* const out = y.polynomial.set();
    if (node.op == Op::variable) {
      fmpq_mpoly_gen(out, static_cast<slong>(node.a), context());
      return y;
    }
    const int operands = operand_count(node.op);
    const Value &a = values[node.a], &b = values[operands > 1 ? node.b : node.a];
    const bool numbers = a.number && b.number && (operands < 3 || values[node.c].number);
    if (numbers) {
      const Ball nothing;
      y.number =
          apply(node.op, node.n, enclosure_of(*a.number), enclosure_of(operands > 1 ? *b.number : nothing),
                enclosure_of(operands > 2 ? *values[node.c].number : nothing), kBits, false)
              .value;
    }
    const fmpq_mpoly_struct *p = a.polynomial.get(), *q = b.polynomial.get();
    const auto whole = [&]() -> std::optional<int> {
      if (!fmpq_mpoly_is_fmpq(q, context())) return std::nullopt;
      Rational n;
      fmpq_mpoly_get_fmpq(n.set(), q, context());
      if (!fmpz_is_one(fmpq_denref(n.get())) || fmpz_cmp_si(fmpq_numref(n.get()), 0) < 0 ||
          fmpz_cmp_si(fmpq_numref(n.get()), kMostPolynomialDegree) > 0)
        return std::nullopt;
      return static_cast<int>(fmpz_get_si(fmpq_numref(n.get())));
    };
    bool done = true;
    switch (node.op) {
      case Op::negate: fmpq_mpoly_neg(out, p, context()); break;
      case Op::add: fmpq_mpoly_add(out, p, q, context()); break;
      case Op::subtract: fmpq_mpoly_sub(out, p, q, context()); break;
      case Op::multiply:
        if (a.polynomial.length() * b.polynomial.length() > 100 * kMostTerms) return too_many();
        fmpq_mpoly_mul(out, p, q, context());
        break;
      case Op::square: done = raise(y.polynomial, a.polynomial, 2); break;
      case Op::power: done = node.n >= 0 && raise(y.polynomial, a.polynomial, node.n); break;
      case Op::pow: done = whole() && raise(y.polynomial, a.polynomial, *whole()); break;
      case Op::chebyshev: done = chebyshev(y.polynomial, a.polynomial, node.n); break;
      case Op::divide: {
        done = fmpq_mpoly_is_fmpq(q, context()) && !fmpq_mpoly_is_zero(q, context());
        if (!done) break;
        Rational divisor;
        fmpq_mpoly_get_fmpq(divisor.set(), q, context());
        fmpq_mpoly_scalar_div_fmpq(out, p, divisor.get(), context());
        break;
      }
      default: done = false;
    }
    if (!reason_.empty()) return std::nullopt;
    if (y.polynomial.length() > kMostTerms) return too_many();
    if (done) return y;
    if (node.op == Op::divide && b.number) {
      // by an irrational number: times a new one
      const Ball one(1.0);
      const Enclosure inverse =
          apply(Op::divide, 0, enclosure_of(one), enclosure_of(*b.number), enclosure_of(one), kBits, false);
      const auto factor = generator(inverse.value);
      if (!factor) return std::nullopt;
      fmpq_mpoly_mul(out, p, factor->polynomial.get(), context());
      return y;
    }
    if (!numbers) {
      reason_ = "not a polynomial";
      return std::nullopt;
    }
    const Polynomial under = a.polynomial;
    auto value = generator(*y.number);
    if (value && node.op == Op::sqrt) {
      Polynomial relation(context_);
      fmpq_mpoly_mul(relation.set(), value->polynomial.get(), value->polynomial.get(), context());
      fmpq_mpoly_sub(relation.set(), relation.get(), under.get(), context());
      relations_.push_back(relation);
    }
    return value;
  }

  std::nullopt_t too_many() {
    reason_ = fmt::format("more than {} terms", kMostTerms);
    return std::nullopt;
  }
  bool raise(Polynomial& out, const Polynomial& a, int n) {
    Polynomial result(context_);
    fmpq_mpoly_one(result.set(), context());
    for (int i = 0; i < n; ++i) {
      if (result.length() * a.length() > 100 * kMostTerms) {
        too_many();
        return true;
      }
      fmpq_mpoly_mul(result.set(), result.get(), a.get(), context());
    }
    out = result;
    return true;
  }
  bool chebyshev(Polynomial& out, const Polynomial& a, int n) {
    Polynomial before(context_), now(context_);
    fmpq_mpoly_one(before.set(), context());
    now = n == 0 ? before : a;
    for (int k = 1; k < n; ++k) {
      if (now.length() * a.length() > 100 * kMostTerms) {
        too_many();
        return true;
      }
      Polynomial next(context_);
      fmpq_mpoly_mul(next.set(), now.get(), a.get(), context());
      fmpq_mpoly_scalar_mul_si(next.set(), next.get(), 2, context());
      fmpq_mpoly_sub(next.set(), next.get(), before.get(), context());
      before = now;
      now = next;
    }
    out = now;
    return true;
  }

  [[nodiscard]] Polynomial reduced(Polynomial p) const {
    for (auto relation = relations_.rbegin(); relation != relations_.rend(); ++relation) {
      Polynomial quotient(context_), rest(context_);
      fmpq_mpoly_divrem(quotient.set(), rest.set(), p.get(), relation->get(), context());
      p = rest;
    }
    return p;
  }

  // Terms with the same powers of x, y and z are one.
  void collect(const Polynomial& p, PolynomialTerms& result) const {
    std::array<ulong, 3> powers = {};
    Ball sum;
    Rational exact;
    bool rational = true, any = false;
    const auto finish = [&] {
      if (!any) return;
      PolynomialTerm term{int(powers[0]), int(powers[1]), int(powers[2]), {}, 0, 0};
      if (rational) arb_set_fmpq(sum.set(), exact.get(), kBits);
      char* const text = rational ? fmpq_get_str(nullptr, 10, exact.get()) : arb_get_str(sum.get(), 20, 0);
      term.coefficient = text;
      flint_free(text);
      arf_t lo, hi;
      arf_init(lo), arf_init(hi);
      arb_get_interval_arf(lo, hi, sum.get(), kBits);
      term.lo = arf_get_d(lo, ARF_RND_FLOOR), term.hi = arf_get_d(hi, ARF_RND_CEIL);
      arf_clear(lo), arf_clear(hi);
      result.rational = result.rational && rational;
      result.degree = std::max(result.degree, term.i + term.j + term.k);
      result.terms.push_back(std::move(term));
    };
    for (slong n = 0; n < p.length(); ++n) {
      std::array<ulong, kGenerators> exponents;
      fmpq_mpoly_get_term_exp_ui(exponents.data(), p.get(), n, context());
      const std::array<ulong, 3> here = {exponents[0], exponents[1], exponents[2]};
      if (!any || here != powers) {
        finish();
        powers = here;
        sum = Ball();
        exact = Rational();
        rational = any = true;
      }
      Rational coefficient;
      fmpq_mpoly_get_term_coeff_fmpq(coefficient.set(), p.get(), n, context());
      Ball part;
      arb_set_fmpq(part.set(), coefficient.get(), kBits);
      fmpq_add(exact.set(), exact.get(), coefficient.get());
      for (std::size_t g = 0; g < numbers_.size(); ++g) {
        if (exponents[3 + g] == 0) continue;
        rational = false;
        Ball power;
        arb_pow_ui(power.set(), numbers_[g].get(), exponents[3 + g], kBits);
        arb_mul(part.set(), part.get(), power.get(), kBits);
      }
      arb_add(sum.set(), sum.get(), part.get(), kBits);
    }
    finish();
  }

  const ExactFormula& formula_;
  Context context_;
  std::vector<Ball> numbers_;
  std::vector<std::pair<std::string, Value>> named_;
  std::vector<Polynomial> relations_;
  std::string reason_;
};

}  // namespace

PolynomialTerms polynomial_terms(const Expression& expression, double time) {
  PolynomialTerms result;
  const PolynomialDegree degree = polynomial_degree(expression);
  if (!degree.degree) {
    result.reason = degree.reason;
    return result;
  }
  return Expansion(exact_formula(expression, 0, time)).run();
}

}  // namespace isocast::reference
