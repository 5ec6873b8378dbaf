// Optional parts with heavy libraries (image formats, NIfTI, later OpenVDB, Embree) live in shared objects
// that are opened when a scene first needs them.
#pragma once

#include <filesystem>
#include <string>

namespace isocast {

/// Where a file of the folder of modules lies, in the build tree or in an installation; empty if nowhere.
[[nodiscard]] std::filesystem::path find_part(const std::string& file);

/// The entry point of module `name`: what its `extern "C" const void* isocast_module()` returns. Opened once
/// per process. Throws InputError with `needed_for` in the sentence when the module was not built or cannot
/// be loaded.
[[nodiscard]] const void* open_module(const std::string& name, const std::string& needed_for);

/// The same, as the module's table of functions.
template <class Table>
[[nodiscard]] const Table& module_table(const std::string& name, const std::string& needed_for) {
  return *static_cast<const Table*>(open_module(name, needed_for));
}

}  // namespace isocast

/// Ends a module's source: exports `table` as its entry point.
#define ISO_EXPORT_MODULE(table) \
  extern "C" __attribute__((visibility("default"))) const void* isocast_module() { return &(table); }
