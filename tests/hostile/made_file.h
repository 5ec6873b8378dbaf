// Small whole files of every format, to be damaged.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace isocast::hostile {

/// name    with the extension
/// head    the first bytes, which describe the samples
/// needed  the first bytes, without the last of which no volume is whole
struct MadeFile {
  std::string name, bytes;
  std::size_t head, needed;
};

/// .raw .nrrd .nhdr .nii .nii.gz .mha .mhd .vti, some of them with a file of samples beside them, which is
/// written into `folder` and stays whole.
[[nodiscard]] std::vector<MadeFile> make_dense_files(const std::filesystem::path& folder);

/// .vdb and .nvdb: compressions, halves, codes, tiles, several grids, grids that share a tree.
[[nodiscard]] std::vector<MadeFile> make_sparse_files(const std::filesystem::path& folder);

[[nodiscard]] inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace isocast::hostile
