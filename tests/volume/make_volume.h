// Volumes made in memory for tests.
#pragma once

#include <isocast/volume/volume.h>
#include <isocast/volume/volume_surface.h>

#include <array>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

namespace isocast::test {

/// f(i, j, k) at every sample, converted to `type` (f16 from its bits is not made here).
inline std::shared_ptr<Volume> make_volume(
    std::array<std::int64_t, 3> dims, SampleType type,
    const std::function<double(std::int64_t, std::int64_t, std::int64_t)>& f) {
  auto volume = std::make_shared<Volume>();
  volume->type = type;
  volume->dims = dims;
  auto buffer = std::make_shared<std::vector<std::byte>>(static_cast<std::size_t>(volume->bytes()));
  std::byte* to = buffer->data();
  for (std::int64_t k = 0; k < dims[2]; ++k)
    for (std::int64_t j = 0; j < dims[1]; ++j)
      for (std::int64_t i = 0; i < dims[0]; ++i)
        visit_sample_type(type, [&](auto tag) {
          using S = typename decltype(tag)::Type;
          S value;
          if constexpr (std::is_same_v<S, Half>) value.bits = static_cast<std::uint16_t>(f(i, j, k));
          else value = static_cast<S>(f(i, j, k));
          std::memcpy(to, &value, sizeof value);
          to += sizeof value;
        });
  volume->samples = buffer->data();
  volume->storage = buffer;
  return volume;
}

/// One iso-value with a method's defaults.
inline VolumeSurfaceOptions surface_options(double iso, Isa isa = widest_isa(),
                                            const char* method = "marmitt") {
  VolumeSurfaceOptions options;
  options.iso = {iso};
  options.method = choose_cell_method(method, {});
  options.isa = isa;
  return options;
}

}  // namespace isocast::test
