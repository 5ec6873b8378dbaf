// Colours by another field, from their description.
#pragma once

#include <isocast/apps/scene_build/volume_library.h>
#include <isocast/scene/color_field.h>
#include <isocast/scene/color_map.h>

#include <memory>

namespace isocast {

/// The field of a description, opened by the library. Without a range: a volume's least and largest value, or
/// [-1, 1]; with `logarithmic` what is not above 0 has no value. What has no value gets nan_color. Throws
/// InputError for files, maps and ranges that cannot be used.
[[nodiscard]] std::shared_ptr<const ColorField> make_color_field(const ColorBy& description,
                                                                 VolumeLibrary& library);

/// A colour map of ParaView (.json with RGBPoints), or one by name.
[[nodiscard]] ColorMap read_color_map(const std::string& name);

}  // namespace isocast
