// Formulas as lists of instructions: the .vm files of fidget and of the Prospero benchmark.
#pragma once

#include <isocast/implicit/expression/expression.h>

#include <filesystem>
#include <string_view>

namespace isocast {

inline constexpr std::size_t kMaxVmBytes = std::size_t{1} << 26;
inline constexpr std::size_t kMaxVmInstructions = std::size_t{1} << 20;

/// Reads a tape; the value of its last instruction is f.
///
/// format    one instruction a line: a new name, an operation, its operands (names from above); a line that
/// is
///           empty or begins with # means nothing. Operations: const NUMBER, var-x var-y var-z, neg abs recip
///           sqrt square floor ceil round sin cos tan asin acos atan exp ln not, add sub mul div min max mod
///           atan2 compare and or. A name that is given again means the later value
/// meaning   that of fidget: compare is -1, 0 or 1; mod is never negative; not is 1 of 0, else 0; and(a, b)
/// is
///           b where a is not 0, else a; or(a, b) is a where it is not 0, else b
/// throws    InputError "source:line: found ..., expected ..."
[[nodiscard]] Expression parse_vm_tape(std::string_view text, std::string_view source = "tape");

/// The same from a file, which is the source in messages.
[[nodiscard]] Expression read_vm_file(const std::filesystem::path& path);

}  // namespace isocast
