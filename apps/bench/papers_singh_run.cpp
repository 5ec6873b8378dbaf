#include <fmt/format.h>
#include <isocast/apps/bench/papers_singh_run.h>
#include <isocast/implicit/methods.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace isocast::bench {
namespace {

MethodSetting marching(const char* method, double step, std::map<std::string, double> more = {}) {
  more["step"] = step;
  std::map<std::string, std::string> set;
  for (const auto& [key, value] : more) set[key] = fmt::format("{}", value);
  return paper_setting(formula_methods(), method, set);
}

}  // namespace

MethodSetting sign_test(double step) { return marching("amp-sign", step); }
MethodSetting taylor_test(double step) { return marching("amp-taylor", step); }
MethodSetting octic_test(double tau1) {
  // the paper divides f by its largest coefficient of the highest degree
  constexpr double kLargest = 128;
  const double tau = kLargest * tau1;
  return marching("amp-sign", 0.02, {{"tau1", tau}, {"tau2", 2 * tau}, {"tau3", tau / 2}});
}
MethodSetting fattened_test() { return marching("amp-sign", 0.02, {{"offset", 0.01}}); }
MethodSetting knoll_test() { return paper_setting(formula_methods(), "affine"); }

SinghRun::SinghRun(const PaperWishes& wishes) {
  std::map<std::string_view, std::vector<MethodSetting>> plan;
  for (const SurfaceOfSingh& s : kSinghSurfaces)
    if (!s.id.empty() && (s.quick || !wishes.quick)) plan[s.id] = {sign_test(s.step), taylor_test(s.step)};
  for (const PairOfSingh& s : kSinghPairs) {
    if (wishes.quick && !plan.contains(s.id)) continue;
    std::vector<MethodSetting>& settings = plan[s.id];
    settings.push_back(knoll_test());
    const MethodSetting sign = sign_test(s.step);
    if (std::ranges::find(settings, sign.text, &MethodSetting::text) == settings.end())
      settings.push_back(sign);
  }
  const auto add = [&plan](std::string_view id, const MethodSetting& setting) {
    if (const auto found = plan.find(id); found != plan.end()) found->second.push_back(setting);
  };
  for (const PointOfSingh& p : kDecicSteps)
    if (p.value > kDecicSteps[0].value) add("barth_decic", sign_test(p.value));
  for (const PointOfSingh& p : kOcticTaus) add("chmutov_8", octic_test(p.value));
  for (const std::string_view id : kSmallStepSurfaces) add(id, sign_test(kWideStep));
  add("steiner_singh", fattened_test());
  for (const auto& [id, settings] : plan) run(wishes, id, settings);
}

void SinghRun::run(const PaperWishes& wishes, std::string_view id,
                   const std::vector<MethodSetting>& settings) {
  PictureOptions options;
  options.chosen = settings;
  options.isas = {Isa::scalar};
  if (wide_ != Isa::scalar) options.isas.push_back(wide_);
  options.precisions = {"float"};
  options.repetitions = wishes.quick ? Repetitions(3) : Repetitions(3, 9, 1.5);
  options.cache = wishes.cache;
  rows_.add(run_picture(paper_surface(id, wishes.quick ? 32 : 96), options).rows);
}

double SinghRun::frames(std::string_view id, const MethodSetting& s, Isa isa, double size) const {
  const Row* const found = rows_.find(id, s.method, s.text, isa);
  return found ? 1e6 * found->mrays_per_s / (size * size) : std::nan("");
}

}  // namespace isocast::bench
