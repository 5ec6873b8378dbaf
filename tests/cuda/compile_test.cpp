// Formulas compile for GPUs: every surface of the catalogue, every solver; what solvers need keeps within
// cuda/budgets.txt.
#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/cuda/expression_source.h>
#include <isocast/cuda/formula_program.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/simplify.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "budgets.h"

using namespace isocast;
using namespace isocast::test;

namespace {

Tape tape_of(const CatalogueSurface& surface) { return make_tape(simplify(surface_expression(surface))); }

bool has_compiler() {
  try {
    return !compiler_version().empty();
  } catch (const InputError& error) {
    std::printf("skipped: %s\n", error.what());
    return false;
  }
}

constexpr std::pair<FormulaMethod, const char*> kSolvers[] = {{FormulaMethod::interval, "interval"},
                                                              {FormulaMethod::affine, "affine"},
                                                              {FormulaMethod::amp_sign, "amp_sign"},
                                                              {FormulaMethod::amp_taylor, "amp_taylor"}};

}  // namespace

TEST_CASE("every solver compiles to machine code within its budget", "[property]") {
  if (!has_compiler()) return;
  const std::vector<Budget> budgets = read_budgets(ISO_BUDGETS);
  const Tape tape = tape_of(require_surface("tangle"));
  for (const auto& [method, name] : kSolvers)
    for (const bool precise : {false, true}) {
      if (precise && test::cases(0, 1) == 0) continue;
      const CompiledProgram program =
          compile_formula(source_of(SegmentSolverKey{method, precise, false, 1}), tape, "sm_90");
      const auto kernels = kernels_in(program.log, "sm_90");
      REQUIRE(kernels.size() == 1);
      require_within(budgets, fmt::format("{}_{}", name, precise ? "double" : "float"),
                     kernels.begin()->second);
    }
}

TEST_CASE("beams compile to machine code within their budget", "[property]") {
  if (!has_compiler()) return;
  const std::vector<Budget> budgets = read_budgets(ISO_BUDGETS);
  const Tape tape = tape_of(require_surface("tangle"));
  for (const bool affine : {false, true})
    for (const bool precise : {false, true}) {
      if (precise && test::cases(0, 1) == 0) continue;
      const CompiledProgram program =
          compile_formula(source_of(BeamCastKey{affine, precise, 1}), tape, "sm_90");
      const auto kernels = kernels_in(program.log, "sm_90");
      REQUIRE(kernels.size() == 1);
      require_within(budgets,
                     fmt::format("beam_{}_{}", affine ? "affine" : "interval", precise ? "double" : "float"),
                     kernels.begin()->second);
    }
}

TEST_CASE("every root finder compiles to machine code", "[property]") {
  if (!has_compiler()) return;
  const Tape tape = tape_of(require_surface("tangle"));
  for (int finder = 0; finder < 6; ++finder)
    for (const bool single : {true, false}) {
      if (test::cases(0, 1) == 0 && (!single || finder % 3 != 0)) continue;
      const CompiledProgram program =
          compile_formula(source_of(RayFormKey{RootFinder(finder), single, 4, 1}), tape, "sm_90");
      CHECK(kernels_in(program.log, "sm_90").size() == 1);
    }
}

TEST_CASE("the text of every surface of the catalogue compiles to PTX") {
  if (!has_compiler()) return;
  std::string source =
      "#define ISO_ONE_RAY\n#include <isocast/cuda/formula_body.h>\nusing namespace isocast;\n";
  for (const CatalogueSurface& surface : catalogue())
    source += fmt::format(
        R"(extern "C" __global__ void surface_{}(const Interval<float>* points, Interval<float>* values) {{
  using R = Interval<float>;
  const R x = points[0], y = points[1], z = points[2], w = points[3];
  R* const registers = values;
{}}}
)",
        &surface - catalogue().data(), expression_body(tape_of(surface)));
  const CompiledProgram program = compile_formula(source, tape_of(require_surface("tangle")), "compute_75");
  const std::string ptx(program.code.begin(), program.code.end());
  for (std::size_t i = 0; i < catalogue().size(); ++i)
    REQUIRE(ptx.find(fmt::format(".entry surface_{}(", i)) != std::string::npos);
}

TEST_CASE("affine solvers of every surface of the catalogue compile to PTX", "[property]") {
  if (!has_compiler()) return;
  for (const CatalogueSurface& surface : catalogue()) {
    if (test::cases(0, 1) == 0 && (&surface - catalogue().data()) % 40 != 0) continue;
    INFO(surface.id);
    const CompiledProgram program = compile_formula(
        source_of(SegmentSolverKey{FormulaMethod::affine, false, false, 2}), tape_of(surface), "compute_75");
    const std::string ptx(program.code.begin(), program.code.end());
    REQUIRE(ptx.find(kFormulaKernel) != std::string::npos);
  }
}

TEST_CASE("a program that does not compile is told with the compiler's words") {
  if (!has_compiler()) return;
  CHECK_THROWS_WITH(compile_program("__global__ void f() { nonsense; }", {}, "compute_75"),
                    Catch::Contains("nonsense"));
}
