#include "corpus.h"

#include <algorithm>
#include <cctype>

namespace isocast::hostile {
namespace fs = std::filesystem;

Corpus::Corpus(fs::path folder) : folder_(std::move(folder)) {
  std::ifstream index(folder_ / "whole.txt");
  for (MadeFile made; index >> made.name >> made.head >> made.needed; whole_.push_back(made))
    made.bytes = bytes_of(folder_ / "whole" / made.name);
  for (const fs::directory_entry& lie : fs::directory_iterator(folder_ / "lies")) lies_.push_back(lie.path());
  std::ranges::sort(lies_);
}

Corpus::File Corpus::file(std::uint64_t n, const fs::path& scratch) const {
  if (n < whole_.size()) return {folder_ / "whole" / whole_[n].name, Expected::volume};
  if (n < fixed_count()) return {lies_[n - whole_.size()], Expected::error};
  n -= fixed_count();
  const Mutant made = mutant(whole_[n % whole_.size()], n / whole_.size());
  std::ofstream(scratch / made.name, std::ios::binary) << made.bytes;
  return {scratch / made.name, made.expected};
}

std::string fault_of_answer(Expected expected, const std::string& error) {
  constexpr std::size_t kLongest = 1000;
  if (error.empty()) return expected == Expected::error ? "it opens" : "";
  if (expected == Expected::volume) return "it is refused: " + error;
  if (error.size() > kLongest) return "a sentence of " + std::to_string(error.size()) + " characters";
  if (std::ranges::any_of(error, [](unsigned char c) { return std::iscntrl(c); }))
    return "a sentence with control characters: " + error;
  return {};
}

}  // namespace isocast::hostile
