// Pictures that hide what lies below them.
#pragma once

struct ImDrawList;

namespace isocast::viewer {

/// What the list draws between these two is not mixed with what is there already, which a software OpenGL
/// does in less time.
void begin_opaque(ImDrawList& list);
void end_opaque(ImDrawList& list);

}  // namespace isocast::viewer
