// Volumes that are read and looked through once, whoever needs them.
#pragma once

#include <isocast/apps/scene_build/description.h>
#include <isocast/volume/statistics.h>

#include <map>
#include <memory>
#include <string>

namespace isocast {

/// Not for several threads.
class VolumeLibrary {
 public:
  /// The volume of a source, read if it is not here yet. Throws InputError.
  [[nodiscard]] std::shared_ptr<const Volume> get(const VolumeSource& source);
  /// The statistics of that volume.
  [[nodiscard]] std::shared_ptr<const VolumeStatistics> statistics(const VolumeSource& source);
  /// Drops the volumes that nobody has asked for since it was called last.
  void drop_unused();

 private:
  struct Entry {
    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const VolumeStatistics> statistics;
    bool used = false;
  };
  Entry& find(const VolumeSource& source);
  std::map<std::string, Entry> entries_;
};

}  // namespace isocast
