// What a job of several frames has done, so that it can go on where it was ended.
#pragma once

#include <isocast/base/hash.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace isocast {

/// The hashes of files, each computed once. Throws InputError for a file that cannot be read.
class FileHashes {
 public:
  [[nodiscard]] const std::string& of(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, std::string> known_;
};

/// A file by name and content.
struct HashedFile {
  std::string file, hash;
};

/// A frame that is done.
///
/// job     hash of version, options and frame: all that decides the picture but the content of the inputs
/// inputs  every file that was read for it
/// file    relative to the manifest's folder; hash and bytes: its content
/// ms      what rendering and writing took; finished: in seconds since 1970, UTC
struct FrameRecord {
  int frame = 0;
  std::string job;
  std::vector<HashedFile> inputs;
  std::string file, hash;
  std::uint64_t bytes = 0;
  double ms = 0;
  std::int64_t finished = 0;
};

/// The records of a job as a JSON file. It is written anew, under a temporary name first, as frames are
/// added: at most once a second, and at the end.
class Manifest {
 public:
  /// Begins with the records that the file has. Nothing is written before the first new one.
  Manifest(std::filesystem::path path, std::string version);
  ~Manifest();
  Manifest(const Manifest&) = delete;
  Manifest& operator=(const Manifest&) = delete;

  void add(FrameRecord record);
  /// Writes what was not written yet. Throws InputError where that fails.
  void write();

 private:
  std::filesystem::path path_;
  std::string version_;
  std::map<int, FrameRecord> records_;
  std::chrono::steady_clock::time_point written_ = {};
  bool changed_ = false;
};

/// The manifest's name: beside the pictures, "out_%04d.png" has "out_manifest.json" and its shard "2/8"
/// "out_manifest.2-of-8.json".
[[nodiscard]] std::filesystem::path manifest_path(const std::string& pattern, const std::string& shard);

/// The records of all manifests of a pattern's pictures, whatever their shards, by frame; what is no manifest
/// is left out.
[[nodiscard]] std::multimap<int, FrameRecord> read_manifests(const std::string& pattern);

/// Whether a frame that is to be made as `job` is there: all of its inputs are what they were, and its file
/// is whole.
[[nodiscard]] bool is_done(const FrameRecord& record, const std::string& job,
                           const std::filesystem::path& file, FileHashes& hashes);

}  // namespace isocast
