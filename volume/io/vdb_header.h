// Which grids an OpenVDB file holds and where, read without OpenVDB, so that every size is checked first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace isocast {

/// A grid of the file. Bytes [begin, end) are its own.
///
/// value_type     "float", "double" ... of a tree of the standard shape; else the whole name of its type
/// name           as users know it; several grids may have the same
/// parent         the name of the grid whose tree it shares; empty if it has its own
/// compression    OpenVDB's flags for the tree
/// metadata       those that are text or true/false ("true", "false")
/// map_at         where its transform begins; the tree follows it
struct VdbGridHeader {
  std::string name, value_type, parent, map_type;
  bool half = false;
  std::uint64_t begin = 0, map_at = 0, end = 0;
  std::uint32_t compression = 0;
  std::map<std::string, std::string> metadata;
};
struct VdbHeader {
  std::uint32_t format = 0, library_major = 0, library_minor = 0;
  std::vector<VdbGridHeader> grids;
};

/// Throws std::runtime_error with what was found and expected: for anything but an OpenVDB file of format 222
/// (OpenVDB 1.1) or later, names or metadata that end behind the file, and grids
/// that do.
[[nodiscard]] VdbHeader read_vdb_header(std::span<const std::byte> file);

}  // namespace isocast
