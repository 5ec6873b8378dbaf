// Headers of numbers that claim too much: .nii, blocks of .vti, .vdb, .nvdb.
#include "lies.h"
#include "pack.h"

namespace isocast::hostile {
namespace {

class Patches {
 public:
  Patches(const std::vector<MadeFile>& whole, std::vector<Lie>& lies) : whole_(whole), lies_(lies) {}

  void add(const std::string& made, std::size_t at, const std::string& patch) {
    std::string bytes = bytes_of(whole_, made);
    bytes.replace(at, patch.size(), patch);
    lies_.push_back({"patch_" + std::to_string(n_++) + made.substr(made.find('.')), bytes});
  }

 private:
  const std::vector<MadeFile>& whole_;
  std::vector<Lie>& lies_;
  int n_ = 0;
};

constexpr std::uint32_t kMost32 = 0xffffffff;
constexpr std::uint64_t kMost64 = ~std::uint64_t(0);

template <class N> N number_at(const std::string& bytes, std::size_t at) {
  N value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void add_nifti(Patches& patches) {
  for (const char* const made : {"plain.nii", "float.nii"}) {
    patches.add(made, 42, number<std::int16_t>(14));
    patches.add(made, 42, number<std::int64_t>(0x7fff7fff7fff));
    patches.add(made, 42, number<std::int16_t>(-1));
    for (const std::int16_t rank : {-1, 0, 8, 32767}) patches.add(made, 40, number(rank));
    for (const float offset : {-1.0f, 1e9f, 1e30f, __builtin_nanf(""), __builtin_inff()})
      patches.add(made, 108, number(offset));
  }
}

// The words before the blocks: their number, the size of one, that of the last, compressed sizes.
void add_vti(const std::vector<MadeFile>& whole, Patches& patches) {
  const std::string& bytes = bytes_of(whole, "zlib.vti");
  const std::size_t words = bytes.find("\">_") + 3;
  for (const std::uint32_t word : {0u, 1u, 0x7fffffffu, kMost32})
    patches.add("zlib.vti", words, number(word));
  for (const std::uint32_t word : {0u, 1u, 0x7fffffffu, kMost32})
    patches.add("zlib.vti", words + 4, number(word));
  for (const std::uint32_t word : {0u, 1u, kMost32}) patches.add("zlib.vti", words + 12, number(word));
  patches.add("raw.vti", bytes_of(whole, "raw.vti").find("\">_") + 3, number(1u));
}

// Counts of metadata, grids, root tiles and root children, lengths of texts, places of grids.
void add_vdb(const std::vector<MadeFile>& whole, Patches& patches) {
  const std::string& bytes = bytes_of(whole, "plain.vdb");
  constexpr std::size_t kMetadata = 57, kGrids = 61, kName = 65;
  const std::size_t places = bytes.find("Tree_float_5_4_3") + 16 + 4, own = places + 24,
                    tree = bytes.find("UniformScaleMap") + 15 + 120;
  for (const std::size_t at : {kMetadata, kGrids, kName, own + 4, own + 8, tree + 8, tree + 12})
    for (const std::uint32_t count : {0x7fffffffu, 0x80000000u, kMost32})
      patches.add("plain.vdb", at, number(count));
  patches.add("plain.vdb", kGrids, number(0u));
  for (const std::size_t at : {places, places + 16})
    for (const std::uint64_t place : {std::uint64_t(0), std::uint64_t(1) << 63, kMost64})
      patches.add("plain.vdb", at, number(place));
  patches.add("plain.vdb", 8, number(225u));
  patches.add("plain.vdb", 0, "VDB");
}

// Counts and sizes of the segment; the root's table, and children before, behind and around the grid.
void add_nvdb(const std::vector<MadeFile>& whole, Patches& patches) {
  constexpr std::size_t kGridSize = 16, kFileSize = 24, kNameSize = 152, kCodec = 184, kName = 192,
                        kGridData = 672;
  for (const char* const made : {"plain.nvdb", "fp4.nvdb", "fpn.nvdb", "zip.nvdb", "blosc.nvdb"}) {
    patches.add(made, 12, number<std::uint16_t>(0));
    patches.add(made, 12, number<std::uint16_t>(0xffff));
    for (const std::uint64_t size : {std::uint64_t(1) << 30, std::uint64_t(1) << 62, kMost64})
      for (const std::size_t at : {kGridSize, kFileSize}) patches.add(made, at, number(size));
    patches.add(made, kNameSize, number(kMost32));
    patches.add(made, kCodec, number<std::uint16_t>(77));
    const std::string& bytes = bytes_of(whole, made);
    if (number_at<std::uint16_t>(bytes, kCodec) != 0) continue;
    const std::size_t grid = kName + number_at<std::uint32_t>(bytes, kNameSize), tree = grid + kGridData,
                      root = tree + number_at<std::uint64_t>(bytes, tree + 24), tile = root + 64,
                      upper = root + number_at<std::uint64_t>(bytes, tile + 8), children = upper + 32 + 4096;
    patches.add(made, root + 24, number(kMost32));
    for (const std::uint64_t offset : {std::uint64_t(1) << 40, std::uint64_t(1) << 63, kMost64 >> 1}) {
      patches.add(made, tree + 24, number(offset));
      patches.add(made, tile + 8, number(offset));
    }
    patches.add(made, children, std::string(4096, '\xff'));
  }
}

}  // namespace

void add_binary_lies(const std::vector<MadeFile>& whole, std::vector<Lie>& lies) {
  Patches patches(whole, lies);
  add_nifti(patches);
  add_vti(whole, patches);
  add_vdb(whole, patches);
  add_nvdb(whole, patches);
}

}  // namespace isocast::hostile
