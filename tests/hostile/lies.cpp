#include "lies.h"

namespace isocast::hostile {
namespace {

// Each small file under the names of all other formats. A .raw holds whatever it holds.
void add_foreign_extensions(const std::vector<MadeFile>& whole, std::vector<Lie>& lies) {
  const std::vector<std::vector<std::string>> formats = {
      {".nrrd", ".nhdr"}, {".mha", ".mhd"}, {".nii", ".nii.gz"}, {".vti"}, {".vdb"}, {".nvdb"}};
  constexpr std::size_t kSmall = 60000;
  for (const MadeFile& made : whole)
    for (const std::vector<std::string>& format : formats) {
      if (made.bytes.size() > kSmall) continue;
      bool own = false;
      for (const std::string& extension : format) own |= made.name.ends_with(extension);
      for (const std::string& extension : format)
        if (!own) lies.push_back({"is_" + made.name + extension, made.bytes});
    }
}

}  // namespace

std::vector<Lie> make_lies(const std::vector<MadeFile>& whole) {
  std::vector<Lie> lies;
  add_foreign_extensions(whole, lies);
  add_text_lies(whole, lies);
  add_binary_lies(whole, lies);
  add_bombs(whole, lies);
  return lies;
}

}  // namespace isocast::hostile
