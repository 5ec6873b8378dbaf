// isocast view: a window with the iso-value slider.
#include <fmt/format.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/apps/viewer/viewer_module.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/module.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace isocast::verbs {
namespace {

using viewer::ViewRequest;

void run(ViewRequest& request, const std::string& window) {
  const auto [width, height] = parse_size(window);
  request.window_width = width;
  request.window_height = height;
  request.interrupted = interrupt_token();
  module_table<viewer::ViewerModule>("viewer", "view").run(request);
}

}  // namespace

void add_view(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("view", "A window with the iso-value slider, for volumes and formulas");
  const auto request = std::make_shared<ViewRequest>();
  const auto window = std::make_shared<std::string>("1280x800");
  add_picture_options(verb, &request->words);
  verb->add_option("--window", *window,
                   "WIDTHxHEIGHT of the window; --size is that of the picture (its part of the window)");
  verb->add_option("--budget", request->budget_ms,
                   "Milliseconds that a preview may take while something moves (default 33)")
      ->check(CLI::Range(1.0, 10000.0));
  verb->add_option("--scale", request->scale, "Scale of text and widgets (default: the screen's)")
      ->check(CLI::Range(0.5, 4.0));
  verb->add_option("--script", request->script,
                   "A file of commands, one a line, carried out by mouse and keyboard");
  verb->add_option("--stats", request->stats, "What was done, as JSON, on exit, to a file or - for stdout");
  verb->callback([request, window, verb] {
    request->fixed_size = verb->count("--size") > 0;
    run(*request, *window);
  });
}

}  // namespace isocast::verbs
