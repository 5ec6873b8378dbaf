#include <fmt/format.h>
#include <isocast/apps/isocast/stats.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace isocast {

namespace {

using json = nlohmann::ordered_json;

// Every word once, and none that is in the other list.
void keep_first(std::vector<std::string>& words, const std::vector<std::string>& others) {
  std::vector<std::string> kept;
  for (const std::string& word : words)
    if (std::ranges::find(kept, word) == kept.end() && std::ranges::find(others, word) == others.end())
      kept.push_back(word);
  words = std::move(kept);
}

// What was built of every object of a scene.
json objects_of(const BuiltScene& built) {
  json objects = json::array();
  for (const BuiltObject& object : built.objects) {
    json one = {{"name", object.name}, {"method", object.method}, {"iso", object.iso}};
    if (!object.method_reason.empty()) one["method_reason"] = object.method_reason;
    if (object.count > 1) one["surfaces"] = object.count;
    objects.push_back(std::move(one));
  }
  return objects;
}

}  // namespace

std::string stats_json(const FrameReport& r, const std::string& version) {
  constexpr double kMega = 1e6;
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  std::vector<std::string> features = r.built.features, left_out = r.built.left_out;
  features.insert(features.end(), r.features.used.begin(), r.features.used.end());
  left_out.insert(left_out.end(), r.features.left_out.begin(), r.features.left_out.end());

  (r.counts.passes > 0 ? features : left_out).push_back("primary pass");
  const BuiltObject& object = r.built.objects.front();
  MaskUse masks;
  for (const BuiltObject& one : r.built.objects)
    if (one.mask_use) masks += one.mask_use();
  if (masks.bricks > 0) {
    (masks.masks > 0 ? features : left_out).push_back("bit masks");
    left_out.push_back(fmt::format("bit masks of {} of {} bricks", masks.bricks - masks.masks, masks.bricks));
  }
  keep_first(features, {});
  keep_first(left_out, features);

  json stats = {{"version", version},
                {"isa", r.isa},
                {"precision", r.precision},
                {"threads", r.threads},
                {"method", object.method}};
  if (!object.method_reason.empty()) stats["method_reason"] = object.method_reason;
  stats["iso"] = object.iso;
  if (r.built.objects.size() > 1) stats["objects"] = objects_of(r.built);
  stats["size"] = {r.width, r.height};
  stats["spp"] = r.spp;
  stats["features"] = features;
  stats["left_out"] = left_out;
  stats["ms"] = {{"load", r.built.load_ms},
                 {"build", r.built.build_ms},
                 {"render", r.render_ms},
                 {"write", r.write_ms},
                 {"total", r.total_ms}};
  stats["memory_mb"] = {
      {"peak", static_cast<double>(usage.ru_maxrss) * 1024 / kMega},
      {"volume", static_cast<double>(r.built.volume_bytes) / kMega},
      {"acceleration",
       (static_cast<double>(r.built.acceleration_bytes) + static_cast<double>(masks.bytes)) / kMega}};
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
                     {"bricks", masks.bricks},          {"masks", masks.masks},
                     {"blended", r.counts.blended},     {"blended_open", r.counts.blended_open}};
  stats["hits"] = r.counts.hits;
  stats["misses"] = r.counts.misses;
  stats["undecided"] = r.counts.undecided;
  return stats.dump(2) + "\n";
}

}  // namespace isocast
