// A writer of HTML and SVG whose elements are always closed and whose texts are always escaped.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isocast::bench {

/// & < > " ' as entities, control characters as blanks.
[[nodiscard]] std::string escaped(std::string_view text);

using Attributes = std::vector<std::pair<std::string_view, std::string>>;

/// Appends element by element.
class Markup {
 public:
  Markup& open(std::string_view name, const Attributes& attributes = {});
  /// Ends the innermost open element.
  Markup& close();
  Markup& text(std::string_view text);
  /// A whole element: img and meta without an end, all others with one, as HTML wants it.
  Markup& element(std::string_view name, const Attributes& attributes = {}, std::string_view text = {});
  /// What another writer has finished, or a style sheet, as it is.
  Markup& append(std::string_view finished);
  /// Everything, after closing what is open.
  [[nodiscard]] std::string finish();

 private:
  void start(std::string_view name, const Attributes& attributes);

  std::string written_;
  std::vector<std::string> open_;
};

}  // namespace isocast::bench
