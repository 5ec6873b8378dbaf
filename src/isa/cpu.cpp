#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/isa/cpu.h>
#include <xmmintrin.h>

#include <iterator>

namespace isocast {
namespace {
constexpr std::string_view kNames[kIsaCount] = {"scalar", "sse4", "avx2", "avx512"};
constexpr unsigned kDefaultControl = 0x1f80;
}  // namespace

std::string_view name_of(Isa isa) { return kNames[static_cast<int>(isa)]; }

bool runs_here(Isa isa) {
  switch (isa) {
    case Isa::scalar: return true;
    case Isa::sse4: return __builtin_cpu_supports("sse4.2");
    case Isa::avx2: return __builtin_cpu_supports("avx2");
    default:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  }
}

std::vector<Isa> available_isas() {
  std::vector<Isa> isas;
  for (int i = 0; i < kIsaCount; ++i)
    if (runs_here(static_cast<Isa>(i))) isas.push_back(static_cast<Isa>(i));
  return isas;
}

Isa widest_isa() { return available_isas().back(); }

Isa isa_from_name(std::string_view name) {
  if (name == "auto") return widest_isa();
  if (name == "cuda")
    throw InputError(
        "instruction set 'cuda' is no processor's: only render, view and bench run on a GPU; expected auto, scalar, sse4, "
        "avx2 or avx512");
  for (int i = 0; i < kIsaCount; ++i)
    if (name == kNames[i]) {
      if (runs_here(static_cast<Isa>(i))) return static_cast<Isa>(i);
      throw InputError(fmt::format("instruction set '{}': this processor lacks it; the widest here is {}",
                                   name, name_of(widest_isa())));
    }
  throw InputError(fmt::format(
      "instruction set '{}' is unknown; expected auto, scalar, sse4, avx2, avx512 or cuda", name));
}

DefaultFloatEnvironment::DefaultFloatEnvironment() : saved_(_mm_getcsr()) { _mm_setcsr(kDefaultControl); }
DefaultFloatEnvironment::~DefaultFloatEnvironment() { _mm_setcsr(saved_); }

}  // namespace isocast
