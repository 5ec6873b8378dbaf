// A formula's kernel, compiled at run time.
#pragma once

#include <isocast/cuda/nvrtc.h>
#include <isocast/implicit/segment_solver.h>

namespace isocast {

/// The name of the kernel.
inline constexpr const char* kFormulaKernel = "solve_segments";

/// Programs with one kernel of that name: a method's for segments, a finder's for rays' polynomials, a form's
/// for beams.
[[nodiscard]] std::string source_of(const SegmentSolverKey& key);
[[nodiscard]] std::string source_of(const RayFormKey& key);
[[nodiscard]] std::string source_of(const BeamCastKey& key);

/// A program with its formula. architecture: as compile_program (nvrtc.h), which says what it throws.
[[nodiscard]] CompiledProgram compile_formula(const std::string& source, const Tape& tape,
                                              const std::string& architecture);

/// The same, kept in cache_folder("cuda") under the hash of all that it is made from.
[[nodiscard]] std::vector<char> formula_program(const std::string& source, const Tape& tape,
                                                const std::string& architecture);

}  // namespace isocast
