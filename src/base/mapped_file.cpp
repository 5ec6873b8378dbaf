#include <fcntl.h>
#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace isocast {

MappedFile map_file(const std::filesystem::path& path) {
  const auto fail = [&](const char* why) -> void {
    throw InputError(fmt::format("cannot read {}: {}", path.string(), why));
  };
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) fail(std::strerror(errno));
  struct Closer {
    int file;
    ~Closer() { close(file); }
  } closer{file};
  struct stat status = {};
  if (fstat(file, &status) != 0) fail(std::strerror(errno));
  if (S_ISDIR(status.st_mode)) fail("it is a folder, a file was expected");
  if (!S_ISREG(status.st_mode)) fail("it is not a regular file");
  const std::size_t size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return {};
  void* const pages = mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0);
  if (pages == MAP_FAILED) fail(std::strerror(errno));
  return {std::shared_ptr<const void>(pages, [size](const void* p) { munmap(const_cast<void*>(p), size); }),
          {static_cast<const std::byte*>(pages), size}};
}

}  // namespace isocast
