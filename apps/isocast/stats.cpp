#include <isocast/apps/isocast/stats.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

namespace isocast {

std::string stats_json(const FrameReport& r, const std::string& version) {
  using json = nlohmann::ordered_json;
  constexpr double kMega = 1e6;
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  std::vector<std::string> features = r.built.features, left_out = r.built.left_out;
  features.insert(features.end(), r.features.used.begin(), r.features.used.end());
  left_out.insert(left_out.end(), r.features.left_out.begin(), r.features.left_out.end());

  (r.counts.passes > 0 ? features : left_out).push_back("primary pass");
  const BuiltObject& object = r.built.objects.front();
  if (object.volume) (r.counts.passes > 0 ? features : left_out).push_back("bit masks");

  json stats = {{"version", version},
                {"isa", r.isa},
                {"precision", r.precision},
                {"threads", r.threads},
                {"method", object.method}};
  if (!object.method_reason.empty()) stats["method_reason"] = object.method_reason;
  stats["iso"] = object.iso;
  stats["size"] = {r.width, r.height};
  stats["spp"] = r.spp;
  stats["features"] = features;
  stats["left_out"] = left_out;
  stats["ms"] = {{"load", r.built.load_ms},
                 {"build", r.built.build_ms},
                 {"render", r.render_ms},
                 {"write", r.write_ms},
                 {"total", r.total_ms}};
  stats["memory_mb"] = {{"peak", static_cast<double>(usage.ru_maxrss) * 1024 / kMega},
                        {"volume", static_cast<double>(r.built.volume_bytes) / kMega},
                        {"acceleration", static_cast<double>(r.built.acceleration_bytes) / kMega}};
  const std::int64_t rays =
      r.counts.primary + r.counts.shadow + r.counts.occlusion + r.counts.reflection + r.counts.transparency;
  stats["rays"] = {{"primary", r.counts.primary},
                   {"shadow", r.counts.shadow},
                   {"occlusion", r.counts.occlusion},
                   {"reflection", r.counts.reflection},
                   {"transparency", r.counts.transparency}};
  stats["mrays_per_s"] = static_cast<double>(rays) / (1000 * r.render_ms);
  stats["counts"] = {{"cells", r.counts.trace.cells},   {"macrocells", r.counts.trace.macrocells},
                     {"solves", r.counts.trace.solves}, {"evaluations", r.counts.trace.evaluations},
                     {"tiles", r.counts.tiles},         {"tiles_culled", r.counts.tiles_culled},
                     {"blended", r.counts.blended}};
  stats["hits"] = r.counts.hits;
  stats["misses"] = r.counts.misses;
  stats["undecided"] = r.counts.undecided;
  return stats.dump(2) + "\n";
}

}  // namespace isocast
