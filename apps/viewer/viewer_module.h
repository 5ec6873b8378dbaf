// What the module `viewer` offers to the program.
#pragma once

#include <isocast/apps/isocast/render_words.h>

#include <stop_token>
#include <string>

namespace isocast::viewer {

/// fixed_size  the picture has the size of the words, else that of its part of the window
/// script      a file of commands, or empty; stats: a file or "-" for what was done, or empty
/// scale       of the interface; 0: the screen's
struct ViewRequest {
  RenderWords words;
  bool fixed_size = false;
  std::string script, stats;
  int window_width = 1280, window_height = 800;
  double scale = 0, budget_ms = 33;
  std::stop_token interrupted;  // Ctrl-C, as the program sees it
};

/// Opens the window and returns when it is closed. Throws InputError.
struct ViewerModule {
  void (*run)(const ViewRequest& request);
};

}  // namespace isocast::viewer
