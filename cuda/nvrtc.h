// NVRTC, the CUDA compiler as a library, found at run time.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace isocast {

/// A header as programs include it.
struct SourceFile {
  std::string name, text;
};

/// What a compiler made: code, and what it says of it (registers, spills and stack of kernels; warnings).
struct CompiledProgram {
  std::vector<char> code;
  std::string log;
};

/// CUDA C++20 without fused multiply-add. architecture: "sm_90" for machine code, "compute_90" for PTX.
/// Throws InputError where NVRTC is not on the machine, std::runtime_error with its log where it fails.
[[nodiscard]] CompiledProgram compile_program(const std::string& source, std::span<const SourceFile> headers,
                                              const std::string& architecture);

/// Machine code for a device of compute capability `capability` (90 for 9.0), or PTX for the newest that
/// NVRTC knows, which the driver of a newer device translates.
[[nodiscard]] std::string architecture_for(int capability);

/// "13.0"
[[nodiscard]] std::string compiler_version();

}  // namespace isocast
