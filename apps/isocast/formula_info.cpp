#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/formula_info.h>
#include <isocast/apps/reference/formula_module.h>
#include <isocast/base/module.h>
#include <isocast/implicit/expression/degree.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>

#include <nlohmann/json.hpp>

namespace isocast {
namespace {

using Json = nlohmann::ordered_json;
using reference::PolynomialTerm, reference::PolynomialTerms;

// "3/2 x^2 z"
std::string text_of(const PolynomialTerm& term) {
  std::string text = term.coefficient;
  const int powers[] = {term.i, term.j, term.k};
  for (int a = 0; a < 3; ++a) {
    if (powers[a] == 0) continue;
    text += fmt::format(" {}", "xyz"[a]);
    if (powers[a] > 1) text += fmt::format("^{}", powers[a]);
  }
  return text;
}

Json to_json(const FormulaInput& formula, const PolynomialDegree& degree, const PolynomialTerms& terms,
             std::size_t operations) {
  Json json = {{"kind", "formula"},
               {"domain", {formula.domain.lo, formula.domain.hi}},
               {"operations", operations},
               {"polynomial", terms.reason.empty()}};
  if (!terms.reason.empty()) {
    json["reason"] = terms.reason;
    return json;
  }
  json["degree"] = terms.degree;
  json["reduced"] = terms.degree < *degree.degree;
  json["rational"] = terms.rational;
  json["terms"] = Json::array();
  for (const PolynomialTerm& t : terms.terms)
    json["terms"].push_back(
        {{"powers", {t.i, t.j, t.k}}, {"coefficient", t.coefficient}, {"lo", t.lo}, {"hi", t.hi}});
  return json;
}

void print_table(const FormulaInput& formula, const PolynomialTerms& terms, std::size_t operations) {
  constexpr std::size_t kMostShown = 24;
  const auto row = [](const char* name, const std::string& text) { fmt::print("{:<12}{}\n", name, text); };
  row("domain",
      fmt::format("[{}] to [{}]", fmt::join(formula.domain.lo, ", "), fmt::join(formula.domain.hi, ", ")));
  row("operations", std::to_string(operations));
  if (!terms.reason.empty()) return row("polynomial", fmt::format("no: {}", terms.reason));
  row("polynomial", fmt::format("of degree {}, {} terms with {} coefficients", terms.degree,
                                terms.terms.size(), terms.rational ? "rational" : "irrational"));
  for (std::size_t i = 0; i < std::min(kMostShown, terms.terms.size()); ++i) row("", text_of(terms.terms[i]));
  if (terms.terms.size() > kMostShown)
    row("", fmt::format("... and {} more (--json)", terms.terms.size() - kMostShown));
}

}  // namespace

void print_formula_info(const FormulaInput& formula, double time, bool json) {
  const PolynomialDegree degree = polynomial_degree(formula.expression);
  PolynomialTerms terms;
  terms.reason = degree.reason;
  if (degree.degree)
    terms = module_table<reference::FormulaModule>("reference", "the coefficients of a polynomial")
                .terms(formula.expression, time);
  const std::size_t operations = make_tape(simplify(formula.expression)).code.size();
  if (json) fmt::print("{}\n", to_json(formula, degree, terms, operations).dump(2));
  else print_table(formula, terms, operations);
}

}  // namespace isocast
