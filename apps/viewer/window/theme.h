// Font, sizes and colours of the interface.
#pragma once

namespace isocast::viewer {

/// For the current context; `scale` is 1 at 96 dots per inch.
void use_theme(double scale);

}  // namespace isocast::viewer
