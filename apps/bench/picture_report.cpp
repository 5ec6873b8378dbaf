#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/picture_report.h>
#include <isocast/base/error.h>

namespace isocast::bench {
namespace {

void add_pictures(const PictureResult& result, ReportCase& report) {
  const int width = result.picture.width;
  report.pictures.push_back({"what is right", png_data_url(result.right)});
  for (const PictureAnswers& answers : result.answers) {
    if (answers.precision != result.answers.front().precision) continue;
    Row row;
    summarize(answers.pixels, row);
    const std::string caption = row.failures() == 0 ? fmt::format("{}, {}", answers.method, answers.precision)
                                                    : fmt::format("{}, {}: {} fail", answers.method,
                                                                  answers.precision, grouped(row.failures()));
    report.pictures.push_back({caption, png_data_url(picture_of_errors(answers.pixels, width))});
  }
}

}  // namespace

ReportCase report_of(const PictureResult& result) {
  const PictureCase& picture = result.picture;
  ReportCase report;
  report.rows = {picture.suite, picture.name, result.unit_name, result.rows, {}};
  for (const PictureAnswers& answers : result.answers)
    report.rows.conditions.push_back(
        {answers.method, answers.precision, condition_bins(result.truth, answers.pixels)});
  report.about =
      fmt::format("{} × {} rays, iso {}", picture.width, picture.height, fmt::join(result.iso, ", "));
  if (const std::int64_t unknown = undecided_rays(result.truth); unknown > 0)
    report.about +=
        fmt::format("; {} rays are left out, because the reference does not decide them", grouped(unknown));
  try {
    add_pictures(result, report);
  } catch (const InputError& error) {
    report.pictures.clear();
    report.about += fmt::format("; no pictures: {}", error.what());
  }
  return report;
}

}  // namespace isocast::bench
