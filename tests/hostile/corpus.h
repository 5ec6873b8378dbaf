// The folder of whole files and lies, and every file that is made of them.
#pragma once

#include <filesystem>
#include <vector>

#include "mutant.h"

namespace isocast::hostile {

/// Numbered: the whole files, the lies, then the mutants, one of each whole file after the other.
class Corpus {
 public:
  explicit Corpus(std::filesystem::path folder);

  [[nodiscard]] std::uint64_t whole_count() const { return whole_.size(); }
  /// Of whole files and lies.
  [[nodiscard]] std::uint64_t fixed_count() const { return whole_.size() + lies_.size(); }
  /// Where file n lies; a mutant is written to `scratch`, a folder of the caller's own, first.
  struct File {
    std::filesystem::path path;
    Expected expected;
  };
  [[nodiscard]] File file(std::uint64_t n, const std::filesystem::path& scratch) const;

 private:
  std::filesystem::path folder_;
  std::vector<MadeFile> whole_;
  std::vector<std::filesystem::path> lies_;
};

/// What is wrong with a reader's answer to a file: with its error, which should be one sentence, or (empty)
/// with none; empty if nothing is.
[[nodiscard]] std::string fault_of_answer(Expected expected, const std::string& error);

}  // namespace isocast::hostile
