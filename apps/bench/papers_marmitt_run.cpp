#include <fmt/format.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/papers_marmitt_run.h>
#include <isocast/data_gen/test_volumes.h>
#include <isocast/data_gen/write.h>

#include <algorithm>

namespace isocast::bench {

const std::vector<CellSetting>& settings_of_marmitt() {
  static const std::vector<CellSetting> all = {
      cell_setting("midpoint"),
      cell_setting("linear"),
      cell_setting("neubauer", {{"iterations", "3"}}),
      cell_setting("schwarze", {{"stable", "0"}}),
      cell_setting("marmitt", {{"iterations", "3"}, {"stable", "0"}}),
      cell_setting("neubauer", {{"iterations", "10"}}),
      cell_setting("neubauer", {{"face", "1"}, {"iterations", "3"}}),
      cell_setting("marmitt", {{"adaptive", "1"}, {"stable", "0"}}),
  };
  return all;
}

MarmittRun::MarmittRun(const PaperWishes& wishes) : wishes_(wishes), simd_(four_lanes()) {
  for (const CellFamily& family : cell_families())
    if (family.name.starts_with("mc-")) run_family(family);
  for (const ScanOfPaper& scan : kScans) run_scan(scan);
}

void MarmittRun::run(CellCase cells, std::vector<std::string>& group) {
  cells.suite = "papers";
  group.push_back(cells.name);
  CellCaseOptions options{.isas = {Isa::scalar}, .repetitions = wishes_.quick ? 5 : 15};
  if (simd_ != Isa::scalar) options.isas.push_back(simd_);
  rows_.add(run_cell_case(cells, settings_of_marmitt(), options));
  for (const reference::CellReference& truth : cells.truth)
    two_roots_ += std::count_if(truth.roots, truth.roots + truth.root_count,
                                [](const auto& root) { return root.crossing; }) == 2;
}

void MarmittRun::run_family(const CellFamily& family) {
  const std::uint64_t rays = wishes_.quick ? 8192 : kPictureRays;
  CellCase cells{{}, std::string(family.name), make_cells(family, 1, 0, rays, Rounding::to_float), {}};
  cells.truth = reference::solve(cells.chords);
  run(std::move(cells), synthetic_);
}

void MarmittRun::run_scan(const ScanOfPaper& scan) {
  PictureCase picture{"papers", std::string(scan.name), {}, 0, 0};
  std::filesystem::path file = wishes_.data / (picture.name + ".vti");
  if (wishes_.data.empty() || !std::filesystem::exists(file)) {
    picture.name = fmt::format("{} for {}", scan.instead, scan.name);
    file = wishes_.folder / "volumes" / fmt::format("{}_{}.nrrd", scan.instead, scan.samples);
    prepare_folder(file.parent_path());
    write_field(test_volume_field(*find_test_volume(scan.instead), {}),
                {{scan.samples, scan.samples, scan.samples}, {}}, file, {.type = SampleType::u8});
  }
  picture.width = picture.height = wishes_.quick ? 64 : 256;
  picture.scene.objects.front().source = VolumeSource{file, {}};
  const BuiltScene built = build_scene(picture.scene, {});
  CellCase cells = volume_chords(built, primary_rays(picture, built.scene.bounds()), kPictureRays);
  cells.name = picture.name;
  notes_.push_back(fmt::format("{}: iso-value {}, {} chords of {} rays.", picture.name,
                               built.objects.front().iso[0], grouped(std::ssize(cells.chords)),
                               grouped(picture.rays())));
  run(std::move(cells), scans_);
}

const Row& MarmittRun::row(const std::string& name, Tried tried, Isa isa, std::string_view precision) const {
  const CellSetting& setting = settings_of_marmitt()[static_cast<std::size_t>(tried)];
  return *rows_.find(name, setting.method, setting.text, isa, precision);
}

std::vector<double> MarmittRun::ratios(const std::vector<std::string>& names, Tried fast, Isa fast_isa,
                                       Tried slow, Isa slow_isa) const {
  std::vector<double> all;
  for (const std::string& name : names)
    all.push_back(row(name, slow, slow_isa).seconds / row(name, fast, fast_isa).seconds);
  return all;
}

double MarmittRun::sum(std::int64_t Row::*column, Tried tried, std::string_view precision) const {
  double total = 0;
  for (const std::vector<std::string>& group : {synthetic_, scans_})
    for (const std::string& name : group)
      total += static_cast<double>(row(name, tried, Isa::scalar, precision).*column);
  return total;
}

double MarmittRun::failures(Tried tried, std::string_view precision) const {
  return sum(&Row::false_misses, tried, precision) + sum(&Row::false_hits, tried, precision) +
         sum(&Row::wrong_root, tried, precision);
}

}  // namespace isocast::bench
