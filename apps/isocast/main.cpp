// isocast: parses the command line, runs one verb, turns failures into one sentence and an exit code.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

// A formula may begin with '-': a word like -x^2+y^2 is no option. A leading blank hides it from the option
// parser and means nothing to the formula parser.
std::string protect_formula(const std::string& word) {
  const bool option = word.size() < 2 || word[0] != '-' || word[1] == '-' || word == "-o" || word == "-h";
  return option ? word : " " + word;
}

// Throws unless the first word is a verb or an option.
void check_verb(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(verb->get_name());
  if (!words.empty() && !words[0].starts_with('-') && std::ranges::find(names, words[0]) == names.end())
    throw isocast::InputError(
        fmt::format("'{}' is no verb; expected one of {}", words[0], fmt::join(names, ", ")));
}

}  // namespace

int main(int argc, char** argv) try {
  isocast::interrupt_token();  // before any thread starts
  CLI::App app{"Ray tracer for surfaces given as f = iso: volumes and formulas"};
  app.name("isocast");
  app.set_version_flag("--version", ISOCAST_VERSION);
  app.require_subcommand(1);
  // verbs, in the order of --help
  isocast::verbs::add_render(app);
  isocast::verbs::add_view(app);
  isocast::verbs::add_methods(app);
  isocast::verbs::add_sample(app);
  isocast::verbs::add_info(app);
  isocast::verbs::add_surfaces(app);
  isocast::verbs::add_schema(app);
  isocast::verbs::add_probe(app);
  isocast::verbs::add_bench(app);
  isocast::verbs::add_compare(app);

  std::vector<std::string> words(argv + 1, argv + argc);
  check_verb(app, words);
  for (std::string& word : words) word = protect_formula(word);
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  try {
    app.parse(reversed);
  } catch (const CLI::RuntimeError& error) {  // the verb has said why
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    fmt::print(stderr, "isocast: {}\nRun 'isocast --help' or 'isocast VERB --help' for the options.\n",
               error.what());
    return 2;
  }
  return 0;
} catch (const isocast::InputError& error) {
  fmt::print(stderr, "isocast: {}\n", error.what());
  return 2;
} catch (const isocast::Interrupted&) {
  fmt::print(stderr, "isocast: interrupted, nothing was written\n");
  return 130;
} catch (const std::exception& error) {
  fmt::print(stderr, "isocast: internal failure: {}\n", error.what());
  return 1;
}
