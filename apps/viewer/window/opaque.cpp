#include <imgui.h>
#include <isocast/apps/viewer/window/opaque.h>
// after the standard headers that it leaves out
#include <GL/gl.h>

namespace isocast::viewer {

void begin_opaque(ImDrawList& list) {
  list.AddCallback([](const ImDrawList*, const ImDrawCmd*) { glDisable(GL_BLEND); }, nullptr);
}

void end_opaque(ImDrawList& list) { list.AddCallback(ImDrawCallback_ResetRenderState, nullptr); }

}  // namespace isocast::viewer
