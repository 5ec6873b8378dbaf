// Volumes with a name, for tests and demonstrations.
#pragma once

#include <isocast/data_gen/sample.h>

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace isocast {

/// One number that changes a test volume.
struct TestVolumeOption {
  std::string_view name;
  double default_value;
  std::string_view meaning;
};

/// Options by name; those that are missing have their default.
using TestVolumeSettings = std::map<std::string, double, std::less<>>;

struct TestVolume {
  std::string_view name, meaning;
  std::span<const TestVolumeOption> options;
  Field (*make)(const TestVolumeSettings& settings);  // settings are complete
};

/// All of them; their domain is [-1, 1]^3 unless another one is asked for.
[[nodiscard]] std::span<const TestVolume> test_volumes();

/// Null when there is none of that name.
[[nodiscard]] const TestVolume* find_test_volume(std::string_view name);

/// The field of a test volume; throws InputError for an option that it does not have.
[[nodiscard]] Field test_volume_field(const TestVolume& volume, const TestVolumeSettings& settings);

}  // namespace isocast
