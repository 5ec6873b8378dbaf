#include <fmt/format.h>
#include <isocast/apps/scene_build/volume_library.h>

namespace isocast {

std::shared_ptr<const Volume> VolumeLibrary::get(const VolumeSource& source) {
  const ReadOptions& read = source.read;
  std::string key = fmt::format("{}\n{}\n{} {}", source.file.string(), read.grid, read.big_endian, read.skip);
  if (read.type) key += fmt::format("\n{}", name_of(*read.type));
  if (read.dims) key += fmt::format("\n{} {} {}", (*read.dims)[0], (*read.dims)[1], (*read.dims)[2]);
  std::shared_ptr<const Volume>& volume = volumes_[key];
  if (!volume) volume = std::make_shared<const Volume>(read_volume(source.file, source.read));
  return volume;
}

}  // namespace isocast
