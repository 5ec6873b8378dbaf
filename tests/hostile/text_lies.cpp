// Headers of text that claim too much: .raw (its name), .nrrd, .mha, .vti.
#include "lies.h"

namespace isocast::hostile {
namespace {

// Three sizes that are one sample too large, zero, negative, overflowing, no numbers.
const char* const kSizes[] = {"13 9 12",
                              "13 0 11",
                              "-13 -9 11",
                              "1099511627776 1 1",
                              "1073741824 1073741824 1073741824",
                              "4294967296 4294967296 1",
                              "2147483648 4 1",
                              "9223372036854775807 9223372036854775807 9223372036854775807",
                              "18446744073709551617 9 11",
                              "1e3 9 11",
                              "nan inf 11",
                              "13 9",
                              ""};

}  // namespace

void add_text_lies(const std::vector<MadeFile>& whole, std::vector<Lie>& lies) {
  int n = 0;
  const auto add = [&](const std::string& made, const std::string& from, const std::string& to,
                       const std::string& extension) {
    lies.push_back({"claim_" + std::to_string(n++) + extension, replaced(bytes_of(whole, made), from, to)});
  };
  for (const char* const sizes : kSizes) {
    for (const char* const made : {"plain.nrrd", "packed.nrrd"})
      add(made, "sizes: 13 9 11", std::string("sizes: ") + sizes, ".nrrd");
    for (const char* const made : {"plain.mha", "packed.mha"})
      add(made, "DimSize = 13 9 11", std::string("DimSize = ") + sizes, ".mha");
  }
  for (const char* const extent :
       {"0 12 0 8 0 11", "0 1099511627775 0 8 0 10", "0 -1 0 8 0 10",
        "0 1073741823 0 1073741823 0 1073741823", "-9223372036854775808 9223372036854775807 0 8 0 10",
        "0 12 0 8", "nan 12 0 8 0 10"})
    for (const char* const made : {"raw.vti", "zlib.vti", "base64.vti", "inline.vti", "ascii.vti"})
      add(made, "<Piece Extent=\"0 12 0 8 0 10\"", std::string("<Piece Extent=\"") + extent + "\"", ".vti");

  const std::string nrrd = "encoding: ";
  for (const char* const field :
       {"byte skip: 9223372036854775807", "line skip: 9223372036854775807", "spacings: nan 1 1",
        "spacings: 0 1 1", "data file: missing.bin", "data file: .", "data file: /dev/zero",
        "data file: a\tb", "data file: plain%03d.bin"})
    for (const char* const made : {"plain.nrrd", "packed.nrrd"})
      if (!std::string(field).starts_with("spacings"))
        add(made, nrrd, std::string(field) + "\n" + nrrd, ".nrrd");
  const std::string data = "ElementDataFile = LOCAL";
  for (const char* const line :
       {"HeaderSize = 9223372036854775807\nElementDataFile = LOCAL",
        "CompressedDataSize = 9223372036854775807\nCompressedData = True\nElementDataFile = LOCAL",
        "ElementDataFile = missing.bin", "ElementDataFile = .", "ElementDataFile = /dev/zero",
        "ElementDataFile = a\x1b[2Jb", "ElementNumberOfChannels = 4294967297\nElementDataFile = LOCAL"})
    for (const char* const made : {"plain.mha", "packed.mha"}) add(made, data, line, ".mha");
  for (const char* const offset : {"18446744073709551615", "-1", "99999999", ""})
    for (const char* const made : {"raw.vti", "zlib.vti", "base64.vti"})
      add(made, "offset=\"0\"", std::string("offset=\"") + offset + "\"", ".vti");

  for (const char* const dims : {"13x9x12", "1073741824x1073741824x1073741824", "4294967296x4294967296x1",
                                 "0x9x11", "1099511627776x1x1"})
    lies.push_back({std::string("claim_") + dims + "_int16.raw", bytes_of(whole, "made_13x9x11_int16.raw")});
}

}  // namespace isocast::hostile
