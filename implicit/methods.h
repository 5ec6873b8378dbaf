// The rows of the method table for formulas.
#pragma once

#include <isocast/implicit/frustum/finder.h>
#include <isocast/implicit/solve/kernels.h>
#include <isocast/ray/method.h>

#include <map>
#include <span>
#include <string>

namespace isocast {

/// What finds the primary rays of a picture together, if anything does.
enum class FormulaPass : std::uint8_t { none, frustum, certified, beam_uniform, beam_adaptive };

/// Those of FormulaMethod first, in its order; then those with a pass.
[[nodiscard]] std::span<const Method> formula_methods();

/// A row with the values of its options; lengths in world units, 0 where the domain or f's probe decides.
///
/// method    of rays that no pass finds
/// eps       a length; 0: eps_rel, a fraction of the domain's longest edge
/// options   step and tau may be 0 as well
/// offset    added to every iso-value
/// nearest   inclusions whose bounds are the nearest numbers
/// beams     rays of a tile are first cut together to where f may be an iso-value
/// finder    the root finder of frustum methods; certify: whether their hits and misses come with proofs;
///           form_normals: gradients of rays of the camera are the form's, where a pass has one
/// depth_eps       beam-uniform, beam-adaptive: of a pixel, in depth from -1 to 1
/// finer           levels below pixels; affine_beams: by affine forms, else by intervals
/// prune     where min, max or a choice is decided the tape is run without what it does not need
/// shadow_eps_rel  eps_rel of shadow rays, if larger
/// normal_step     stencil of difference normals in eps; `normal_grows`: in proportion to the distance along
/// the
///                 ray over the domain's longest edge
struct FormulaMethodChoice {
  FormulaMethod method = FormulaMethod::affine;
  FormulaPass pass = FormulaPass::none;
  FormulaOptions options;
  double eps = 0, eps_rel = 0x1p-11, offset = 0, shadow_eps_rel = 0, normal_step = 1;
  double depth_eps = 0;
  int finer = 0;
  bool affine_beams = false;
  bool normal_grows = false, prune = true, nearest = false, beams = true, certify = true;
  bool form_normals = false;
  FinderOptions finder;
  /// Samples f along the rays instead of including it.
  [[nodiscard]] bool marches() const {
    return method == FormulaMethod::amp_sign || method == FormulaMethod::amp_taylor;
  }
  /// Works on the frustum form, of polynomials alone.
  [[nodiscard]] bool has_form() const { return pass == FormulaPass::frustum; }
  [[nodiscard]] bool proves() const { return has_form() ? certify : !marches() && !nearest; }
};
/// A row with its `--set` values. Throws InputError as find_method and resolve_options do.
[[nodiscard]] FormulaMethodChoice choose_formula_method(std::string_view name,
                                                        const std::map<std::string, std::string>& settings);

/// The row that a choice comes from.
[[nodiscard]] std::string_view name_of(const FormulaMethodChoice& choice);

}  // namespace isocast
