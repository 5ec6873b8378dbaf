// A file that appears under its name only when it is complete.
#pragma once

#include <filesystem>
#include <string>

namespace isocast {

/// Gives a temporary name in the target's folder (with the target's extension, so that writers choose by it),
/// and renames on commit(). Without commit the destructor removes the temporary file and what was on disk
/// before stays untouched.
class OutputFile {
 public:
  /// Throws InputError when the folder does not exist or is not writable, or the target is a folder.
  explicit OutputFile(std::filesystem::path target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  [[nodiscard]] const std::filesystem::path& target() const { return target_; }
  /// Renames the finished temporary file to the target; throws InputError when that fails.
  void commit();

 private:
  std::filesystem::path target_, temporary_;
  bool committed_ = false;
};

/// Writes `text` to `target` through an OutputFile.
void write_text_file(const std::filesystem::path& target, const std::string& text);

}  // namespace isocast
