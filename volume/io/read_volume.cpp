#include <fmt/format.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/metaimage.h>
#include <isocast/volume/io/nanovdb.h>
#include <isocast/volume/io/nifti.h>
#include <isocast/volume/io/nrrd.h>
#include <isocast/volume/io/raw.h>
#include <isocast/volume/io/read_volume.h>
#include <isocast/volume/io/vdb.h>
#include <isocast/volume/io/vti.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

struct Reader {
  std::string_view extension;
  Volume (*read)(const std::filesystem::path&);
};
constexpr Reader kReaders[] = {{".nrrd", read_nrrd},     {".nhdr", read_nrrd}, {".mhd", read_metaimage},
                               {".mha", read_metaimage}, {".nii", read_nifti}, {".nii.gz", read_nifti},
                               {".vti", read_vti}};
struct GridReader {
  std::string_view extension;
  Volume (*read)(const std::filesystem::path&, const std::string& grid);
};
constexpr GridReader kGridReaders[] = {{".vdb", read_vdb}, {".nvdb", read_nanovdb}};

Volume read_as(const std::string& name, const std::filesystem::path& path, const ReadOptions& options) {
  const auto fits = [&](const auto& reader) { return name.ends_with(reader.extension); };
  if (name.ends_with(".raw")) {
    if (!options.grid.empty()) throw read_error(path, "a grid can be chosen in .vdb and .nvdb files only");
    return read_raw(path, options);
  }
  if (options.describes_raw())
    throw read_error(path, "dims, type, endian and skip can be given for .raw files only");
  if (const auto reader = std::ranges::find_if(kGridReaders, fits); reader != std::end(kGridReaders))
    return reader->read(path, options.grid);
  const auto reader = std::ranges::find_if(kReaders, fits);
  if (reader == std::end(kReaders))
    throw read_error(path,
                     "its extension is that of no volume format, expected .raw .nrrd .nhdr .mhd .mha .nii "
                     ".nii.gz .vti .vdb or .nvdb");
  if (!options.grid.empty()) throw read_error(path, "a grid can be chosen in .vdb and .nvdb files only");
  return reader->read(path);
}

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

bool has_volume_extension(const std::filesystem::path& path) {
  const std::string name = lower_case(path.filename().string());
  const auto fits = [&](const auto& reader) { return name.ends_with(reader.extension); };
  return name.ends_with(".raw") || std::ranges::any_of(kReaders, fits) ||
         std::ranges::any_of(kGridReaders, fits);
}

Volume read_volume(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string name = lower_case(path.filename().string());
  // these mistakes come before wrong extensions and missing dimensions
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw read_error(path, "there is no such file");
  if (std::filesystem::is_directory(path, ignored))
    throw read_error(path, "it is a folder, a file was expected");
  Volume volume = read_as(name, path, options);
  check_transform(volume.world_from_grid, path);
  if (!std::isfinite(volume.slope) || volume.slope == 0 || !std::isfinite(volume.intercept))
    throw read_error(path,
                     fmt::format("its values are {} * stored + {}, expected a finite slope other than 0",
                                 volume.slope, volume.intercept));
  return volume;
}

}  // namespace isocast
