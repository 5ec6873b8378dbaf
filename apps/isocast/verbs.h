// The verbs of the program: each adds its subcommand with its options and the callback that runs it.
#pragma once

namespace CLI {
class App;
}

namespace isocast {
struct RenderWords;
}

namespace isocast::verbs {

/// What a picture is of and how it looks, the same for the verbs that make pictures; parsing fills `words`,
/// which must live until then.
void add_picture_options(CLI::App* verb, RenderWords* words);

void add_render(CLI::App& app);
void add_view(CLI::App& app);
void add_methods(CLI::App& app);
void add_sample(CLI::App& app);
void add_info(CLI::App& app);
void add_surfaces(CLI::App& app);
void add_schema(CLI::App& app);
void add_probe(CLI::App& app);
void add_bench(CLI::App& app);
void add_compare(CLI::App& app);

}  // namespace isocast::verbs
