#include <isocast/apps/bench/markup.h>

#include <cassert>

namespace isocast::bench {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += static_cast<unsigned char>(c) < ' ' && c != '\n' ? ' ' : c;
    }
  return out;
}

void Markup::start(std::string_view name, const Attributes& attributes) {
  written_.append("<").append(name);
  for (const auto& [key, value] : attributes)
    written_.append(" ").append(key).append("=\"").append(escaped(value)).append("\"");
}

Markup& Markup::open(std::string_view name, const Attributes& attributes) {
  start(name, attributes);
  written_ += '>';
  open_.emplace_back(name);
  return *this;
}

Markup& Markup::close() {
  assert(!open_.empty());
  written_.append("</").append(open_.back()).append(">\n");
  open_.pop_back();
  return *this;
}

Markup& Markup::text(std::string_view text) { return append(escaped(text)); }

Markup& Markup::element(std::string_view name, const Attributes& attributes, std::string_view text) {
  start(name, attributes);
  if (name == "img" || name == "meta") return append("/>\n");
  written_.append(">").append(escaped(text)).append("</").append(name).append(">\n");
  return *this;
}

Markup& Markup::append(std::string_view finished) {
  written_ += finished;
  return *this;
}

std::string Markup::finish() {
  while (!open_.empty()) close();
  return std::move(written_);
}

}  // namespace isocast::bench
