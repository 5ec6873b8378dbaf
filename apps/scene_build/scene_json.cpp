#include <fmt/format.h>
#include <isocast/apps/scene_build/scene_json.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>

#include <algorithm>
#include <set>
#include <vector>

namespace isocast {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr int kMostLevels = 64;

[[noreturn]] void fail(const std::string& source, const std::string& text, std::size_t byte,
                       const std::string& what) {
  const std::string_view before = std::string_view(text).substr(0, std::min(byte, text.size()));
  const std::size_t line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1,
                    column = before.size() - (before.rfind('\n') + 1) + 1;
  throw InputError(fmt::format("{}:{}:{}: {}", source, line, column, what));
}

// Builds the value while it watches for depth and for keys that come twice.
class Watch {
 public:
  explicit Watch(const std::string& source) : source_(source) {}
  bool operator()(int depth, SceneJson::parse_event_t event, const SceneJson& value) {
    using Event = SceneJson::parse_event_t;
    if (depth > kMostLevels)
      throw InputError(
          fmt::format("{}: found more than {} levels of lists and records", source_, kMostLevels));
    if (event == Event::object_start) open_.emplace_back();
    if (event == Event::object_end) open_.pop_back();
    if (event == Event::key && !open_.back().insert(value.get<std::string>()).second)
      throw InputError(fmt::format("{}: the key {} is there twice in one record", source_,
                                   in_quotes(value.get<std::string>())));
    return true;
  }

 private:
  const std::string& source_;
  std::vector<std::set<std::string>> open_;
};

}  // namespace

SceneJson parse_scene_json(const std::string& text, const std::string& source) {
  if (text.size() > kMostBytes)
    throw InputError(
        fmt::format("{}: found {} bytes, expected at most {} of a scene", source, text.size(), kMostBytes));
  try {
    return SceneJson::parse(text, Watch(source), true, true);
  } catch (const SceneJson::parse_error& error) {
    fail(source, text, error.byte > 0 ? error.byte - 1 : 0,
         "this is no JSON, expected a value, a key or a separator here");
  } catch (const SceneJson::out_of_range&) {
    throw InputError(fmt::format("{}: found a number beyond the range of double precision", source));
  }
}

}  // namespace isocast
