// Small files that would take much memory or time.
#include <blosc.h>

#include "lies.h"
#include "pack.h"

namespace isocast::hostile {
namespace {

// Thousandfold streams of 180 MB, in one of 195 MB or of 1 GB; and a hundredfold one of 327 MB that claims
// 340 MB.
constexpr std::size_t kPiece = std::size_t(1) << 16;
const char* const kClosely = "580 580 580";
const char* const kFar = "1000 1000 1000";
const char* const kHundredfold = "700 700 694";

std::string nrrd(const std::string& sizes, const std::string& stream) {
  return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " + sizes + "\nencoding: gzip\n\n" + stream;
}
std::string mha(const std::string& sizes, const std::string& stream) {
  return "NDims = 3\nDimSize = " + sizes +
         "\nElementType = MET_UCHAR\nCompressedData = True\nElementDataFile = LOCAL\n" + stream;
}

std::string blosc(const std::string& plain) {
  std::string out(plain.size() / 2, '\0');
  const int size =
      blosc_compress_ctx(9, 1, 4, plain.size(), plain.data(), out.data(), out.size(), "lz4", 0, 1);
  out.resize(static_cast<std::size_t>(size));
  return out;
}

// A NanoVDB segment of one float grid of so many bytes.
std::string nvdb(std::uint64_t bytes, std::uint16_t codec, const std::string& stored,
                 const std::string& whole) {
  std::string head = whole.substr(0, 197);
  head.replace(14, 2, number(codec));
  head.replace(16, 16, number(bytes) + number(static_cast<std::uint64_t>(stored.size())));
  head.replace(184, 2, number(codec));
  return head + stored;
}

std::string text(const std::string& t) { return number(static_cast<std::uint32_t>(t.size())) + t; }

// Many grids in one place, with many metadata.
std::string crowded_vdb(const std::string& whole) {
  constexpr std::uint32_t kGrids = 20000, kMetadata = 40000;
  std::string own = number(0u) + number(kMetadata);
  for (std::uint32_t i = 0; i < kMetadata; ++i)
    own += text(std::to_string(i)) + text("string") + text("long enough for the heap");
  own += text("UniformScaleMap");
  const std::string head = whole.substr(0, 61) + number(kGrids),
                    name = text("a") + text("Tree_float_5_4_3") + text("");
  const std::uint64_t begin = head.size() + kGrids * (name.size() + 24), end = begin + own.size();
  std::string bytes = head;
  for (std::uint32_t i = 0; i < kGrids; ++i) bytes += name + number(begin) + number(begin) + number(end);
  return bytes + own;
}

// Many grids one after the other, none of a type that is known.
std::string odd_vdb(const std::string& whole) {
  constexpr std::uint32_t kGrids = 3000;
  const std::string own = number(0u) + number(0u) + text("UniformScaleMap");
  std::string bytes = whole.substr(0, 61) + number(kGrids);
  for (std::uint32_t i = 0; i < kGrids; ++i) {
    bytes += text("a\nname") + text("a\ntype") + text("");
    const std::uint64_t begin = bytes.size() + 24, end = begin + own.size();
    bytes += number(begin) + number(begin) + number(end) + own;
  }
  return bytes;
}
std::string odd_nvdb(const std::string& whole) {
  constexpr std::uint16_t kGrids = 3000;
  std::string meta = whole.substr(16, 181);
  meta.replace(0, 16, 16, '\0');
  meta.replace(32, 4, number(99u));
  std::string bytes = whole.substr(0, 12) + number(kGrids) + whole.substr(14, 2);
  for (int i = 0; i < kGrids; ++i) bytes += meta;
  return bytes;
}

// 340 blocks of a megabyte in zlib, the last of them too small.
std::string vti_of_blocks(const std::string& piece) {
  constexpr std::uint32_t kBlocks = 340, kBlock = 1u << 20;
  const std::string block = zlib(piece, kBlock / kPiece), last = zlib(piece);
  std::string bytes =
      R"(<VTKFile type="ImageData" byte_order="LittleEndian" header_type="UInt32" )"
      R"(compressor="vtkZLibDataCompressor"><ImageData><Piece Extent="0 1023 0 1023 0 339">)"
      R"(<PointData><DataArray type="UInt8" Name="s" format="appended" offset="0"/></PointData>)"
      R"(</Piece></ImageData><AppendedData encoding="raw">_)" +
      number(kBlocks) + number(kBlock) + number(0u);
  for (std::uint32_t i = 1; i < kBlocks; ++i) bytes += number(static_cast<std::uint32_t>(block.size()));
  bytes += number(static_cast<std::uint32_t>(last.size()));
  for (std::uint32_t i = 1; i < kBlocks; ++i) bytes += block;
  return bytes + last + "</AppendedData></VTKFile>";
}

}  // namespace

void add_bombs(const std::vector<MadeFile>& whole, std::vector<Lie>& lies) {
  const std::string zeros(kPiece, '\0'), gz = gzip(zeros, 2750), z = zlib(zeros, 2750);
  for (const char* const sizes : {kClosely, kFar}) {
    const std::string end = std::string(sizes) == kFar ? "_far" : "";
    lies.push_back({"bomb" + end + ".nrrd", nrrd(sizes, gz)});
    lies.push_back({"bomb" + end + ".mha", mha(sizes, z)});
  }
  lies.push_back(
      {"bomb_skip.nrrd", replaced(nrrd("2 2 2", gz), "encoding", "byte skip: 9000000000000\nencoding")});

  std::string noisy = zeros;
  for (std::size_t i = 0; i < 400; ++i) noisy[i] = static_cast<char>(i * i * i >> 7);
  lies.push_back({"bomb_blocks.vti", vti_of_blocks(noisy)});
  lies.push_back({"bomb_hundred.nrrd", nrrd(kHundredfold, gzip(noisy, 5000))});

  std::string nifti = bytes_of(whole, "plain.nii").substr(0, 352);
  nifti.replace(42, 6, number<std::int16_t>(500) + number<std::int16_t>(500) + number<std::int16_t>(390));
  lies.push_back({"bomb.nii.gz", gzip(nifti) + gz});

  const std::string& plain = bytes_of(whole, "plain.nvdb");
  const std::string run = blosc(std::string(195'000'000, '\0'));
  lies.push_back({"bomb_blosc.nvdb", nvdb(195'000'000, 2, number(std::uint64_t(run.size())) + run, plain)});
  lies.push_back({"bomb_zip.nvdb", nvdb(195'000'000, 1, number(std::uint64_t(z.size())) + z, plain)});
  lies.push_back({"bomb_far.nvdb", nvdb(1'000'000'000, 1, number(std::uint64_t(z.size())) + z, plain)});

  std::string elements = "<VTKFile>";
  for (int i = 0; i < 3'000'000; ++i) elements += "<a/>";
  lies.push_back({"bomb.vti", elements + "</VTKFile>"});
  lies.push_back({"bomb_odd.vdb", odd_vdb(bytes_of(whole, "plain.vdb"))});
  lies.push_back({"bomb_odd.nvdb", odd_nvdb(plain)});
  lies.push_back({"bomb_crowded.vdb", crowded_vdb(bytes_of(whole, "plain.vdb"))});
}

}  // namespace isocast::hostile
