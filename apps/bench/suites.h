// The suites of pictures: a suite is a list of cases.
#pragma once

#include <isocast/apps/bench/picture_case.h>

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace isocast::bench {

/// What cases need: `quick` asks for three small ones, and files that are made lie in `folder`, which exists.
struct SuiteWishes {
  bool quick = false;
  std::filesystem::path folder;
};
struct PictureSuite {
  std::string_view name, meaning;
  std::vector<PictureCase> (*cases)(const SuiteWishes& wishes);
};

[[nodiscard]] std::span<const PictureSuite> picture_suites();
/// Null when there is none of that name.
[[nodiscard]] const PictureSuite* find_suite(std::string_view name);

/// Formulas of the catalogue.
[[nodiscard]] std::vector<PictureCase> surface_cases(const SuiteWishes& wishes);
/// Test volumes, written to folder/volumes/NAME.nrrd.
[[nodiscard]] std::vector<PictureCase> volume_cases(const SuiteWishes& wishes);

}  // namespace isocast::bench
