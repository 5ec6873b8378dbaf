// The verbs of the program: each adds its subcommand with its options and the callback that runs it.
#pragma once

namespace CLI {
class App;
}

namespace isocast::verbs {

void add_render(CLI::App& app);
void add_methods(CLI::App& app);
void add_sample(CLI::App& app);
void add_info(CLI::App& app);
void add_surfaces(CLI::App& app);
void add_schema(CLI::App& app);
void add_probe(CLI::App& app);
void add_bench(CLI::App& app);
void add_compare(CLI::App& app);

}  // namespace isocast::verbs
