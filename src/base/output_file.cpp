#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/output_file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace isocast {
namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
  std::error_code ignored;
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    throw InputError(
        fmt::format("cannot write {}: the folder {} does not exist", target_.string(), folder.string()));
  if (fs::is_directory(target_, ignored))
    throw InputError(
        fmt::format("cannot write {}: it is a folder, a file name was expected", target_.string()));
  if (access(folder.c_str(), W_OK) != 0)
    throw InputError(
        fmt::format("cannot write {}: no permission to write in {}", target_.string(), folder.string()));
  temporary_ =
      folder / fmt::format(".{}.{}.part{}", target_.stem().string(), getpid(), target_.extension().string());
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) throw InputError(fmt::format("cannot write {}: {}", target_.string(), error.message()));
  committed_ = true;
}

void write_text_file(const fs::path& target, const std::string& text) {
  OutputFile file(target);
  std::ofstream out(file.temporary(), std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) throw InputError(fmt::format("cannot write {}: {}", target.string(), std::strerror(errno)));
  file.commit();
}

}  // namespace isocast
