#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/raw.h>
#include <isocast/volume/io/samples.h>
#include <isocast/volume/io/type_words.h>

#include <algorithm>

namespace isocast {
namespace {

// "256x256x128", nothing for any other word.
std::optional<std::array<std::int64_t, 3>> dims_from_word(std::string_view word) {
  if (std::ranges::count(word, 'x') != 2) return std::nullopt;
  std::string numbers(word);
  std::ranges::replace(numbers, 'x', ' ');
  const auto dims = to_numbers<std::int64_t>(numbers, 3);
  if (!dims) return std::nullopt;
  return std::array{(*dims)[0], (*dims)[1], (*dims)[2]};
}

}  // namespace

Volume read_raw(const std::filesystem::path& path, const ReadOptions& options) {
  // the word after the dimensions is the type, as in the names of public collections
  const std::string stem = path.stem().string();
  const std::vector<std::string_view> words = split_words(stem, "_-. ");
  const auto found =
      std::ranges::find_if(words, [](std::string_view word) { return dims_from_word(word).has_value(); });
  const bool type_follows = found != words.end() && found + 1 != words.end();

  if (!options.dims && found == words.end())
    throw read_error(path,
                     "the dimensions of a .raw file must be given: --dims X,Y,Z, or a name like "
                     "bonsai_256x256x256_uint8.raw");
  if (!options.type && !type_follows)
    throw read_error(path,
                     "the sample type of a .raw file must be given: --type u8, or a name like "
                     "bonsai_256x256x256_uint8.raw");
  Volume volume;
  volume.format = "raw";
  volume.dims = options.dims ? *options.dims : *dims_from_word(*found);
  volume.type =
      options.type ? *options.type : sample_type_from_word(found[1], "the name " + path.filename().string());
  place_samples(volume, map_file(path), options.skip, options.big_endian, path);
  return volume;
}

}  // namespace isocast
