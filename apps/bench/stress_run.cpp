#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/pareto.h>
#include <isocast/apps/bench/picture_reference.h>
#include <isocast/apps/bench/stress_run.h>
#include <isocast/apps/bench/timing.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/volume/methods.h>

#include <algorithm>

namespace isocast::bench {
namespace {

// Of the reference for one ray: less than a hundredth of a second.
constexpr std::int64_t kMostOperations = 1 << 15;
constexpr std::uint64_t kSeed = 9;

StressAnswer new_answer(const std::string& name, const Method& method, const char* precision, Isa isa) {
  StressAnswer answer;
  answer.row.suite = "stability";
  answer.row.case_name = name;
  answer.row.method = method.name;
  answer.row.isa = isocast::name_of(isa);
  answer.row.precision = precision;
  answer.row.proves = method.proves;
  return answer;
}

void finish(StressResult& result, const std::vector<Expectation>& expected) {
  std::vector<Row> rows;
  for (const StressAnswer& answer : result.answers) rows.push_back(answer.row);
  mark_pareto(rows);
  for (std::size_t n = 0; n < rows.size(); ++n) result.answers[n].row = rows[n];
  result.outcomes = outcomes_of(expected, result.answers);
}

// No hit, and every miss proved until the surface says otherwise.
void clear_for(const Surface& surface, std::vector<HitStream>& hits) {
  clear(hits);
  if (!surface.proves()) return;
  for (HitStream& stream : hits) std::ranges::fill(stream.certificate, Certificate::proved_miss);
}

template <class T>
void run_family(const std::vector<reference::CellChord>& chords,
                const std::vector<reference::CellReference>& truth, const StressOptions& options,
                StressResult& result) {
  const char* precision = sizeof(T) == sizeof(float) ? "float" : "double";
  const std::vector<CellPacket<T>> packets = packets_of<T>(chords);
  for (const Method& method : volume_methods()) {
    const CellMethodChoice choice = choose_cell_method(method.name, {});
    StressAnswer& answer =
        result.answers.emplace_back(new_answer(result.name, method, precision, options.isa));
    std::vector<RootPacket<T>> roots(packets.size());
    const auto run = [&] {
      const DefaultFloatEnvironment environment;
      solve<T>(cell_kernels(options.isa), choice.method, choice.options, packets, roots);
    };
    const Timing timing = time_interleaved({run}, 1, Clock::thread).front();

    std::vector<Answer> answers(chords.size());
    std::vector<PixelAnswer> judged(chords.size());
    for (std::size_t n = 0; n < chords.size(); ++n) {
      answers[n] = answer_of(roots, n);
      const bool open = answers[n].undecided || (choice.proves() && !answers[n].proved);
      const Judgement judgement = judge(truth[n], answers[n].hit, answers[n].s);
      judged[n] = {open ? Verdict::undecided : judgement.verdict, judgement.error, 0};
    }
    answer.counts = count_proofs(truth, answers, choice.proves());
    summarize(judged, answer.row);
    set_timing(answer.row, timing);
  }
}

}  // namespace

StressResult run_stress(const StressCase& stress, const StressOptions& options) {
  StressResult result{stress.name, stress.stresses, {}, {}};
  BuiltScene built = build_scene(stress.scene, {});
  const Surface& surface = *built.scene.objects.front().surface;
  const std::vector<RayStream> rays = stress.rays(surface.bounds(), options.size);
  std::vector<HitStream> hits(rays.size());
  PictureTruth truth =
      solve_picture(stress.scene, built, rays, options.cache, {.max_operations = kMostOperations});
  truth.normals.resize(truth.rays.size());

  for (const Method& method : applicable_methods(stress.scene.objects.front(), MethodWish::own_answers))
    for (const char* precision : {"float", "double"}) {
      StressAnswer& answer =
          result.answers.emplace_back(new_answer(result.name, method, precision, options.isa));
      const bool precise = answer.row.precision == "double";
      const auto prepare = [&](std::size_t) {
        built.objects.front().change_method(answer.row.method, {}, {options.isa, precise});
        clear_for(surface, hits);
      };
      const Timing timing =
          time_interleaved({[&] { trace(surface, rays, hits); }}, 1, Clock::thread, prepare).front();
      answer.counts = count_proofs(truth, rays, hits);
      summarize(judge_picture(truth, surface, rays, hits), answer.row);
      set_timing(answer.row, timing);
    }
  finish(result, stress.expected);
  return result;
}

StressResult run_stress(const StressFamily& family, const StressOptions& options) {
  const CellFamily& cells = cell_family(family.name);
  StressResult result{"cells/" + std::string(cells.name), std::string(cells.meaning), {}, {}};
  const auto chords = make_cells(cells, kSeed, 0, options.cells, Rounding::to_float);
  const auto truth = reference::solve(chords);
  run_family<float>(chords, truth, options, result);
  run_family<double>(chords, truth, options, result);
  finish(result, family.expected);
  return result;
}

}  // namespace isocast::bench
