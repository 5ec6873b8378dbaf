// usage: hostile_files FOLDER
#include "lies.h"

namespace isocast::hostile {
namespace {
namespace fs = std::filesystem;

void write_corpus(const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder / "lies");
  fs::create_directories(folder / "whole");
  std::vector<MadeFile> whole = make_dense_files(folder / "whole");
  for (MadeFile& made : make_sparse_files(folder / "whole")) whole.push_back(std::move(made));
  std::ofstream index(folder / "whole.txt");
  for (const MadeFile& made : whole) {
    index << made.name << ' ' << made.head << ' ' << made.needed << '\n';
    std::ofstream(folder / "whole" / made.name, std::ios::binary) << made.bytes;
  }
  for (const Lie& lie : make_lies(whole))
    std::ofstream(folder / "lies" / lie.name, std::ios::binary) << lie.bytes;
}

}  // namespace
}  // namespace isocast::hostile

int main(int, char** words) { isocast::hostile::write_corpus(words[1]); }
