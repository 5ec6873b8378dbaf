// The module: opens the window and runs the interface until it is closed.
#include <isocast/apps/viewer/script/script_run.h>
#include <isocast/apps/viewer/viewer_module.h>
#include <isocast/apps/viewer/window/stats.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/module.h>
#include <isocast/base/output_file.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <cstdio>
#include <optional>

namespace isocast::viewer {
namespace {

// What cannot be used on the command line is said before a window opens.
void check_words(const RenderWords& words) {
  const SceneDescription description = describe_all(words);
  if (const auto* volume = std::get_if<VolumeSource>(&description.objects.front().source))
    if (volume->file.string().find('%') == std::string::npos) (void)map_file(volume->file);
  (void)evaluation_of(words);
  (void)parse_size(words.size);
}

void run(const ViewRequest& request) {
  check_words(request.words);
  if (!request.stats.empty() && request.stats != "-") { const OutputFile writable(request.stats); }
  const int threads =
      request.words.threads > 0 ? request.words.threads : oneapi::tbb::info::default_concurrency();
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(threads));
  App app(request);
  std::optional<ScriptRun> script;
  if (!request.script.empty()) script.emplace(app, request.script);
  // a signal may reach the program's watcher or the one of this module's libraries
  const auto interrupted = [&] {
    return request.interrupted.stop_requested() || interrupt_token().stop_requested();
  };
  while (!app.window.wants_to_close()) {
    if (interrupted()) throw Interrupted();
    app.frame();
    app.window.present();
    if (script) script->after_frame();
  }
  if (request.stats.empty()) return;
  const std::string text = stats_json(app, threads);
  if (request.stats == "-") std::fputs(text.c_str(), stdout);
  else write_text_file(request.stats, text);
}

const ViewerModule kModule = {run};

}  // namespace
}  // namespace isocast::viewer

ISO_EXPORT_MODULE(isocast::viewer::kModule)
