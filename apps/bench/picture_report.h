// What a picture case adds to the report.
#pragma once

#include <isocast/apps/bench/picture_run.h>
#include <isocast/apps/bench/report.h>

namespace isocast::bench {

/// The right picture, and one of each method's errors in the first precision that was run. Without
/// OpenImageIO there are none, and `about` says so.
[[nodiscard]] ReportCase report_of(const PictureResult& result);

}  // namespace isocast::bench
