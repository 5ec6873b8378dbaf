// Files that claim what they do not hold: each must be refused.
#pragma once

#include "made_file.h"

namespace isocast::hostile {

struct Lie {
  std::string name, bytes;
};

/// Sizes beyond 64 bits or the file, absurd counts, offsets outside, foreign extensions, streams that expand
/// a thousand times.
[[nodiscard]] std::vector<Lie> make_lies(const std::vector<MadeFile>& whole);

/// Those of one kind of format, appended.
void add_text_lies(const std::vector<MadeFile>& whole, std::vector<Lie>& lies);
void add_binary_lies(const std::vector<MadeFile>& whole, std::vector<Lie>& lies);
void add_bombs(const std::vector<MadeFile>& whole, std::vector<Lie>& lies);

[[nodiscard]] inline const std::string& bytes_of(const std::vector<MadeFile>& whole,
                                                 const std::string& name) {
  for (const MadeFile& made : whole)
    if (made.name == name) return made.bytes;
  throw std::logic_error("no file " + name);
}
/// `text` with the first `from` replaced.
[[nodiscard]] inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == text.npos) throw std::logic_error("no " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace isocast::hostile
