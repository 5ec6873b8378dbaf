#include <imgui.h>
#include <isocast/apps/viewer/window/theme.h>

#include <filesystem>

namespace isocast::viewer {
namespace {

// Where distributions keep fonts with outlines; else the library's own, of fixed size.
constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                  "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                  "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};

void load_font(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  static const ImWchar letters[] = {0x20, 0xff, 0x2013, 0x2026, 0};
  for (const char* const file : kFonts) {
    std::error_code error;
    if (std::filesystem::exists(file, error) && fonts.AddFontFromFileTTF(file, 15 * scale, nullptr, letters))
      return;
  }
  ImFontConfig config;
  config.SizePixels = 13 * scale;
  fonts.AddFontDefault(&config);
}

}  // namespace

void use_theme(double scale) {
  const auto s = static_cast<float>(scale);
  load_font(s);
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.WindowBorderSize = 0;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.WindowPadding = {10, 8};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {6, 5};
  style.ScrollbarSize = 12;
  style.Colors[ImGuiCol_WindowBg] = {0.12f, 0.12f, 0.13f, 1};
  style.Colors[ImGuiCol_PopupBg] = {0.15f, 0.15f, 0.17f, 1};
  style.ScaleAllSizes(s);
}

}  // namespace isocast::viewer
