// Functions of a shared library that is opened when it is needed.
#pragma once

#include <dlfcn.h>
#include <fmt/format.h>
#include <isocast/base/error.h>

#include <initializer_list>
#include <string>

namespace isocast {

/// Stays open for good.
class SharedLibrary {
 public:
  /// The first of `names` that can be opened. Throws InputError with `sentence` when none can.
  SharedLibrary(std::initializer_list<const char*> names, const std::string& sentence) {
    for (const char* const name : names)
      if ((handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL))) return;
    throw InputError(sentence);
  }
  /// Throws InputError where it has no such function.
  template <class Function> void find(const char* name, Function*& function) const {
    function = reinterpret_cast<Function*>(dlsym(handle_, name));
    if (!function) throw InputError(fmt::format("the system's CUDA is too old: it has no {}", name));
  }

 private:
  void* handle_ = nullptr;
};

}  // namespace isocast
