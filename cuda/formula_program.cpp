#include <fmt/format.h>
#include <isocast/base/cache_folder.h>
#include <isocast/base/error.h>
#include <isocast/base/hash.h>
#include <isocast/base/output_file.h>
#include <isocast/cuda/expression_source.h>
#include <isocast/cuda/formula_program.h>

#include <fstream>
#include <iterator>

namespace isocast {
namespace {
namespace fs = std::filesystem;

const SourceFile kHeaders[] = {
#include "formula_headers.inc"
};

std::vector<SourceFile> headers_with(const Tape& tape) {
  std::vector<SourceFile> headers(std::begin(kHeaders), std::end(kHeaders));
  headers.push_back({"isocast/implicit/expression/evaluate.h", expression_header(tape)});
  return headers;
}

const char* solver_of(FormulaMethod method) {
  switch (method) {
    case FormulaMethod::affine: return "AffineSolver";
    case FormulaMethod::amp_sign: return "AmpSignSolver";
    case FormulaMethod::amp_taylor: return "AmpTaylorSolver";
    default: return "IntervalSolver";
  }
}

std::vector<char> read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::string source_of(const SegmentSolverKey& key) {
  return fmt::format(R"(#define ISO_ONE_RAY
#define ISO_ISOS {0}
{1}
#include <isocast/cuda/formula_body.h>
using namespace isocast;
extern "C" __global__ void __launch_bounds__(128) {2}(const __grid_constant__ SegmentWork<{3}> work) {{
  alignas(16) std::byte value[kRegisterBytes<{4}<{3}>, {3}>];
  solve_segment<{4}<{3}>>(work, {{int(blockIdx.x), int(threadIdx.x), int(blockDim.x)}}, value);
}}
)",
                     key.iso_count, key.nearest ? "#define ISO_ROUND_NEAREST" : "", kFormulaKernel,
                     key.double_precision ? "double" : "float", solver_of(key.method));
}

std::string source_of(const RayFormKey& key) {
  return fmt::format(R"(#define ISO_ONE_RAY
#define ISO_FINDER {0}
#define ISO_DEGREE {1}
#include <isocast/cuda/ray_form_body.h>
using namespace isocast;
extern "C" __global__ void __launch_bounds__(128) {2}(const __grid_constant__ RayFormWork work) {{
  alignas(16) std::byte values[kRayFormRegisterBytes];
  solve_ray_form<{3}>(work, {{int(blockIdx.x), int(threadIdx.x), int(blockDim.x)}}, values);
}}
)",
                     static_cast<int>(key.finder), key.degree <= kMostUnrolled ? key.degree : 0,
                     kFormulaKernel, key.single ? "float" : "double");
}

std::string source_of(const BeamCastKey& key) {
  return fmt::format(R"(#define ISO_ONE_RAY
#define ISO_ISOS {0}
#include <isocast/cuda/beam_body.h>
using namespace isocast;
extern "C" __global__ void __launch_bounds__(128, 4) {1}(const __grid_constant__ BeamWork<{2}> work) {{
  alignas(16) std::byte value[sizeof({3}<{2}>)];
  cast_beams<{3}<{2}>>(work, {{int(blockIdx.x), int(threadIdx.x), int(blockDim.x)}}, value);
}}
)",
                     key.iso_count, kFormulaKernel, key.double_precision ? "double" : "float",
                     key.affine ? "AffineBeam" : "IntervalBeam");
}

CompiledProgram compile_formula(const std::string& source, const Tape& tape,
                                const std::string& architecture) {
  return compile_program(source, headers_with(tape), architecture);
}

std::vector<char> formula_program(const std::string& source, const Tape& tape,
                                  const std::string& architecture) {
  const std::vector<SourceFile> headers = headers_with(tape);
  Hash hash;
  hash.add(compiler_version() + architecture + source);
  for (const SourceFile& header : headers) hash.add(header.text);
  const fs::path folder = cache_folder("cuda"), file = folder / (hash.text() + ".cubin");
  if (!folder.empty())
    if (std::vector<char> kept = read(file); !kept.empty()) return kept;
  CompiledProgram program = compile_program(source, headers, architecture);
  if (folder.empty()) return std::move(program.code);
  try {
    fs::create_directories(folder);
    write_text_file(file, std::string(program.code.begin(), program.code.end()));
  } catch (const fs::filesystem_error&) {  // it is compiled all the same
  } catch (const InputError&) {}
  return std::move(program.code);
}

}  // namespace isocast
