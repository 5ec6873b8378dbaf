#include <isocast/base/text.h>

namespace isocast {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown(text.substr(0, kLongest));
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  return "'" + shown + (text.size() > kLongest ? "...'" : "'");
}

void add_to_list(std::string& list, std::string_view item) {
  constexpr std::size_t kLongest = 300;
  if (list.ends_with("...")) return;
  if (!list.empty()) list += ", ";
  list += list.size() < kLongest ? item : "...";
}

}  // namespace isocast
