// Letters of 3 x 5 pixels, to name the tiles of a contact sheet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isocast {

inline constexpr int kGlyphWidth = 3, kGlyphHeight = 5;

/// The pixels of a character: an octal digit a row, the first digit the top row, the highest bit on the left.
/// Small letters look like capitals; nothing is drawn for a character that the font lacks.
[[nodiscard]] constexpr std::uint16_t glyph_of(char c) {
  constexpr std::uint16_t digits[] = {075557, 026227, 071747, 071717, 055711,
                                      074717, 074757, 071122, 075757, 075717};
  constexpr std::uint16_t letters[] = {025755, 065656, 034443, 065556, 074647, 074644, 034553, 055755, 072227,
                                       011152, 055655, 044447, 057755, 065555, 025552, 065644, 025573, 065655,
                                       034216, 072222, 055557, 055552, 055775, 055255, 055222, 071247};
  if (c >= '0' && c <= '9') return digits[c - '0'];
  if (c >= 'a' && c <= 'z') return letters[c - 'a'];
  if (c >= 'A' && c <= 'Z') return letters[c - 'A'];
  return c == '_' ? 07 : 0;
}

/// Calls set(x, y) for every pixel of a line of text, its upper left corner at (0, 0); characters are
/// kGlyphWidth + 1 pixels apart.
template <class Set> constexpr void draw_text(std::string_view text, Set set) {
  for (std::size_t n = 0; n < text.size(); ++n)
    for (int y = 0; y < kGlyphHeight; ++y)
      for (int x = 0; x < kGlyphWidth; ++x)
        if (glyph_of(text[n]) >> (kGlyphWidth * (kGlyphHeight - y) - 1 - x) & 1)
          set(static_cast<int>(n) * (kGlyphWidth + 1) + x, y);
}

}  // namespace isocast
