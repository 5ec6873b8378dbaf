#include <isocast/apps/viewer/window/stats.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace isocast::viewer {
namespace {

nlohmann::ordered_json summary(std::vector<double> values) {
  std::ranges::sort(values);
  if (values.empty()) return {{"count", 0}};
  return {{"count", values.size()},
          {"least", values.front()},
          {"median", values[values.size() / 2]},
          {"most", values.back()}};
}

}  // namespace

std::string stats_json(const App& app, int threads) {
  using json = nlohmann::ordered_json;
  const LoopCounts& counts = app.loop.counts();
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto pictures = [&](Stage stage) { return counts.pictures[static_cast<std::size_t>(stage)].load(); };
  json stats = {{"method", app.object_news().method},
                {"isa", app.news->isa},
                {"threads", threads},
                {"opengl", app.window.renderer()}};
  const auto [width, height] = app.picture_size();
  stats["size"] = {width, height};
  stats["features"] = app.news->features;
  stats["left_out"] = app.news->left_out;
  stats["pictures"] = {{"preview", pictures(Stage::preview)},
                       {"coarse", pictures(Stage::coarse)},
                       {"full", pictures(Stage::full)},
                       {"final", pictures(Stage::final)},
                       {"cancelled", counts.cancelled.load()}};
  stats["tiles"] = {{"rendered", counts.tiles_rendered.load()},
                    {"cancelled", counts.tiles_cancelled.load()},
                    {"after_cancel", counts.tiles_after_end.load()}};
  stats["scenes"] = counts.scenes.load();
  stats["preview_ms"] = {{"budget", app.request.budget_ms},
                         {"longest", counts.longest_preview_ms.load()},
                         {"late", counts.late_previews.load()}};
  stats["cancel_ms"] = counts.longest_end_ms.load();
  stats["interface"] = {
      {"frames", app.times.frames}, {"longest_ms", app.times.longest_ms}, {"over_16_ms", app.times.slow}};
  stats["latency_ms"] = {{"first", summary(counts.first.all())},
                         {"complete", summary(counts.complete.all())}};
  stats["memory_mb"] = {{"peak", static_cast<double>(usage.ru_maxrss) * 1024e-6},
                        {"volume", 1e-6 * static_cast<double>(app.news->volume_bytes)},
                        {"acceleration", 1e-6 * static_cast<double>(app.news->acceleration_bytes)}};
  return stats.dump(2) + "\n";
}

}  // namespace isocast::viewer
