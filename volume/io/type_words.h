// What files and users call the sample types.
#pragma once

#include <isocast/volume/sample_type.h>

#include <string_view>

namespace isocast {

/// The type of a word such as "u8", "uint8_t", "unsigned char", "UInt8", "float", "half" (any case).
///
/// throws  InputError "WHERE: ..." for any other word; for types that cannot be held (64-bit integers,
///         complex numbers, colours) it names the nearest that can
[[nodiscard]] SampleType sample_type_from_word(std::string_view word, std::string_view where);

}  // namespace isocast
