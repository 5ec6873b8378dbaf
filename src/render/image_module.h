// What the module `image` offers to image_file.cpp.
#pragma once

#include <isocast/render/image_file.h>

#include <cstdint>

namespace isocast {

/// `target` names the file in error messages only: the result is the file's content. read: a format by
/// OpenImageIO's name; integer samples are divided by the largest of their type.
struct ImageModule {
  std::string (*encode_png)(const std::string& target, int width, int height, const std::uint8_t* rgb);
  std::string (*encode_exr)(const std::string& target, int width, int height,
                            const std::vector<ImageLayer>& layers, const ImageNotes& notes);
  Image (*read)(const char* format, const std::string& path, std::int64_t most_pixels);
};

}  // namespace isocast
