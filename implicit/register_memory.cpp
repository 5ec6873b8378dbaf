#include <isocast/implicit/register_memory.h>

#include <cstdlib>
#include <memory>
#include <new>

namespace isocast {

void* registers_of(std::size_t bytes) {
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  thread_local std::unique_ptr<void, Free> memory;
  thread_local std::size_t size = 0;
  if (bytes > size) {
    size = (bytes + 63) & ~std::size_t(63);
    memory.reset(std::aligned_alloc(64, size));
    if (!memory) throw std::bad_alloc();
  }
  return memory.get();
}

}  // namespace isocast
