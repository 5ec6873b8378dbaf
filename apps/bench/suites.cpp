#include <isocast/apps/bench/rows.h>
#include <isocast/apps/bench/suites.h>
#include <isocast/data_gen/test_volumes.h>
#include <isocast/data_gen/write.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/parse.h>

#include <algorithm>

namespace isocast::bench {
namespace {

constexpr int kQuickSize = 48;

// size  pixels along both edges: fewer where rays are slow
struct SurfaceCase {
  std::string_view id;
  int size;
  bool quick = false;
};
constexpr SurfaceCase kSurfaces[] = {
    {"tangle", 128, true}, {"klein_bottle", 128, true}, {"blinn_blob4", 128, true},
    {"steiner", 128},      {"heart_taubin", 128},       {"barth_sextic", 128},
    {"chmutov_14", 96},    {"barth_decic", 96},         {"diamond", 96},
    {"sin_blob", 96},      {"superquadric", 96},        {"icos_csg", 96},
};

// field  a test volume or a formula
struct VolumeCase {
  std::string_view name, field;
  int samples;
  SampleType type;
  double iso;
  bool quick = false;
};
constexpr VolumeCase kVolumes[] = {
    {"sphere", "sqrt(x^2+y^2+z^2)", 64, SampleType::f32, 0.7, true},
    {"gyroid", "gyroid", 64, SampleType::f32, 0, true},
    {"noise", "noise", 64, SampleType::f32, 0.5, true},
    {"vessel", "vessel", 128, SampleType::f32, 0.5},
    {"marschner_lobb", "marschner_lobb", 64, SampleType::f32, 0.5},
    {"gyroid_128", "gyroid", 128, SampleType::f32, 0},
    {"vessel_u8", "vessel", 128, SampleType::u8, 0.5},
};
constexpr int kVolumeSize = 128;

constexpr PictureSuite kSuites[] = {
    {"surfaces", "formulas of the catalogue through every method for formulas", surface_cases},
    {"volumes", "test volumes through every cell intersector", volume_cases},
};

Field field_of(const VolumeCase& volume) {
  if (const TestVolume* test = find_test_volume(volume.field)) return test_volume_field(*test, {});
  return formula_field(parse_expression(volume.field, {}));
}

}  // namespace

std::span<const PictureSuite> picture_suites() { return kSuites; }

const PictureSuite* find_suite(std::string_view name) {
  const auto found = std::ranges::find(kSuites, name, &PictureSuite::name);
  return found == std::end(kSuites) ? nullptr : found;
}

std::vector<PictureCase> surface_cases(const SuiteWishes& wishes) {
  std::vector<PictureCase> cases;
  for (const SurfaceCase& surface : kSurfaces) {
    if (wishes.quick && !surface.quick) continue;
    const CatalogueSurface& record = require_surface(surface.id);
    const int size = wishes.quick ? kQuickSize : surface.size;
    PictureCase& picture =
        cases.emplace_back(PictureCase{"surfaces", std::string(surface.id), {}, size, size});
    picture.scene.objects.front().source = FormulaSource{surface_expression(record), record.domain};
  }
  return cases;
}

std::vector<PictureCase> volume_cases(const SuiteWishes& wishes) {
  const std::filesystem::path folder = wishes.folder / "volumes";
  prepare_folder(folder);
  std::vector<PictureCase> cases;
  for (const VolumeCase& volume : kVolumes) {
    if (wishes.quick && !volume.quick) continue;
    const std::filesystem::path file = folder / (std::string(volume.name) + ".nrrd");
    write_field(field_of(volume), {{volume.samples, volume.samples, volume.samples}, {}}, file,
                {.type = volume.type});
    const int size = wishes.quick ? kQuickSize : kVolumeSize;
    PictureCase& picture =
        cases.emplace_back(PictureCase{"volumes", std::string(volume.name), {}, size, size});
    picture.scene.objects.front().source = VolumeSource{file, {}};
    picture.scene.objects.front().iso = {volume.iso};
  }
  return cases;
}

}  // namespace isocast::bench
