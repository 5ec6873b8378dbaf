// The compiled kernels of volumes that are in the program.
#pragma once

#include <span>
#include <string>

namespace isocast {

/// A fat binary: machine code of several devices, and PTX. prefix: what its kernels' names begin with.
struct VolumeImage {
  const char* prefix;
  const void* data;
};
[[nodiscard]] std::span<const VolumeImage> volume_images();
/// That of the longest prefix of a kernel's name.
[[nodiscard]] const VolumeImage& volume_image_of(const std::string& name);

}  // namespace isocast
