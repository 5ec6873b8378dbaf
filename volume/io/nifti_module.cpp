// Headers through libnifti. It prints its own complaints and repairs what it dislikes, so headers are checked
// before.
#include <fmt/format.h>
#include <isocast/base/module.h>
#include <isocast/volume/grid.h>
#include <isocast/volume/io/nifti_module.h>
#include <nifti/nifti2_io.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>

namespace isocast {
namespace {

nifti_image* convert(const nifti_1_header& header) { return nifti_convert_n1hdr2nim(header, nullptr); }
nifti_image* convert(const nifti_2_header& header) { return nifti_convert_n2hdr2nim(header, nullptr); }

// Why a header in native byte order cannot be used; empty if it can. Both versions name their fields alike.
template <class Header> std::string find_problem(const Header& header) {
  const auto rank = header.dim[0];
  if (rank < 1 || rank > 7) return fmt::format("dim[0] is {}, expected 1 to 7", rank);
  for (int a = 1; a <= rank; ++a) {
    if (a <= 3 && (header.dim[a] < 1 || header.dim[a] > kMaxDim))
      return fmt::format("dim[{}] is {}, expected 1 to {}", a, header.dim[a], kMaxDim);
    if (a > 3 && header.dim[a] > 1)
      return fmt::format("dim[{}] is {}, expected one volume: 1", a, header.dim[a]);
  }
  if (!nifti_is_valid_datatype(header.datatype))
    return fmt::format("the datatype {} is unknown", header.datatype);
  const double offset = static_cast<double>(header.vox_offset);
  if (!(offset >= 0 && offset <= 1e9)) return fmt::format("vox_offset is {}, expected 0 to 1e9", offset);

  // spacings count where no sform replaces them
  for (int a = 1; a <= std::min<int>(3, rank) && header.sform_code <= 0; ++a)
    if (!std::isfinite(header.pixdim[a]) || (header.pixdim[a] == 0 && header.dim[a] > 1))
      return fmt::format("the spacing pixdim[{}] is {}, expected a finite number other than 0", a,
                         header.pixdim[a]);
  return {};
}

template <class Header> NiftiHeader interpret_as(std::span<const std::byte> bytes, int version) {
  NiftiHeader result;
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  const bool swap = header.sizeof_hdr != static_cast<int>(sizeof header);
  if (swap) swap_nifti_header(&header, version);
  result.problem = find_problem(header);
  if (!result.problem.empty()) return result;

  const auto free_image = [](nifti_image* image) { nifti_image_free(image); };
  const std::unique_ptr<nifti_image, decltype(free_image)> image(convert(header), free_image);
  if (!image) {
    result.problem = "libnifti refuses its header";
    return result;
  }
  for (int a = 0; a < 3 && a < image->dim[0]; ++a) result.dims[a] = image->dim[a + 1];
  result.type = nifti_datatype_string(image->datatype);
  result.big_endian = swap != (std::endian::native == std::endian::big);
  result.offset = static_cast<std::uint64_t>(image->iname_offset);
  const nifti_dmat44& world = image->sform_code > 0 ? image->sto_xyz : image->qto_xyz;
  for (int r = 0; r < 3; ++r) std::copy_n(world.m[r], 4, result.world_from_grid[r]);
  if (image->scl_slope != 0 && std::isfinite(image->scl_slope) && std::isfinite(image->scl_inter)) {
    result.slope = image->scl_slope;
    result.intercept = image->scl_inter;
  }
  return result;
}

NiftiHeader interpret(std::span<const std::byte> bytes) {
  nifti_set_debug_level(0);
  const auto problem = [](const char* what) {
    NiftiHeader result;
    result.problem = what;
    return result;
  };
  if (bytes.size() < sizeof(nifti_1_header)) return problem("it ends inside its header of 348 bytes");

  // the size at the start tells the version in either byte order, the magic confirms it
  std::int32_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  if (size != sizeof(nifti_1_header) && size != sizeof(nifti_2_header)) nifti_swap_4bytes(1, &size);
  if (size == sizeof(nifti_1_header)) {
    const char* magic = reinterpret_cast<const char*>(bytes.data()) + offsetof(nifti_1_header, magic);
    if (std::memcmp(magic, "ni1", 4) == 0)
      return problem("it is the header of a pair of files, expected NIfTI in one file");
    if (std::memcmp(magic, "n+1", 4) != 0) return problem("it has no NIfTI magic at byte 344, expected n+1");
    return interpret_as<nifti_1_header>(bytes, 1);
  }
  if (size != sizeof(nifti_2_header))
    return problem("it does not start with a NIfTI header's size, expected 348 or 540");
  if (bytes.size() < sizeof(nifti_2_header)) return problem("it ends inside its header of 540 bytes");
  if (std::memcmp(bytes.data() + offsetof(nifti_2_header, magic), "n+2", 4) != 0)
    return problem("it has no NIfTI magic at byte 4, expected n+2");
  return interpret_as<nifti_2_header>(bytes, 2);
}

constexpr NiftiModule kModule{interpret};

}  // namespace
}  // namespace isocast

ISO_EXPORT_MODULE(isocast::kModule)
