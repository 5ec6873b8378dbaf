#include <fmt/format.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/nifti.h>
#include <isocast/volume/io/nrrd.h>
#include <isocast/volume/io/raw.h>
#include <isocast/volume/io/read_volume.h>
#include <isocast/volume/io/vti.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

struct Reader {
  std::string_view extension;
  Volume (*read)(const std::filesystem::path&);
};
constexpr Reader kReaders[] = {{".nrrd", read_nrrd},
                               {".nhdr", read_nrrd},
                               {".nii", read_nifti},
                               {".nii.gz", read_nifti},
                               {".vti", read_vti}};
constexpr std::string_view kKnownElsewhere[] = {".vdb", ".nvdb", ".mhd", ".mha"};

// Rays need the way back into the grid: three finite axes that are not nearly in one plane.
void check_transform(const Transform& transform, const std::filesystem::path& path) {
  const auto finite = [](const Transform& t) {
    return std::ranges::all_of(t.m, [](const auto& row) {
      return std::ranges::all_of(row, [](double v) { return std::isfinite(v); });
    });
  };
  if (!finite(transform)) throw read_error(path, "its spacing, origin or axes are not finite numbers");
  constexpr double kFlat = 1e-9;
  Double3 axes[3];
  for (int c = 0; c < 3; ++c) axes[c] = normalized({transform.m[0][c], transform.m[1][c], transform.m[2][c]});
  if (std::abs(dot(axes[0], cross(axes[1], axes[2]))) < kFlat || !finite(transform.inverse()))
    throw read_error(path, "its spacing or axes span no volume (a spacing of zero, or axes in one plane)");
}

}  // namespace

Volume read_volume(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string name = lower_case(path.filename().string());
  // these mistakes come before wrong extensions and missing dimensions
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw read_error(path, "there is no such file");
  if (std::filesystem::is_directory(path, ignored))
    throw read_error(path, "it is a folder, a file was expected");
  if (name.ends_with(".raw")) return read_raw(path, options);

  const auto reader =
      std::ranges::find_if(kReaders, [&](const Reader& r) { return name.ends_with(r.extension); });
  if (reader == std::end(kReaders)) {
    const bool known =
        std::ranges::any_of(kKnownElsewhere, [&](std::string_view e) { return name.ends_with(e); });
    throw read_error(path, fmt::format("{}, expected .raw .nrrd .nhdr .nii .nii.gz or .vti",
                                       known ? "this format is not supported by this build"
                                             : "its extension is that of no volume format"));
  }
  if (options != ReadOptions{})
    throw read_error(path, "dims, type, endian and skip can be given for .raw files only");
  Volume volume = reader->read(path);
  check_transform(volume.world_from_grid, path);
  if (!std::isfinite(volume.slope) || volume.slope == 0 || !std::isfinite(volume.intercept))
    throw read_error(path,
                     fmt::format("its values are {} * stored + {}, expected a finite slope other than 0",
                                 volume.slope, volume.intercept));
  return volume;
}

}  // namespace isocast
