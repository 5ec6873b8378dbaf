// A file's bytes, mapped read-only.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace isocast {

/// The whole file as read-only pages; `pages` keeps the mapping alive. An empty file gives an empty span.
/// Where the file shrinks meanwhile, the bytes that are gone read as zeros: see check_mapped_files.
struct MappedFile {
  std::shared_ptr<const void> pages;
  std::span<const std::byte> bytes;
};

/// Maps a regular file. Throws InputError (with the path) when it does not exist, is a folder or no regular
/// file, may not be read, or when 1024 files are mapped already.
///
/// signals  the first call installs a SIGBUS handler; what is none of a mapped file's pages goes on to the
///          handler that was there before
[[nodiscard]] MappedFile map_file(const std::filesystem::path& path);

/// The files that map_file was asked for since the last call, each once, in the order of their first time:
/// all that was read. Files that another process or a library reads for this one are mapped first as well.
[[nodiscard]] std::vector<std::filesystem::path> take_files_read();

/// Throws InputError (with the path) if a file that is mapped now has shrunk: what was computed from its
/// bytes is worth nothing. To be called between the last use of the bytes and the first use of what came out.
void check_mapped_files();

}  // namespace isocast
