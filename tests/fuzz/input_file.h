// The fuzzer's bytes as a file.
#pragma once

#include <temporary_folder.h>

#include <cstdint>
#include <fstream>

namespace isocast::fuzz {

/// Written anew for each input, below the system's temporary folder.
inline std::filesystem::path input_file(const std::string& name, const std::uint8_t* data, std::size_t size) {
  static const test::TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return folder / name;
}

}  // namespace isocast::fuzz
