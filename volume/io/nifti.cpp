#include <fmt/format.h>
#include <isocast/base/module.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/nifti.h>
#include <isocast/volume/io/nifti_module.h>
#include <isocast/volume/io/samples.h>
#include <isocast/volume/io/type_words.h>

#include <algorithm>
#include <optional>

namespace isocast {

Volume read_nifti(const std::filesystem::path& path) {
  // the header's bytes, out of gzip if the file starts like it
  const MappedFile file = map_file(path);
  std::byte start[kNiftiHeaderBytes];
  std::size_t length = std::min(file.bytes.size(), sizeof start);
  std::optional<Inflater> inflater;
  if (length >= 2 && file.bytes[0] == std::byte(0x1f) && file.bytes[1] == std::byte(0x8b))
    length = inflater.emplace(file.bytes, path).read(start);
  else std::copy_n(file.bytes.begin(), length, start);
  const NiftiHeader header =
      module_table<NiftiModule>("nifti", "reading " + path.string()).interpret({start, length});
  if (!header.problem.empty()) throw read_error(path, header.problem);

  // the description
  Volume volume;
  volume.format = "nifti";
  volume.type = sample_type_from_word(header.type, "cannot read " + path.string());
  std::copy_n(header.dims, 3, volume.dims.begin());
  for (int r = 0; r < 3; ++r) std::copy_n(header.world_from_grid[r], 4, volume.world_from_grid.m[r]);
  volume.slope = header.slope;
  volume.intercept = header.intercept;

  // the samples: a compressed stream is read on from behind the header's bytes
  if (!inflater) {
    place_samples(volume, file, header.offset, header.big_endian, path);
    return volume;
  }
  const bool behind = header.offset >= length;
  if (!behind) inflater.emplace(file.bytes, path);
  inflate_samples(volume, *inflater, behind ? header.offset - length : header.offset, header.big_endian,
                  path);
  return volume;
}

}  // namespace isocast
