#include <fmt/format.h>
#include <isocast/apps/scene_build/volume_library.h>
#include <isocast/base/mapped_file.h>

namespace isocast {

VolumeLibrary::Entry& VolumeLibrary::find(const VolumeSource& source) {
  const ReadOptions& read = source.read;
  std::string key = fmt::format("{}\n{}\n{} {}", source.file.string(), read.grid, read.big_endian, read.skip);
  if (read.type) key += fmt::format("\n{}", name_of(*read.type));
  if (read.dims) key += fmt::format("\n{} {} {}", (*read.dims)[0], (*read.dims)[1], (*read.dims)[2]);
  auto found = entries_.find(key);
  if (found == entries_.end()) {
    auto volume = std::make_shared<const Volume>(read_volume(source.file, source.read));
    found = entries_.emplace(key, Entry{std::move(volume), nullptr}).first;
  }
  found->second.used = true;
  return found->second;
}

std::shared_ptr<const Volume> VolumeLibrary::get(const VolumeSource& source) { return find(source).volume; }

std::shared_ptr<const VolumeStatistics> VolumeLibrary::statistics(const VolumeSource& source) {
  Entry& entry = find(source);
  if (!entry.statistics) {
    entry.statistics = std::make_shared<const VolumeStatistics>(statistics_of(*entry.volume));
    check_mapped_files();
  }
  return entry.statistics;
}

void VolumeLibrary::drop_unused() {
  std::erase_if(entries_, [](const auto& entry) { return !entry.second.used; });
  for (auto& [key, entry] : entries_) entry.used = false;
}

}  // namespace isocast
