#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/type_words.h>

#include <algorithm>

namespace isocast {
namespace {

struct TypeWords {
  SampleType type;
  std::string_view words;  // between bars, lower case
};

constexpr TypeWords kSupported[] = {
    {SampleType::u8, "|u8|uint8|uint8_t|uchar|unsigned char|byte|met_uchar|"},
    {SampleType::i8, "|i8|int8|int8_t|schar|signed char|met_char|"},
    {SampleType::u16, "|u16|uint16|uint16_t|ushort|unsigned short|unsigned short int|met_ushort|"},
    {SampleType::i16, "|i16|int16|int16_t|short|short int|signed short|signed short int|met_short|"},
    {SampleType::u32, "|u32|uint32|uint32_t|uint|unsigned int|met_uint|met_ulong|"},
    {SampleType::i32, "|i32|int32|int32_t|int|signed int|met_int|met_long|"},
    {SampleType::f16, "|f16|float16|half|"},
    {SampleType::f32, "|f32|float32|float|met_float|"},
    {SampleType::f64, "|f64|float64|double|met_double|"},
};

// Types of the formats that no volume can hold, by the nearest that one can.
constexpr TypeWords kNearest[] = {
    {SampleType::u8, "|binary|bit|bool|rgb24|rgba32|"},
    {SampleType::f32, "|complex64|"},
    {SampleType::f64,
     "|i64|int64|int64_t|longlong|long long|long long int|signed long long|signed long long "
     "int|u64|uint64|uint64_t|"
     "met_long_long|met_ulong_long|ulonglong|unsigned long long|unsigned long long "
     "int|float128|complex128|complex256|"},
};

template <std::size_t N> const TypeWords* find_word(const TypeWords (&table)[N], const std::string& word) {
  const auto found = std::ranges::find_if(table, [&](const TypeWords& row) {
    return row.words.find("|" + word + "|") != std::string_view::npos;
  });
  return found == std::end(table) ? nullptr : found;
}

}  // namespace

SampleType sample_type_from_word(std::string_view word, std::string_view where) {
  const std::string lower = lower_case(word);
  if (const TypeWords* found = find_word(kSupported, lower)) return found->type;
  if (const TypeWords* found = find_word(kNearest, lower))
    throw InputError(fmt::format("{}: the sample type {} is not possible, the nearest that is possible is {}",
                                 where, in_quotes(word), name_of(found->type)));
  throw InputError(
      fmt::format("{}: unknown sample type {}, expected one of u8 i8 u16 i16 u32 i32 f16 f32 f64", where,
                  in_quotes(word)));
}

}  // namespace isocast
