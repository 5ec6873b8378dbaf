#include <isocast/apps/bench/pareto.h>
#include <isocast/apps/bench/picture_reference.h>
#include <isocast/apps/bench/picture_run.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/mapped_file.h>

#include <algorithm>

namespace isocast::bench {
namespace {

// What a candidate is timed with.
struct Way {
  const MethodSetting* setting;
  EvaluationSettings evaluation;
};

// Answers nothing: what is left of the time is the harness.
class NoSurface final : public Surface {
 public:
  [[nodiscard]] Box bounds() const override { return {}; }
  void first_hit(const RayStream&, HitStream&, TraceCounts&) const override {}
  void next_hit(const RayStream&, HitStream&, TraceCounts&) const override {}
  void dress(const RayStream&, const HitStream&, const DressWishes&, DressedHits&) const override {}
};

double harness_seconds(const std::vector<RayStream>& rays, std::vector<HitStream>& hits) {
  const NoSurface surface;
  return time_interleaved({[&] { trace(surface, rays, hits); }}, 101, Clock::thread)[0].seconds;
}

double longest_edge(const Box& box) { return std::ranges::max(box.hi - box.lo); }

// A case with its surface, rays and truth, ready for any method.
class Bench {
 public:
  Bench(const PictureCase& picture, const PictureOptions& options)
      : options_(options),
        built_(build_scene(automatic(picture.scene), {})),
        view_(view_of(picture, surface().bounds())) {
    result_.picture = picture;
    rays_ = primary_rays(picture, surface().bounds());
    hits_.resize(rays_.size());
    const bool volume = std::holds_alternative<VolumeSource>(picture.scene.objects.front().source);
    result_.unit_name = volume ? "voxels" : "domain widths";
    result_.iso = built_.objects.front().iso;
    result_.truth = solve_picture(picture.scene, built_, rays_, options.cache);
    use(built_.objects.front().method, {}, {widest_isa(), true});
    trace_picture(surface(), view_, rays_, hits_);
    add_normals(result_.truth, surface(), rays_, hits_);
    result_.right = picture_of_truth(result_.truth, rays_, picture.width);
  }

  PictureResult run() {
    const std::vector<MethodSetting> settings =
        options_.chosen.empty() ? method_settings(result_.picture.scene.objects.front(), options_.settings,
                                                  longest_edge(surface().bounds()))
                                : options_.chosen;
    for (const MethodSetting& setting : settings)
      for (const std::string& precision : options_.precisions)
        if (!setting.swept || precision == options_.precisions.front()) add_rows(setting, precision);
    time_rows();
    mark_pareto(result_.rows);
    result_.harness_seconds = harness_seconds(rays_, hits_);
    check_mapped_files();
    return std::move(result_);
  }

 private:
  static SceneDescription automatic(SceneDescription scene) {
    scene.objects.front().method = "auto";
    scene.objects.front().settings.clear();
    return scene;
  }
  [[nodiscard]] const Surface& surface() const { return *built_.scene.objects.front().surface; }
  void use(const std::string& method, const std::map<std::string, std::string>& set,
           const EvaluationSettings& evaluation) {
    throw_if_interrupted();
    built_.objects.front().change_method(method, set, evaluation);
    clear(hits_);
  }

  [[nodiscard]] EvaluationSettings evaluation(Isa isa, bool precise) const {
    EvaluationSettings evaluation;
    evaluation.isa = isa;
    evaluation.double_precision = precise;
    evaluation.device = options_.device;
    return evaluation;
  }

  // Errors of a setting, and a row to be timed for each instruction set, or two for a device.
  void add_rows(const MethodSetting& setting, const std::string& precision) {
    const bool precise = precision == "double";
    try {
      use(setting.method, setting.set, evaluation(widest_isa(), precise));
    } catch (const InputError&) {
      if (options_.device) return;
      throw;
    }
    trace_picture(surface(), view_, rays_, hits_);
    std::vector<PixelAnswer> answers = judge_picture(result_.truth, surface(), rays_, hits_);
    Row row;
    row.suite = result_.picture.suite;
    row.case_name = result_.picture.name;
    row.method = setting.method;
    row.precision = precision;
    row.setting = setting.text;
    row.proves = setting.proves;
    summarize(answers, row);
    const auto add_row = [&](std::string_view isa, const EvaluationSettings& way) {
      row.isa = isa;
      result_.rows.push_back(row);
      ways_.push_back({&setting, way});
    };
    if (options_.device)
      for (const char* const clock : {"cuda", "cuda-wall"}) add_row(clock, evaluation(widest_isa(), precise));
    else
      for (const Isa isa : options_.isas)
        if (!setting.swept || isa == options_.isas.back()) add_row(name_of(isa), evaluation(isa, precise));
    if (!setting.swept) result_.answers.push_back({setting.method, precision, std::move(answers)});
  }

  void time_rows() {
    const std::vector<std::function<void()>> candidates(
        ways_.size(), [this] { trace_picture(surface(), view_, rays_, hits_); });
    const auto prepare = [this](std::size_t i) {
      use(ways_[i].setting->method, ways_[i].setting->set, ways_[i].evaluation);
    };
    const auto clock = [this](std::size_t i) -> ReadClock {
      if (!options_.device) return clock_of(Clock::thread);
      return result_.rows[i].isa == "cuda" ? options_.device->seconds : clock_of(Clock::wall);
    };
    const std::vector<Timing> timings = time_interleaved(candidates, options_.repetitions, clock, prepare);
    for (std::size_t i = 0; i < timings.size(); ++i) set_timing(result_.rows[i], timings[i]);
  }

  const PictureOptions& options_;
  BuiltScene built_;
  View view_;
  std::vector<RayStream> rays_;
  std::vector<HitStream> hits_;
  std::vector<Way> ways_;
  PictureResult result_;
};

}  // namespace

PictureResult run_picture(const PictureCase& picture, const PictureOptions& options) {
  return Bench(picture, options).run();
}

}  // namespace isocast::bench
