#include <fmt/format.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/inflate.h>
#include <isocast/volume/io/nanovdb.h>
#include <isocast/volume/io/nanovdb_tree.h>
#include <isocast/volume/io/samples.h>
#include <isocast/volume/io/vdb.h>
#include <nanovdb/util/IO.h>

#include <algorithm>
#include <cstring>

namespace isocast {
namespace {

using nanovdb::io::Codec, nanovdb::io::Header, nanovdb::io::MetaData;

// A grid of a file, as its segment's table tells.
struct StoredGrid {
  std::string name;
  nanovdb::GridType type;
  Codec codec;
  std::uint64_t bytes;  // when it is not compressed
  std::span<const std::byte> stored;
};

constexpr std::string_view kTypes = "Float, Double, Int16, Int32, Int64, Fp4, Fp8, Fp16 or FpN";

bool readable(nanovdb::GridType type) {
  using enum nanovdb::GridType;
  return (type >= Float && type <= Int64) || (type >= Fp4 && type <= FpN);
}

// The tables of all segments. Each is a header, a description of every grid and its name, then the grids.
std::vector<StoredGrid> find_grids(std::span<const std::byte> file, const std::filesystem::path& path) {
  std::vector<StoredGrid> grids;
  std::uint64_t at = 0;
  const auto take = [&](std::uint64_t size, std::string_view what) {
    if (size > file.size() - at)
      throw read_error(path, fmt::format("it ends at byte {} inside {}, which takes {} bytes from byte {} on",
                                         file.size(), what, size, at));
    at += size;
    return file.subspan(at - size, size);
  };
  while (at < file.size()) {
    Header header;
    std::memcpy(static_cast<void*>(&header), take(sizeof header, "a header").data(), sizeof header);
    if (header.magic != NANOVDB_MAGIC_NUMBER)
      throw read_error(path, fmt::format("found {:#x} at byte {}, expected NanoVDB's magic number {:#x}",
                                         header.magic, at - sizeof header, NANOVDB_MAGIC_NUMBER));
    if (header.version.getMajor() != NANOVDB_MAJOR_VERSION_NUMBER)
      throw read_error(path, fmt::format("its version is {}, expected {}", header.version.getMajor(),
                                         NANOVDB_MAJOR_VERSION_NUMBER));
    const std::size_t first = grids.size();
    std::vector<std::uint64_t> sizes;
    for (int i = 0; i < header.gridCount; ++i) {
      MetaData meta;
      std::memcpy(static_cast<void*>(&meta), take(sizeof meta, "a grid's description").data(), sizeof meta);
      const auto name = take(meta.nameSize, "a grid's name");
      const std::string text(reinterpret_cast<const char*>(name.data()), name.size());
      grids.push_back({text.substr(0, text.find('\0')), meta.gridType, meta.codec, meta.gridSize, {}});
      sizes.push_back(meta.fileSize);
    }
    for (std::size_t i = first; i < grids.size(); ++i) grids[i].stored = take(sizes[i - first], "a grid");
  }
  if (grids.empty()) throw read_error(path, "it holds no grid");
  return grids;
}

// The first grid of a type that can be read, or the one of this name.
const StoredGrid& choose_grid(const std::vector<StoredGrid>& grids, const std::string& name,
                              const std::filesystem::path& path) {
  std::string all;
  for (const StoredGrid& grid : grids) {
    const std::string type = nanovdb::toStr(std::min(grid.type, nanovdb::GridType::End));
    if (name.empty() ? readable(grid.type) : grid.name == name) {
      if (readable(grid.type)) return grid;
      throw read_error(path, fmt::format("its grid {} is of type {}, expected one of {}",
                                         in_quotes(grid.name), type, kTypes));
    }
    add_to_list(all, fmt::format("{} ({})", in_quotes(grid.name), type));
  }
  throw read_error(path, name.empty() ? fmt::format("none of its grids is of type {}: {}", kTypes, all)
                                      : fmt::format("it has no grid {}, only {}", in_quotes(name), all));
}

// A grid's bytes: where they are in the file, or in memory of their own.
MappedFile plain_bytes(const StoredGrid& grid, const MappedFile& file, const std::filesystem::path& path) {
  if (grid.codec == Codec::NONE) {
    if (grid.bytes != grid.stored.size())
      throw read_error(path, fmt::format("its grid {} of {} bytes takes {} in the file", in_quotes(grid.name),
                                         grid.bytes, grid.stored.size()));
    return {file.pages, grid.stored};
  }
  check_ratio(grid.bytes, grid.stored.size(), path);
  if (grid.codec == Codec::BLOSC) return inflate_blosc(grid.stored, grid.bytes, file, path);
  if (grid.codec != Codec::ZIP)
    throw read_error(
        path, fmt::format("its compression is number {}, expected 0, 1 (zip) or 2 (blosc)", int(grid.codec)));
  // the compressed size, then a zlib stream
  if (grid.stored.size() < 8) throw read_error(path, "it ends inside a compressed grid");
  const auto memory = std::make_shared_for_overwrite<std::byte[]>(grid.bytes);
  const std::span<std::byte> bytes(memory.get(), grid.bytes);
  Inflater inflater(grid.stored.subspan(8), path);
  if (const std::uint64_t found = inflate_into(bytes, inflater); found != grid.bytes)
    throw read_error(
        path, fmt::format("its grid {} has {} bytes, expected {}", in_quotes(grid.name), found, grid.bytes));
  return {memory, bytes};
}

}  // namespace

Volume read_nanovdb(const std::filesystem::path& path, const std::string& grid_name) {
  const MappedFile file = map_file(path);
  const std::vector<StoredGrid> grids = find_grids(file.bytes, path);
  const StoredGrid& grid = choose_grid(grids, grid_name, path);
  const MappedFile bytes = plain_bytes(grid, file, path);
  Volume volume;
  volume.format = "nanovdb";
  volume.mapped = grid.codec == Codec::NONE;
  for (const StoredGrid& other : grids)
    if (&other != &grid) volume.other_grids.push_back(other.name);
  try {
    set_nanovdb_tree(volume, bytes.bytes, bytes.pages);
  } catch (const SparseTreeError& error) {
    throw read_error(path, fmt::format("its grid {} has {}", in_quotes(grid.name), error.what()));
  }
  volume.grid_name = grid.name;  // in full, where the grid itself keeps 255 bytes
  return volume;
}

}  // namespace isocast
