#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/bench/cell_case.h>
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/math/transform.h>

#include <cmath>
#include <functional>
#include <memory>

namespace isocast::bench {
namespace {

using reference::CellChord;

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
void judge_all(const CellCase& cells, const std::vector<RootPacket<T>>& roots, bool proves, Row& row) {
  ErrorSamples errors;
  row.rays = std::ssize(cells.chords);
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

using Candidates = std::vector<std::function<void()>>;

// Errors once per setting, then a candidate per instruction set to be timed.
template <class T>
void add_precision(const CellCase& cells, std::span<const CellSetting> settings, std::span<const Isa> isas,
                   std::vector<Row>& rows, Candidates& candidates) {
  const auto packets = std::make_shared<const std::vector<CellPacket<T>>>(packets_of<T>(cells.chords));
  const auto roots = std::make_shared<std::vector<RootPacket<T>>>(packets->size());
  for (const CellSetting& setting : settings) {
    const auto [method, cell_options] = setting.choice;
    Row row;
    row.suite = cells.suite;
    row.case_name = cells.name;
    row.method = setting.method;
    row.precision = sizeof(T) == sizeof(float) ? "float" : "double";
    row.setting = setting.text;
    row.proves = find_method(volume_methods(), setting.method).proves;
    judge_all(cells, solve(widest_isa(), method, cell_options, *packets), setting.choice.proves(), row);
    for (const Isa isa : isas) {
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

CellSetting cell_setting(const std::string& method, const std::map<std::string, std::string>& set) {
  std::vector<std::string> words;
  for (const auto& [key, value] : set) words.push_back(key + "=" + value);
  return {method, fmt::format("{}", fmt::join(words, " ")), set, choose_cell_method(method, set)};
}

std::vector<Row> run_cell_case(const CellCase& cells, std::span<const CellSetting> settings,
                               const CellCaseOptions& options) {
  std::vector<Row> rows;
  Candidates candidates;
  for (const std::string& precision : options.precisions)
    if (precision == "float") add_precision<float>(cells, settings, options.isas, rows, candidates);
    else add_precision<double>(cells, settings, options.isas, rows, candidates);
  const std::vector<Timing> timings = time_interleaved(candidates, options.repetitions, Clock::thread);
  for (std::size_t i = 0; i < timings.size(); ++i) set_timing(rows[i], timings[i]);
  return rows;
}

}  // namespace isocast::bench
