#include <fmt/format.h>
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/cells.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/apps/bench/pareto.h>
#include <isocast/apps/bench/timing.h>
#include <isocast/base/progress.h>
#include <isocast/math/transform.h>
#include <isocast/volume/methods.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

namespace isocast::bench {
namespace {

using reference::CellChord;
using reference::CellReference;

constexpr std::uint64_t kSeed = 1;
constexpr std::string_view kQuickFamilies[] = {"random",      "smooth", "double-root",
                                               "close-roots", "thin",   "mc-2-face"};

// A method with some of its options, as --set takes them.
struct Setting {
  std::string method, text;
  CellMethodChoice choice;
};

std::vector<Setting> settings() {
  std::vector<Setting> all;
  const auto add = [&](const std::string& method, const std::string& key, const std::string& value) {
    const std::map<std::string, std::string> set =
        key.empty() ? decltype(set){} : decltype(set){{key, value}};
    all.push_back({method, key.empty() ? "" : key + "=" + value, choose_cell_method(method, set)});
  };
  add("midpoint", "", "");
  add("linear", "", "");
  add("schwarze", "stable", "1");
  add("marmitt", "adaptive", "1");
  add("certified", "", "");
  for (const char* method : {"neubauer", "marmitt"})
    for (const char* iterations : {"1", "2", "3", "5", "10"}) add(method, "iterations", iterations);
  return all;
}

// The cells of a case, and the truth about them.
struct Case {
  std::string_view name;
  std::vector<CellChord> chords;
  std::vector<CellReference> truth;
};

Case make_case(const CellFamily& family, bool quick) {
  const std::uint64_t rays = quick ? 8'192 : family.name.starts_with("mc-") ? kPictureRays : 16'384;
  Case result{family.name, make_cells(family, kSeed, 0, rays, Rounding::to_float), {}};
  result.truth = reference::solve(result.chords);
  return result;
}

Double3 gradient(const CellChord& chord, double s) {
  Double3 g{};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 8; ++i) {
      double weight = i >> axis & 1 ? 1 : -1;
      for (int other = 0; other < 3; ++other) {
        const double p = (1 - s) * chord.entry[other] + s * chord.exit[other];
        if (other != axis) weight *= i >> other & 1 ? p : 1 - p;
      }
      g[axis] += weight * chord.f[i];
    }
  return g;
}

double chord_length(const CellChord& chord) {
  return std::hypot(chord.exit[0] - chord.entry[0], chord.exit[1] - chord.entry[1],
                    chord.exit[2] - chord.entry[2]);
}

// The columns that hold errors. What a method that `proves` does not prove is undecided and nothing else.
template <class T>
void judge_all(const Case& cells, const std::vector<RootPacket<T>>& roots, bool proves, Row& row) {
  ErrorSamples errors;
  row.rays = static_cast<std::int64_t>(cells.chords.size());
  for (std::size_t n = 0; n < cells.chords.size(); ++n) {
    const Answer answer = answer_of(roots, n);
    const bool open = proves && !answer.proved;
    row.undecided += answer.undecided || open;
    if (open) continue;
    const Judgement judgement = judge(cells.truth[n], answer.hit, answer.s);
    row.false_misses += judgement.verdict == Verdict::false_miss;
    row.false_hits += judgement.verdict == Verdict::false_hit;
    row.wrong_root += judgement.verdict == Verdict::wrong_root;
    if (judgement.verdict != Verdict::hit) continue;
    const CellChord& chord = cells.chords[n];
    const double truth = static_cast<double>(first_crossing(cells.truth[n])->s);
    errors.t.push_back(judgement.error * chord_length(chord));
    errors.normal_deg.push_back(angle_in_degrees(gradient(chord, answer.s), gradient(chord, truth)));
  }
  errors.summarize(row);
}

// Everything of one case in one precision; errors once per setting, then a candidate per instruction set to
// be timed.
template <class T>
void add_precision(const Case& cells, const CellSuiteOptions& options, std::vector<Row>& rows,
                   std::vector<std::function<void()>>& candidates) {
  const auto packets = std::make_shared<const std::vector<CellPacket<T>>>(packets_of<T>(cells.chords));
  const auto roots = std::make_shared<std::vector<RootPacket<T>>>(packets->size());
  for (const Setting& setting : settings()) {
    const auto [method, cell_options] = setting.choice;
    Row row;
    row.suite = "cells";
    row.case_name = cells.name;
    row.method = setting.method;
    row.precision = sizeof(T) == sizeof(float) ? "float" : "double";
    row.setting = setting.text;
    row.proves = find_method(volume_methods(), setting.method).proves;
    judge_all(cells, solve(widest_isa(), method, cell_options, *packets), setting.choice.proves(), row);
    for (const Isa isa : options.isas) {
      row.isa = name_of(isa);
      rows.push_back(row);
      candidates.push_back([=, method = method, cell_options = cell_options, &kernels = cell_kernels(isa)] {
        const DefaultFloatEnvironment environment;
        solve<T>(kernels, method, cell_options, *packets, *roots);
      });
    }
  }
}

}  // namespace

std::vector<Row> run_cells(const CellSuiteOptions& options) {
  std::vector<CellFamily> families(cell_families().begin(), cell_families().end());
  if (options.quick) {
    families.clear();
    for (const std::string_view name : kQuickFamilies) families.push_back(cell_family(name));
  }
  const int repetitions = options.quick ? 9 : 7;

  std::vector<Row> rows;
  Progress progress("bench cells", static_cast<std::int64_t>(families.size()));
  for (const CellFamily& family : families) {
    const Case cells = make_case(family, options.quick);
    std::vector<Row> case_rows;
    std::vector<std::function<void()>> candidates;
    add_precision<float>(cells, options, case_rows, candidates);
    add_precision<double>(cells, options, case_rows, candidates);

    const std::vector<Timing> timings = time_interleaved(candidates, repetitions, Clock::thread);
    for (std::size_t i = 0; i < timings.size(); ++i) set_timing(case_rows[i], timings[i]);
    rows.insert(rows.end(), case_rows.begin(), case_rows.end());
    progress.add();
  }
  mark_pareto(rows);
  return rows;
}

std::string cell_summary(const std::vector<Row>& rows) {
  // seconds of a row, or nothing where it was not run
  const auto seconds = [&](std::string_view family, std::string_view precision, std::string_view method,
                           std::string_view setting, Isa isa) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
      return row.case_name == family && row.precision == precision && row.method == method &&
             row.setting == setting && row.isa == name_of(isa);
    });
    return found == rows.end() ? std::nan("") : found->seconds;
  };
  const Isa narrow = isa_from_name(rows.front().isa), wide = isa_from_name(rows.back().isa);
  struct Speed {
    std::string_view method, setting;
  };
  constexpr Speed kAdaptive{"marmitt", "adaptive=1"}, kThree{"marmitt", "iterations=3"},
      kNeubauer{"neubauer", "iterations=3"}, kSchwarze{"schwarze", "stable=1"};

  std::string text = fmt::format(
      "Times ({} to {}, marmitt by its default adaptive=1 | with iterations=3, neubauer with iterations=3)\n",
      name_of(narrow), name_of(wide));
  for (const char* family : {"random", "smooth"})
    for (const char* precision : {"float", "double"}) {
      const auto time = [&](const Speed& speed, Isa isa) {
        return seconds(family, precision, speed.method, speed.setting, isa);
      };
      const auto gain = [&](const Speed& speed) { return time(speed, narrow) / time(speed, wide); };
      text += fmt::format(
          "{:7} {:7} schwarze/marmitt, {}: {:.2f} | {:.2f}   marmitt/neubauer, {}: {:.2f} | {:.2f}\n", family,
          precision, name_of(narrow), time(kSchwarze, narrow) / time(kAdaptive, narrow),
          time(kSchwarze, narrow) / time(kThree, narrow), name_of(narrow),
          time(kAdaptive, narrow) / time(kNeubauer, narrow), time(kThree, narrow) / time(kNeubauer, narrow));
      text += fmt::format(
          "{:15} gain of {} over {}: marmitt {:.2f} | {:.2f}, neubauer {:.2f}, schwarze {:.2f}\n", "",
          name_of(wide), name_of(narrow), gain(kAdaptive), gain(kThree), gain(kNeubauer), gain(kSchwarze));
    }
  return text;
}

}  // namespace isocast::bench
