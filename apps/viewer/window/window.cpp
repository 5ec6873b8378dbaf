#include <isocast/apps/viewer/window/window.h>
// its headers define what OpenGL's own need
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <isocast/apps/viewer/window/theme.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <utility>

namespace isocast::viewer {
namespace {

constexpr const char* kInstead = "pictures can be made with 'isocast render'";

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason is given";
}

}  // namespace

Window::Window(const WindowWishes& wishes) {
  if (!glfwInit())
    throw InputError(
        fmt::format("view: found no display to open a window on ({}); {}", last_error(), kInstead));
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  window_ = glfwCreateWindow(wishes.width, wishes.height, "isocast", nullptr, nullptr);
  if (!window_) {
    const std::string reason = last_error();
    glfwTerminate();
    throw InputError(
        fmt::format("view: found no OpenGL 3.3, which the window needs ({}); {}", reason, kInstead));
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  if (const GLubyte* name = glGetString(GL_RENDERER)) renderer_ = reinterpret_cast<const char*>(name);
  glfwSetWindowUserPointer(window_, this);
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    auto& dropped = static_cast<Window*>(glfwGetWindowUserPointer(window))->dropped_;
    dropped.insert(dropped.end(), paths, paths + count);
  });
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  scale_ = std::clamp(wishes.scale > 0 ? wishes.scale : double(x), 0.5, 4.0);

  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  use_theme(scale_);
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init("#version 330");
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::atomic<bool> Window::woken_ = false;

bool Window::begin_frame(double wait_seconds) {
  const double end = glfwGetTime() + wait_seconds;
  glfwWaitEventsTimeout(wait_seconds);
  const bool event = !woken_.exchange(false) && glfwGetTime() < end;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  return event;
}

void Window::draw() {
  ImGui::Render();
  const auto [width, height] = size();
  glViewport(0, 0, width, height);
  glClearColor(0.12f, 0.12f, 0.13f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::present() { glfwSwapBuffers(window_); }
bool Window::wants_to_close() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::wake() {
  woken_ = true;
  glfwPostEmptyEvent();
}

std::array<int, 2> Window::size() const {
  std::array<int, 2> size;
  glfwGetFramebufferSize(window_, size.data(), &size[1]);
  return size;
}

std::array<int, 2> Window::position() const {
  std::array<int, 2> place;
  glfwGetWindowPos(window_, place.data(), &place[1]);
  return place;
}

void Window::toggle_full_screen() {
  auto& [x, y, width, height] = windowed_;
  if (glfwGetWindowMonitor(window_)) return glfwSetWindowMonitor(window_, nullptr, x, y, width, height, 0);
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (!monitor) return;
  glfwGetWindowPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

std::vector<std::uint8_t> Window::pixels() const {
  const auto [width, height] = size();
  const auto row = static_cast<std::size_t>(width) * 3;
  std::vector<std::uint8_t> rgb(row * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
  for (int y = 0; y < height / 2; ++y)
    std::swap_ranges(&rgb[row * static_cast<std::size_t>(y)], &rgb[row * static_cast<std::size_t>(y)] + row,
                     &rgb[row * static_cast<std::size_t>(height - 1 - y)]);
  return rgb;
}

std::vector<std::string> Window::take_dropped() { return std::exchange(dropped_, {}); }

}  // namespace isocast::viewer
