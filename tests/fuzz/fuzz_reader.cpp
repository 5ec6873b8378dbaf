// Fuzzes the reader of EXTENSION and what is made of its volumes.
#include <hostile/open_volume.h>
#include <isocast/base/error.h>

#include "input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    isocast::hostile::open_volume(isocast::fuzz::input_file("input" EXTENSION, data, size));
  } catch (const isocast::InputError&) {}
  return 0;
}
