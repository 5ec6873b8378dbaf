// Headers of NIfTI-1 and NIfTI-2, byte by byte as nifti1.h and nifti2.h of the Data Format Working Group have
// them.
#include <isocast/data_gen/volume_header.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace isocast {
namespace {

// Where a version keeps its fields, and as which numbers.
struct Nifti1 {
  using Dim = std::int16_t;
  using Real = float;
  using Offset = float;
  using Code = std::int16_t;
  static constexpr std::string_view kMagic = std::string_view("n+1\0", 4);
  static constexpr std::size_t kBytes = 348, kMagicAt = 344, kDatatype = 70, kBitpix = 72, kDim = 40,
                               kPixdim = 76, kOffset = 108, kSlope = 112, kIntercept = 116, kSformCode = 254,
                               kSform = 280;
};
struct Nifti2 {
  using Dim = std::int64_t;
  using Real = double;
  using Offset = std::int64_t;
  using Code = std::int32_t;
  static constexpr std::string_view kMagic = std::string_view("n+2\0\r\n\032\n", 8);
  static constexpr std::size_t kBytes = 540, kMagicAt = 4, kDatatype = 12, kBitpix = 14, kDim = 16,
                               kPixdim = 104, kOffset = 168, kSlope = 176, kIntercept = 184, kSformCode = 348,
                               kSform = 400;
};

constexpr std::int16_t kDatatypes[] = {2, 256, 512, 4, 768, 8, 0, 16, 64};  // by SampleType

template <class N> void put(std::string& header, std::size_t at, N value) {
  std::memcpy(header.data() + at, &value, sizeof value);
}

template <class Version> std::string header_of(const StoredVolume& volume) {
  using Dim = typename Version::Dim;
  using Real = typename Version::Real;
  constexpr std::size_t kExtensions = 4;  // none: zeros
  std::string header(Version::kBytes + kExtensions, '\0');
  header.replace(Version::kMagicAt, Version::kMagic.size(), Version::kMagic);
  put(header, 0, static_cast<std::int32_t>(Version::kBytes));
  put(header, Version::kOffset, static_cast<typename Version::Offset>(header.size()));
  put(header, Version::kDatatype, kDatatypes[int(volume.type)]);
  put(header, Version::kBitpix, static_cast<std::int16_t>(8 * size_of(volume.type)));
  put(header, Version::kSlope, static_cast<Real>(volume.slope));
  put(header, Version::kIntercept, static_cast<Real>(volume.intercept));

  // rank and sizes; a sign of the third axis and spacings; rows of the sform
  constexpr typename Version::Code kScanner = 1;
  put(header, Version::kSformCode, kScanner);
  put(header, Version::kDim, Dim(3));
  put(header, Version::kPixdim, Real(1));
  for (std::size_t a = 0; a < 7; ++a)
    put(header, Version::kDim + (a + 1) * sizeof(Dim), static_cast<Dim>(a < 3 ? volume.grid.dims[a] : 1));
  for (std::size_t a = 0; a < 3; ++a) {
    const auto spacing = static_cast<Real>(volume.grid.spacing(int(a)));
    put(header, Version::kPixdim + (a + 1) * sizeof(Real), spacing);
    put(header, Version::kSform + 5 * a * sizeof(Real), spacing);
    put(header, Version::kSform + (4 * a + 3) * sizeof(Real), static_cast<Real>(volume.grid.domain.lo[a]));
  }
  return header;
}

// Are start + i * step, i up to `steps`, within a hundredth of a step as floats?
bool fits_floats(double start, double step, double steps) {
  const auto off = [](double v) { return std::abs(static_cast<double>(static_cast<float>(v)) - v); };
  return off(start) + steps * off(step) <= 0.01 * step;
}

bool fits_nifti1(const StoredVolume& volume) {
  const SampleGrid& grid = volume.grid;
  for (int a = 0; a < 3; ++a)
    if (grid.dims[a] > std::numeric_limits<Nifti1::Dim>::max() ||
        !fits_floats(grid.domain.lo[a], grid.spacing(a), static_cast<double>(grid.dims[a])))
      return false;
  const auto [lowest, largest] = integer_range(volume.type);
  return fits_floats(volume.intercept, volume.slope, largest - lowest);
}

}  // namespace

std::string nifti_header(const StoredVolume& volume) {
  return fits_nifti1(volume) ? header_of<Nifti1>(volume) : header_of<Nifti2>(volume);
}

}  // namespace isocast
