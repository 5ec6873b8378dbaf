// A picture on the graphics card.
#pragma once

#include <cstdint>
#include <vector>

namespace isocast::viewer {

/// Of the window's thread, while the window lives.
class Texture {
 public:
  Texture() = default;
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  /// RGBA of 8 bits, rows from the top.
  void load(int width, int height, const std::vector<std::uint8_t>& rgba);
  /// For ImGui's drawing calls.
  [[nodiscard]] void* handle() const { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(name_)); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Between pixels: their nearest one, or a smooth mixture.
  void set_smooth(bool smooth);

 private:
  unsigned name_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace isocast::viewer
