#include <imgui.h>
#include <imgui_internal.h>
#include <isocast/apps/viewer/window/landmarks.h>

#include <utility>

namespace isocast::viewer {

void Landmarks::mark(const std::string& name) {
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const ImRect& clip = ImGui::GetCurrentWindow()->ClipRect;
  mark(name, {lo.x, lo.y, hi.x, hi.y, lo.y >= clip.Min.y - 1 && hi.y <= clip.Max.y + 1});
}

void Landmarks::mark(const std::string& name, const Landmark& place) { next_[name] = place; }

void Landmarks::publish(const std::array<int, 2>& window) {
  for (auto& [name, place] : next_) {
    place.x0 += window[0], place.x1 += window[0];
    place.y0 += window[1], place.y1 += window[1];
  }
  const std::lock_guard lock(mutex_);
  shown_ = std::exchange(next_, {});
  ++frame_;
}

std::optional<Landmark> Landmarks::find(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = shown_.find(name);
  return found == shown_.end() ? std::nullopt : std::optional(found->second);
}

std::uint64_t Landmarks::frame() const {
  const std::lock_guard lock(mutex_);
  return frame_;
}

}  // namespace isocast::viewer
