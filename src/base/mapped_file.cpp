#include <fcntl.h>
#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <utility>

namespace isocast {
namespace {

// What the signal handler knows of a mapping: begin is 0 where there is none, and is written last.
struct Entry {
  std::atomic<std::uintptr_t> begin, size;
  std::atomic<bool> damaged;
  const class Mapping* mapping;  // not for the handler
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

constexpr std::size_t kMostMappings = 1024;
constinit Entry entries[kMostMappings] = {};
constinit std::mutex entries_mutex;  // for writers and readers outside the handler
std::vector<std::filesystem::path> paths_read;
std::once_flag handler_installed;
struct sigaction previous_action;
std::uintptr_t page_size;

// Zeros from the faulting page to the mapping's end, all of which the file has lost.
bool replace_lost_pages(std::uintptr_t address) {
  for (Entry& entry : entries) {
    const std::uintptr_t begin = entry.begin.load(), size = entry.size.load();
    if (begin == 0 || address < begin || address - begin >= size || entry.begin != begin) continue;
    entry.damaged = true;
    const std::uintptr_t first = address / page_size * page_size;
    return mmap(reinterpret_cast<void*>(first), begin + size - first, PROT_READ,
                MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED, -1, 0) != MAP_FAILED;
  }
  return false;
}

void on_bus_error(int signal, siginfo_t* info, void* context) {
  const int error = errno;
  const bool ours =
      info->si_code == BUS_ADRERR && replace_lost_pages(reinterpret_cast<std::uintptr_t>(info->si_addr));
  errno = error;
  if (ours) return;
  if (previous_action.sa_flags & SA_SIGINFO) return previous_action.sa_sigaction(signal, info, context);
  if (previous_action.sa_handler != SIG_DFL && previous_action.sa_handler != SIG_IGN)
    return previous_action.sa_handler(signal);
  sigaction(signal, &previous_action, nullptr);
  raise(signal);
}

void install_handler() {
  page_size = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  struct sigaction action = {};
  action.sa_sigaction = on_bus_error;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  sigaction(SIGBUS, &action, &previous_action);
}

// Pages and the open file behind them, entered above as long as it lives.
class Mapping {
 public:
  explicit Mapping(std::filesystem::path path) : path_(std::move(path)) {}
  Mapping(const Mapping&) = delete;
  ~Mapping() {
    if (entry_) {
      const std::lock_guard lock(entries_mutex);
      entry_->begin = 0;
    }
    if (pages_ != MAP_FAILED) munmap(pages_, size_);
    if (file_ >= 0) close(file_);
  }

  // The file's bytes.
  std::span<const std::byte> map() {
    file_ = open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat status = {};
    if (file_ < 0 || fstat(file_, &status) != 0) fail(std::strerror(errno));
    if (S_ISDIR(status.st_mode)) fail("it is a folder, a file was expected");
    if (!S_ISREG(status.st_mode)) fail("it is not a regular file");
    size_ = static_cast<std::size_t>(status.st_size);
    if (size_ == 0) return {};
    pages_ = mmap(nullptr, size_, PROT_READ, MAP_SHARED, file_, 0);
    if (pages_ == MAP_FAILED) fail(std::strerror(errno));
    enter();
    return {static_cast<const std::byte*>(pages_), size_};
  }

  void check() const {
    struct stat status = {};
    if (entry_->damaged || (fstat(file_, &status) == 0 && static_cast<std::size_t>(status.st_size) < size_))
      throw InputError(
          fmt::format("{} shrank while it was in use, expected its {} bytes to stay", path_.string(), size_));
  }

 private:
  [[noreturn]] void fail(const char* why) const {
    throw InputError(fmt::format("cannot read {}: {}", path_.string(), why));
  }

  void enter() {
    std::call_once(handler_installed, install_handler);
    const std::lock_guard lock(entries_mutex);
    Entry* const entry = std::ranges::find_if(entries, [](const Entry& e) { return e.begin == 0; });
    if (entry == std::end(entries)) fail("too many files are in use at once");
    entry->mapping = this;
    entry->damaged = false;
    entry->size = size_;
    entry->begin = reinterpret_cast<std::uintptr_t>(pages_);
    entry_ = entry;
  }

  std::filesystem::path path_;
  int file_ = -1;
  std::size_t size_ = 0;
  void* pages_ = MAP_FAILED;
  Entry* entry_ = nullptr;
};

}  // namespace

MappedFile map_file(const std::filesystem::path& path) {
  {
    const std::lock_guard lock(entries_mutex);
    if (std::ranges::find(paths_read, path) == paths_read.end()) paths_read.push_back(path);
  }
  const auto mapping = std::make_shared<Mapping>(path);
  const std::span<const std::byte> bytes = mapping->map();
  return {mapping, bytes};
}

std::vector<std::filesystem::path> take_files_read() {
  const std::lock_guard lock(entries_mutex);
  return std::exchange(paths_read, {});
}

void check_mapped_files() {
  const std::lock_guard lock(entries_mutex);
  for (const Entry& entry : entries)
    if (entry.begin != 0) entry.mapping->check();
}

}  // namespace isocast
