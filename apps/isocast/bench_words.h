// What the command line of bench means.
#pragma once

#include <isocast/apps/bench/picture_run.h>
#include <isocast/apps/isocast/render_words.h>

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isocast::verbs {

/// The command line as it was typed. Of `scene`, `input` may be a suite, or nothing for all suites of
/// pictures; `method` may be several, NAME[,NAME...], or auto for all; `isa` may be empty for all, and `size`
/// for 128x128. `cache` is a folder or none, `data` a folder or empty.
struct BenchWords {
  RenderWords scene;
  std::string folder, precision, cache, data;
  bool quick = false;

  BenchWords() { scene.isa = scene.size = ""; }
};

/// Throws InputError for options of an INPUT that were given with a suite, and options that a suite
/// does not have.
void check(const BenchWords& words);

/// Whether what was named is a suite of pictures, all of them, or an INPUT.
[[nodiscard]] bool has_pictures(const BenchWords& words);

/// Empty for none.
[[nodiscard]] std::filesystem::path cache_of(const BenchWords& words);

/// All of these throw InputError for words that cannot be used.
[[nodiscard]] std::vector<Isa> isas_of(const BenchWords& words);
[[nodiscard]] bench::PictureOptions picture_options(const BenchWords& words);

/// The suite's, of every suite where none is named, or the INPUT as one case; files are made in the prepared
/// folder.
[[nodiscard]] std::vector<bench::PictureCase> picture_cases(const BenchWords& words);

}  // namespace isocast::verbs
