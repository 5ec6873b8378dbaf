// Which instruction sets the program has kernels for, and which of them this processor runs.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace isocast {

enum class Isa : std::uint8_t { scalar, sse4, avx2, avx512 };
inline constexpr int kIsaCount = 4;

[[nodiscard]] std::string_view name_of(Isa isa);
/// "scalar" ... "avx512"; "auto" is the widest that runs here. Throws InputError for other words and for sets
/// that this processor lacks ("cuda" included).
[[nodiscard]] Isa isa_from_name(std::string_view name);
[[nodiscard]] bool runs_here(Isa isa);
/// Those that run here, narrowest first.
[[nodiscard]] std::vector<Isa> available_isas();
[[nodiscard]] Isa widest_isa();

/// Sets the floating-point control register to its default (round to nearest, denormals kept, no traps) for
/// its lifetime: the entry of every kernel call, so that a host program's settings do not change the bits.
class DefaultFloatEnvironment {
 public:
  DefaultFloatEnvironment();
  ~DefaultFloatEnvironment();
  DefaultFloatEnvironment(const DefaultFloatEnvironment&) = delete;
  DefaultFloatEnvironment& operator=(const DefaultFloatEnvironment&) = delete;

 private:
  unsigned saved_;
};

}  // namespace isocast
