// Reading through OpenVDB.
#include <blosc.h>
#include <fmt/format.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/vdb_header.h>
#include <isocast/volume/io/vdb_process.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <istream>
#include <streambuf>

namespace isocast::vdb_process {
namespace {

// The bytes of a file as a stream that throws where it would end.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::span<const std::byte> bytes) {
    char* const begin = const_cast<char*>(reinterpret_cast<const char*>(bytes.data()));
    setg(begin, begin, begin + bytes.size());
  }

 private:
  pos_type seekoff(off_type offset, std::ios_base::seekdir way, std::ios_base::openmode) override {
    const off_type from = way == std::ios_base::beg   ? 0
                          : way == std::ios_base::cur ? gptr() - eback()
                                                      : egptr() - eback();
    const off_type to = from + offset;
    if (to < 0 || to > egptr() - eback()) return pos_type(off_type(-1));
    setg(eback(), eback() + to, egptr());
    return to;
  }
  pos_type seekpos(pos_type to, std::ios_base::openmode mode) override {
    return seekoff(off_type(to), std::ios_base::beg, mode);
  }
};

// The tiles of a node that are not just background.
template <class Node, class T>
void collect_tiles(const Node& node, std::int32_t edge, T background, std::vector<TileBlock>& tiles) {
  for (auto tile = node.cbeginValueAll(); tile; ++tile) {
    const T value = tile.getValue();
    if (!tile.isValueOn() && bits_of(value) == bits_of(background)) continue;
    const openvdb::Coord o = tile.getCoord();
    tiles.push_back({{o.x(), o.y(), o.z()}, edge, {bits_of(value), tile.isValueOn()}});
  }
}

// Reads the tree at the stream's position: the blocks above first, as OpenVDB knows them, then one leaf after
// the other, each written before the next is read.
template <class Tree>
void copy_tree(std::istream& in, bool half, ImageWriter& out, VdbImage& image,
               std::vector<VdbOrigin>& origins, std::vector<TileBlock>& tiles) {
  using T = typename Tree::ValueType;
  // never destroyed: nodes that an error leaves half read cannot be
  auto& tree = *new Tree;
  tree.readTopology(in, half);
  const T background = tree.root().background();
  image.background = bits_of(background);
  T samples[kLeafSamples];
  typename Tree::LeafNodeType::NodeMaskType active;
  collect_tiles(tree.root(), kTreeShifts[0], background, tiles);
  for (auto upper = tree.root().cbeginChildOn(); upper; ++upper) {
    collect_tiles(*upper, kTreeShifts[1], background, tiles);
    for (auto lower = upper->cbeginChildOn(); lower; ++lower) {
      collect_tiles(*lower, kTreeShifts[2], background, tiles);
      for (auto leaf = lower->cbeginChildOn(); leaf; ++leaf) {
        active.load(in);
        openvdb::io::readCompressedValues(in, samples, kLeafSamples, active, half);
        const openvdb::Coord o = leaf->origin();
        origins.push_back({o.x(), o.y(), o.z()});
        out.add(samples, sizeof samples);
        out.add(&active.template getWord<std::uint64_t>(0), 64);
      }
    }
  }
  image.leaf_count = origins.size();
}

// The first grid of a type that can be read, or the one of this name.
const VdbGridHeader& choose_grid(const VdbHeader& header, const std::string& name) {
  const auto readable = [](const VdbGridHeader& g) {
    return g.value_type == "float" || g.value_type == "double" || g.value_type == "int32" ||
           g.value_type == "int64";
  };
  std::string all;
  for (const VdbGridHeader& grid : header.grids) {
    if (name.empty() ? readable(grid) : grid.name == name) {
      if (!readable(grid))
        throw std::runtime_error(
            fmt::format("its grid {} is a tree of {}, expected float, double, int32 or int64",
                        in_quotes(grid.name), in_quotes(grid.value_type)));
      return grid;
    }
    add_to_list(all, fmt::format("{} ({})", in_quotes(grid.name), in_quotes(grid.value_type)));
  }
  throw std::runtime_error(name.empty()
                               ? fmt::format("none of its grids is float, double, int32 or int64: {}", all)
                               : fmt::format("it has no grid {}, only {}", in_quotes(name), all));
}

void copy_transform(std::istream& in, const VdbGridHeader& grid, VdbImage& image) {
  using namespace openvdb::math;
  constexpr std::string_view kAffine[] = {"UniformScaleMap",   "UniformScaleTranslateMap", "ScaleMap",
                                          "ScaleTranslateMap", "TranslationMap",           "UnitaryMap",
                                          "AffineMap"};
  if (std::ranges::find(kAffine, grid.map_type) == std::end(kAffine))
    throw std::runtime_error(
        fmt::format("its grid {} has a transform of type {}, expected one that keeps lines straight",
                    in_quotes(grid.name), in_quotes(grid.map_type)));
  Transform transform;
  transform.read(in);
  const Mat4d world = transform.baseMap()->getAffineMap()->getMat4();  // of row vectors
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) image.world_from_grid[r][c] = world(c, r);
}

// In pieces, for a block may be a thousand times as large as what is stored of it.
void copy_block(const std::byte* stored, std::size_t bytes, ImageWriter& out) {
  constexpr std::size_t kPiece = std::size_t(16) << 20;
  std::size_t item = 0;
  int ignored = 0;
  blosc_cbuffer_metainfo(stored, &item, &ignored);
  std::vector<std::byte> piece(kPiece);
  const std::runtime_error damaged("its compressed grid is damaged");
  if (item == 0 || bytes % item != 0) throw damaged;
  for (std::size_t done = 0, size = 0; done < bytes; done += size) {
    size = std::min(kPiece, bytes - done) / item * item;
    const int first = static_cast<int>(done / item), count = static_cast<int>(size / item);
    if (blosc_getitem(stored, first, count, piece.data()) != static_cast<int>(size)) throw damaged;
    out.add(piece.data(), size);
  }
}

}  // namespace

void read(const std::string& path, const std::string& grid_name) {
  const MappedFile file = map_file(path);
  const VdbHeader header = read_vdb_header(file.bytes);
  const VdbGridHeader& grid = choose_grid(header, grid_name);
  const VdbGridHeader* tree = &grid;
  if (!grid.parent.empty()) {
    const auto parent = std::ranges::find(header.grids, grid.parent, &VdbGridHeader::name);
    if (parent == header.grids.end() || !parent->parent.empty() || parent->value_type != grid.value_type)
      throw std::runtime_error(fmt::format("its grid {} shares the tree of {}, which has none for it",
                                           in_quotes(grid.name), in_quotes(grid.parent)));
    tree = &*parent;
  }

  openvdb::initialize();
  BytesBuffer bytes(file.bytes);
  std::istream in(&bytes);
  in.exceptions(std::ios_base::failbit | std::ios_base::badbit | std::ios_base::eofbit);
  openvdb::io::StreamMetadata::Ptr state(new openvdb::io::StreamMetadata);
  state->setFileVersion(header.format);
  state->setLibraryVersion({header.library_major, header.library_minor});
  state->setCompression(tree->compression);
  state->setHalfFloat(tree->half);
  openvdb::io::setStreamMetadataPtr(in, state, true);

  VdbImage image = {};
  in.seekg(static_cast<std::streamoff>(grid.map_at));
  copy_transform(in, grid, image);
  if (tree != &grid) {  // behind the parent's own transform
    VdbImage ignored = {};
    in.seekg(static_cast<std::streamoff>(tree->map_at));
    copy_transform(in, *tree, ignored);
  }
  image.half_on_disk = tree->half;
  ImageWriter out;
  std::vector<VdbOrigin> origins;
  std::vector<TileBlock> tiles;
  const auto copy = [&]<class Tree>(SparseType type) {
    image.type = type;
    copy_tree<Tree>(in, tree->half, out, image, origins, tiles);
  };
  if (tree->value_type == "float") copy.operator()<openvdb::FloatTree>(SparseType::f32);
  else if (tree->value_type == "double") copy.operator()<openvdb::DoubleTree>(SparseType::f64);
  else if (tree->value_type == "int32") copy.operator()<openvdb::Int32Tree>(SparseType::i32);
  else copy.operator()<openvdb::Int64Tree>(SparseType::i64);
  if (static_cast<std::uint64_t>(in.tellg()) > tree->end)
    throw std::runtime_error(
        fmt::format("its grid {} goes on behind its end at byte {}", in_quotes(tree->name), tree->end));

  std::string text = grid.name + '\0';
  if (const auto found = grid.metadata.find("class"); found != grid.metadata.end()) text += found->second;
  text += '\0';
  for (const VdbGridHeader& other : header.grids)
    if (&other != &grid) text += other.name + '\0';
  image.tile_count = tiles.size();
  image.text_bytes = text.size();
  out.add(origins.data(), origins.size() * sizeof origins[0]);
  out.align();
  out.add(tiles.data(), tiles.size() * sizeof tiles[0]);
  out.add(text.data(), text.size());
  out.add(&image, sizeof image);
  out.flush();
  check_mapped_files();
}

// Blocks of at most 1 GB, as NanoVDB writes them.
void unblosc(const std::string& path, std::uint64_t offset, std::uint64_t size, std::uint64_t bytes) {
  constexpr std::uint64_t kBlock = std::uint64_t(1) << 30;
  const MappedFile file = map_file(path);
  std::span<const std::byte> blocks = file.bytes.subspan(offset, size);
  ImageWriter out;
  for (std::uint64_t done = 0; done < bytes;) {
    std::uint64_t stored = 0;
    std::size_t plain = 0;
    const std::size_t wanted = std::min(kBlock, bytes - done);
    if (blocks.size() >= sizeof stored) {
      std::memcpy(&stored, blocks.data(), sizeof stored);
      blocks = blocks.subspan(sizeof stored);
    }
    if (stored > blocks.size() || blosc_cbuffer_validate(blocks.data(), stored, &plain) != 0 ||
        plain != wanted)
      throw std::runtime_error(
          fmt::format("its compressed grid is damaged or ends after {} of {} bytes", done, bytes));
    copy_block(blocks.data(), wanted, out);
    blocks = blocks.subspan(stored);
    done += wanted;
  }
  out.flush();
  check_mapped_files();
}

}  // namespace isocast::vdb_process
