// What a scene file may hold, as data: the reader's checks and the published JSON Schema come from it.
#pragma once

#include <limits>
#include <string_view>
#include <vector>

namespace isocast {

enum class RuleKind : std::uint8_t { number, integer, boolean, text, list, record, tagged, either };

struct RecordKey;

/// One kind of value.
///
/// lo, hi    of a number, of a list's length, of a text's bytes
/// above     a number has to lie above lo
/// choices   of a text; empty: any
/// parts     either: the alternatives, no two for one type of JSON; list: what each element is; tagged: the
///           records, whose key `type` says which
/// keys      of a record; with `others`, keys of other names hold that
/// name      of rules that are found again in their own parts; empty elsewhere
/// meaning   "three numbers", for messages
struct Rule {
  RuleKind kind;
  std::string_view meaning;
  double lo = -std::numeric_limits<double>::max(), hi = std::numeric_limits<double>::max();
  bool above = false;
  std::vector<std::string_view> choices = {};
  std::vector<const Rule*> parts = {};
  std::vector<RecordKey> keys = {};
  const Rule* others = nullptr;
  std::string_view name = {};
};

struct RecordKey {
  std::string_view name;
  const Rule* rule;
  std::string_view meaning;
  bool required = false;
};

/// The rule of a whole file.
[[nodiscard]] const Rule& scene_rule();

}  // namespace isocast
