// Volumes that are read once, whoever needs them.
#pragma once

#include <isocast/apps/scene_build/description.h>

#include <map>
#include <memory>
#include <string>

namespace isocast {

/// Not for several threads.
class VolumeLibrary {
 public:
  /// The volume of a source, read if it is not here yet. Throws InputError.
  [[nodiscard]] std::shared_ptr<const Volume> get(const VolumeSource& source);

 private:
  std::map<std::string, std::shared_ptr<const Volume>> volumes_;
};

}  // namespace isocast
