// A file's bytes, mapped read-only.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

namespace isocast {

/// The whole file as read-only pages; `pages` keeps the mapping alive. An empty file gives an empty span.
struct MappedFile {
  std::shared_ptr<const void> pages;
  std::span<const std::byte> bytes;
};

/// Maps a regular file. Throws InputError (with the path) when it does not exist, is a folder or no regular
/// file, or may not be read.
[[nodiscard]] MappedFile map_file(const std::filesystem::path& path);

}  // namespace isocast
