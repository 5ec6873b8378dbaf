// The types that samples keep in memory, as in their file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace isocast {

enum class SampleType : std::uint8_t { u8, i8, u16, i16, u32, i32, f16, f32, f64 };

/// IEEE 754 binary16, kept as its bits.
struct Half {
  std::uint16_t bits;
};

[[nodiscard]] constexpr std::size_t size_of(SampleType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 2, 4, 8};
  return sizes[static_cast<int>(type)];
}
[[nodiscard]] constexpr std::string_view name_of(SampleType type) {
  constexpr std::string_view names[] = {"u8", "i8", "u16", "i16", "u32", "i32", "f16", "f32", "f64"};
  return names[static_cast<int>(type)];
}
/// "u8" ... "f64" of interface.md; nothing for any other word.
[[nodiscard]] constexpr std::optional<SampleType> sample_type_from_name(std::string_view name) {
  for (int i = 0; i < 9; ++i)
    if (name == name_of(static_cast<SampleType>(i))) return static_cast<SampleType>(i);
  return std::nullopt;
}
[[nodiscard]] constexpr bool is_float(SampleType type) { return type >= SampleType::f16; }

template <class S> struct SampleTag { using Type = S; };
/// Calls visit(SampleTag<S>{}) with S the C++ type of `type`: uint8_t ... int32_t, Half, float, double.
template <class Visit> constexpr decltype(auto) visit_sample_type(SampleType type, Visit&& visit) {
  switch (type) {
    case SampleType::u8: return visit(SampleTag<std::uint8_t>{});
    case SampleType::i8: return visit(SampleTag<std::int8_t>{});
    case SampleType::u16: return visit(SampleTag<std::uint16_t>{});
    case SampleType::i16: return visit(SampleTag<std::int16_t>{});
    case SampleType::u32: return visit(SampleTag<std::uint32_t>{});
    case SampleType::i32: return visit(SampleTag<std::int32_t>{});
    case SampleType::f16: return visit(SampleTag<Half>{});
    case SampleType::f32: return visit(SampleTag<float>{});
    default: return visit(SampleTag<double>{});
  }
}

}  // namespace isocast
