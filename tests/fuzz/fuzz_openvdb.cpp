// Fuzzes what the process isocast_openvdb does with a file. OpenVDB itself may fall: that is why it has a
// process.
#include <fcntl.h>
#include <isocast/volume/io/vdb_process.h>

#include "input_file.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  dup2(open("/dev/null", O_WRONLY), 3);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    isocast::vdb_process::read(isocast::fuzz::input_file("input.vdb", data, size), "");
  } catch (const std::exception&) {}
  return 0;
}
