// What formula methods prove, held against the reference: every surface of the catalogue, random formulas.
#include <implicit/framed_rays.h>
#include <implicit/undecided_shares.h>
#include <isocast/apps/reference/formula_reference.h>
#include <isocast/implicit/expression/builtins.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>
#include <math/inclusion_op.h>
#include <math/random_expression.h>
#include <test_size.h>
#include <volume/rays.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace isocast;
using namespace isocast::test;
using reference::FormulaReference, reference::FormulaRoots;

namespace {

constexpr double kTime = 0.3;

// A method in a precision, and what became of its rays. `aimed` rays have no special direction; of proofs,
// `unchecked` ones are those that the reference could not decide.
struct Row {
  const char* method;
  bool precise;
  std::int64_t aimed = 0, aimed_undecided = 0, proofs = 0, unchecked = 0;
};
std::vector<Row> rows() {
  return {{"interval", false}, {"interval", true}, {"affine", false}, {"affine", true}};
}

ImplicitSurface surface_of(const Expression& expression, const Domain& domain, const Row& row,
                           const char* eps_rel) {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(row.method, {{"eps-rel", eps_rel}});
  options.double_precision = row.precise;
  options.time = kTime;
  return ImplicitSurface(expression, domain, options);
}

// Rays from around the box into it: three of four aimed at a random point, the others in awkward directions.
bool is_aimed(int ray) { return ray % 4 != 3; }
std::unique_ptr<Streams> random_streams(std::mt19937_64& random, const Domain& box, int count) {
  const auto point = [&](double around) {
    Double3 p;
    for (std::size_t a = 0; a < 3; ++a) {
      const double half = 0.5 * (box.hi[a] - box.lo[a]);
      p[a] = box.lo[a] + half + half * std::uniform_real_distribution<double>(-around, around)(random);
    }
    return p;
  };
  auto s = make_streams();
  while (s->rays.size < count) {
    const Double3 o = point(2.5), target = point(1);
    add_ray(s->rays, o, is_aimed(s->rays.size) ? target - o : awkward_direction(random, o));
  }
  return s;
}

// One ray of one method: whether its proof agrees with the roots, which go as far as the first.
void check(Row& row, const HitStream& hits, int i, const Reach& range, const FormulaRoots& roots) {
  const Certificate certificate = hits.certificate[i];
  row.aimed += is_aimed(i);
  if (certificate == Certificate::undecided) {
    row.aimed_undecided += is_aimed(i);
    return;
  }
  ++row.proofs;
  const bool found = !roots.roots.empty();
  if (certificate == Certificate::proved_miss) {
    REQUIRE_FALSE(found);
    row.unchecked += !roots.decided();
    return;
  }
  const double lo = hits.t_lo[i], hi = hits.t_hi[i];
  const bool doubtful = std::ranges::any_of(roots.doubts, [&](const auto& doubt) { return doubt.lo <= hi; });
  row.unchecked += doubtful;
  INFO("bracket " << lo << " to " << hi);
  if (found) REQUIRE(roots.roots[0].hi >= lo);
  if (doubtful || !range.holds(lo, hi)) return;
  REQUIRE(found);
  REQUIRE(roots.roots[0].lo <= hi);
}

// Some rays through one formula by all methods.
void check_formula(const Expression& expression, const Domain& domain, const char* eps_rel, int rays,
                   std::int64_t operations, std::mt19937_64& random, std::vector<Row>& into) {
  const FormulaReference reference(expression, 0, kTime);
  const auto s = random_streams(random, domain, rays);
  std::vector<HitStream> hits(into.size());
  for (std::size_t r = 0; r < into.size(); ++r) {
    clear(hits[r]);
    std::ranges::fill(hits[r].certificate, Certificate::proved_miss);
    TraceCounts counts;
    surface_of(expression, domain, into[r], eps_rel).first_hit(s->rays, hits[r], counts);
  }
  Box box;
  for (int a = 0; a < 3; ++a) box.lo[a] = domain.lo[a], box.hi[a] = domain.hi[a];
  reference::ReferenceOptions options;
  options.max_roots = 1;
  options.max_operations = operations;
  for (int i = 0; i < s->rays.size; ++i) {
    const Double3 o = origin_of(s->rays, i), d = {s->rays.dx[i], s->rays.dy[i], s->rays.dz[i]};
    const Reach range = range_inside(box, o, d);
    if (range.empty()) continue;
    const FormulaRoots roots = reference.solve(o, d, range.lo, range.hi, options);
    for (std::size_t r = 0; r < into.size(); ++r) {
      INFO(into[r].method << (into[r].precise ? " double" : " float"));
      const double root = roots.roots.empty() ? 0 : roots.roots[0].lo;
      INFO(std::hexfloat << "root " << root << " o " << o[0] << " " << o[1] << " " << o[2] << " d " << d[0]
                         << " " << d[1] << " " << d[2]);
      check(into[r], hits[r], i, range, roots);
    }
  }
}

// Whether a formula has derivatives wherever it is defined.
bool is_smooth(const Expression& expression) {
  return std::ranges::none_of(expression.nodes(), [](const Node& node) {
    return node.op == Op::abs || node.op == Op::sign || node.op == Op::cbrt || node.op == Op::floor ||
           node.op == Op::ceil || node.op == Op::round || node.op == Op::min || node.op == Op::max ||
           node.op == Op::step || node.op == Op::choose;
  });
}

// No more undecided rays than the shares allow, give or take what chance makes of so few.
void check_undecided(const Row& row, const std::string& id) {
  const UndecidedShare& share = undecided_share(id);
  const double least = row.method == std::string("affine") ? kAffineShare : kIntervalShare;
  const double expected =
      0.01 * std::max(least, row.precise ? share.precise : share.single) * double(row.aimed);
  CHECK(double(row.aimed_undecided) <= expected + 4 * std::sqrt(expected) + 1);
}

// A random formula of x and y + z.
Expression random_formula(std::uint64_t index) {
  bench::Random random(7, index);
  const RandomExpression tape(random);
  Expression e;
  const auto operation = [&](Inclusion name, NodeId a, NodeId b, int n) -> NodeId {
    const std::array<NodeId, 2> both = {a, b};
    switch (name) {
      case Inclusion::power: return e.power(a, n);
      case Inclusion::chebyshev: return e.chebyshev(a, std::abs(n));
      case Inclusion::hypot: return find_builtin("hypot")->build(e, both);
      case Inclusion::mod: return find_builtin("mod")->build(e, both);
      case Inclusion::choose: return e.choose(a, b, a);
      default: break;
    }
    const Op op = op_of(name);
    return operand_count(op) == 1 ? e.unary(op, a) : e.binary(op, a, b);
  };
  const NodeId x = e.variable(0), y = e.binary(Op::add, e.variable(1), e.variable(2));
  e.set_root(tape.evaluate(x, y, operation));
  return e;
}

}  // namespace

TEST_CASE("what is proved of random formulas is true", "[property]") {
  std::mt19937_64 random(2);
  std::vector<Row> all = rows();
  const int rays = static_cast<int>(test::cases(8, 192));
  for (std::uint64_t n = 0; n < 1000; ++n) {
    INFO("random formula " << n);
    check_formula(random_formula(n), {{-2, -2, -2}, {2, 2, 2}}, "0.00048828125", rays, 1 << 13, random, all);
  }
  for (const Row& row : all) {
    INFO(row.method << (row.precise ? " double" : " float"));
    CHECK(row.proofs > 300 * rays);
    CHECK(double(row.unchecked) < 0.1 * double(row.proofs));
  }
}

TEST_CASE("what is proved of the catalogue's surfaces is true", "[property]") {
  std::mt19937_64 random(1);
  constexpr int rays = 192;
  for (const CatalogueSurface& surface : catalogue()) {
    INFO(surface.id);
    std::vector<Row> all = rows();
    const Expression expression = surface_expression(surface);
    for (std::int64_t n = 0; n < test::cases(192, 12'288); n += rays)
      check_formula(expression, surface.domain, "0.0000152587890625", rays, 1 << 22, random, all);
    for (const Row& row : all) {
      INFO(row.method << (row.precise ? " double" : " float"));
      CHECK(row.unchecked <= row.proofs / 1000);
      if (is_smooth(expression)) check_undecided(row, surface.id);
    }
  }
}
