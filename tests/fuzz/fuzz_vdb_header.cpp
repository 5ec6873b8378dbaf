// Fuzzes what is read of OpenVDB files without OpenVDB.
#include <isocast/volume/io/vdb_header.h>

#include <cstdint>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    (void)isocast::read_vdb_header(std::as_bytes(std::span(data, size)));
  } catch (const std::runtime_error&) {}
  return 0;
}
