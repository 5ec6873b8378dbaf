#include <fmt/format.h>
#include <isocast/base/child_process.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/module.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/sparse_volume.h>
#include <isocast/volume/io/vdb.h>
#include <isocast/volume/io/vdb_image.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>

namespace isocast {
namespace {

// A file that lives in memory only.
struct MemoryFile {
  int descriptor = memfd_create("isocast", MFD_CLOEXEC);
  MemoryFile() = default;
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor); }

  [[nodiscard]] MappedFile map() const {
    struct stat status = {};
    fstat(descriptor, &status);
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const pages = size ? mmap(nullptr, size, PROT_READ, MAP_SHARED, descriptor, 0) : MAP_FAILED;
    if (pages == MAP_FAILED) return {};
    return {std::shared_ptr<const void>(pages, [size](const void* p) { munmap(const_cast<void*>(p), size); }),
            {static_cast<const std::byte*>(pages), size}};
  }
};

// OpenVDB's blocks take up to 33 times their bytes in the file, and each step of its reader some of these.
std::uint64_t plausible_memory(std::uint64_t file_bytes) {
  return (std::uint64_t(64) << 20) + 40 * file_bytes;
}
std::uint64_t plausible_seconds(std::uint64_t file_bytes) { return 5 + file_bytes / 1000000; }

// Lets OpenVDB's process do something for a file and gives what it left.
MappedFile ask_openvdb(const std::filesystem::path& path, std::vector<std::string> arguments,
                       std::uint64_t memory, std::uint64_t seconds) {
  const std::filesystem::path program = find_part("isocast_openvdb");
  if (program.empty())
    throw read_error(path, "it needs the part 'openvdb' (isocast_openvdb), which this build does not have");
  arguments.push_back(std::to_string(memory));
  arguments.push_back(std::to_string(seconds));
  const MemoryFile result;
  ChildProcess process(program, arguments, std::array{result.descriptor});
  const ChildProcess::End end = process.finish();
  if (end.status == 2) throw read_error(path, end.message);
  if (end.status == -SIGXCPU || end.status == -SIGKILL)
    throw read_error(path, fmt::format("OpenVDB was not done with it after {} s, it is damaged", seconds));
  if (end.status != 0)
    throw read_error(path, fmt::format("OpenVDB failed on it ({} {}), it is damaged",
                                       end.status < 0 ? "signal" : "status", std::abs(end.status)));
  return result.map();
}

// The parts of an image, none behind its end: it comes from a process that read a stranger's file.
struct ImageParts {
  VdbImage image;
  std::span<const std::byte> leaves, origins, tiles, text;
};
std::optional<ImageParts> split_image(std::span<const std::byte> bytes) {
  ImageParts parts;
  if (bytes.size() < sizeof parts.image) return std::nullopt;
  std::memcpy(&parts.image, bytes.last(sizeof parts.image).data(), sizeof parts.image);
  std::size_t rest = bytes.size() - sizeof parts.image, at = 0;
  bool whole = parts.image.type <= SparseType::i64;
  const auto take = [&](std::uint64_t count, std::size_t size) -> std::span<const std::byte> {
    if (!whole || count > rest / size) {
      whole = false;
      return {};
    }
    const auto part = bytes.subspan(at, count * size);
    at += part.size();
    rest -= part.size();
    return part;
  };
  if (!whole) return std::nullopt;
  parts.leaves = take(parts.image.leaf_count, leaf_bytes(parts.image.type, 0) + 64);
  parts.origins = take(parts.image.leaf_count, sizeof(VdbOrigin));
  take((8 - at % 8) % 8, 1);
  parts.tiles = take(parts.image.tile_count, sizeof(TileBlock));
  parts.text = take(parts.image.text_bytes, 1);
  return whole ? std::optional(parts) : std::nullopt;
}

Volume volume_of(const ImageParts& parts, const MappedFile& memory) {
  const VdbImage& image = parts.image;
  Volume volume;
  volume.format = "vdb";
  volume.half_on_disk = image.half_on_disk;
  for (int r = 0; r < 3; ++r) std::copy_n(image.world_from_grid[r], 4, volume.world_from_grid.m[r]);
  const std::vector<std::string_view> texts = [&] {
    std::vector<std::string_view> found;
    std::string_view text(reinterpret_cast<const char*>(parts.text.data()), parts.text.size());
    for (std::size_t end; (end = text.find('\0')) != text.npos; text.remove_prefix(end + 1))
      found.push_back(text.substr(0, end));
    return found;
  }();
  if (texts.size() >= 2) {
    volume.grid_name = texts[0];
    volume.grid_class = texts[1];
    volume.other_grids.assign(texts.begin() + 2, texts.end());
  }

  const std::size_t size = leaf_bytes(image.type, 0), stride = size + 64;
  std::vector<SparseLeaf> leaves(image.leaf_count);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    leaves[i] = {parts.leaves.data() + i * stride, parts.leaves.data() + i * stride + size, {}, 0};
    std::memcpy(leaves[i].origin, parts.origins.data() + i * sizeof(VdbOrigin), sizeof(VdbOrigin));
  }
  // the mapping is aligned, and the tables in it are to 8 bytes
  const std::span tiles(reinterpret_cast<const TileBlock*>(parts.tiles.data()), image.tile_count);
  set_tree(volume, image.type, image.background, leaves, tiles, memory.pages);
  return volume;
}

}  // namespace

Volume read_vdb(const std::filesystem::path& path, const std::string& grid_name) {
  const std::uint64_t bytes = map_file(path).bytes.size();  // says if it cannot be read
  const MappedFile image = ask_openvdb(path, {"read", path.string(), grid_name}, plausible_memory(bytes),
                                       plausible_seconds(bytes));
  const std::optional<ImageParts> parts = split_image(image.bytes);
  if (!parts) throw read_error(path, "OpenVDB's process left no whole grid");
  try {
    return volume_of(*parts, image);
  } catch (const SparseTreeError& error) {
    throw read_error(path, std::string("its tree has ") + error.what());
  }
}

MappedFile inflate_blosc(std::span<const std::byte> blocks, std::uint64_t bytes, const MappedFile& file,
                         const std::filesystem::path& path) {
  constexpr std::uint64_t kBloscMemory = 160'000'000;  // it works in pieces
  const auto offset = static_cast<std::uint64_t>(blocks.data() - file.bytes.data());
  const MappedFile plain = ask_openvdb(path,
                                       {"unblosc", path.string(), std::to_string(offset),
                                        std::to_string(blocks.size()), std::to_string(bytes)},
                                       kBloscMemory, plausible_seconds(bytes));
  if (plain.bytes.size() != bytes)
    throw read_error(path,
                     fmt::format("its compressed grid has {} bytes, expected {}", plain.bytes.size(), bytes));
  return plain;
}

}  // namespace isocast
