#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/volume_options.h>
#include <isocast/volume/io/type_words.h>

#include <CLI/CLI.hpp>

namespace isocast {

void add_read_options(CLI::App& verb, ReadOptions& options) {
  const auto add = [&](const char* name, const char* meaning,
                       const std::function<void(const std::string&)>& read) {
    return verb.add_option_function<std::string>(name, read, meaning)->group("Raw files");
  };
  add("--dims", "X,Y,Z: samples along each axis, x fastest",
      [&options](const std::string& text) { options.dims = parse_dims(text, "--dims"); });
  add("--type", "Sample type: u8 i8 u16 i16 u32 i32 f16 f32 f64",
      [&options](const std::string& text) { options.type = sample_type_from_word(text, "--type"); });
  add("--endian", "Byte order (little)", [&options](const std::string& text) {
    options.big_endian = text == "big";
  })->check(CLI::IsMember({"big", "little"}));
  verb.add_option("--grid", options.grid, "Name of the grid in a .vdb or .nvdb file (the first)");
  verb.add_option("--skip", options.skip, "Bytes before the samples (0)")->group("Raw files");
}

}  // namespace isocast
