// isocast sample: a formula, a catalogue surface or a test volume on a grid, into a volume file.
#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/base/error.h>
#include <isocast/data_gen/test_volumes.h>
#include <isocast/data_gen/volume_header.h>
#include <isocast/data_gen/write_sparse.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace isocast::verbs {
namespace {

// The words of the command line.
struct Request {
  std::string input, resolution = "128", type = "f32", output, domain, range, time = "0", band, background;
  std::vector<std::string> params, settings;
};

// A field and the box that it is sampled in when none is asked for.
struct Source {
  Field field;
  Domain domain;
};

Source test_volume_source(const TestVolume& volume, const Request& request) {
  if (!request.params.empty())
    throw InputError(fmt::format("found --param for the test volume {}, expected --set", volume.name));
  TestVolumeSettings settings;
  for (const std::string& word : request.settings) {
    const auto [key, value] = parse_key_value(word, "--set");
    settings[key] = parse_number(value, "--set " + key);
  }
  return {test_volume_field(volume, settings), Domain{}};
}

Source find_source(const Request& request) {
  if (const TestVolume* volume = find_test_volume(request.input)) return test_volume_source(*volume, request);
  if (!request.settings.empty())
    throw InputError("found --set without a test volume, expected --param for a formula");
  const Parameters parameters = parse_parameters(request.params, "--param");
  const double time = parse_number(request.time, "--time");
  const FormulaInput input = read_formula({typed_formula(request.input), parameters, {}});
  return {formula_field(input.expression, time), input.domain};
}

WriteOptions write_options(const Request& request) {
  WriteOptions options;
  const std::optional<SampleType> type = sample_type_from_name(request.type);
  if (!type)
    throw InputError(
        fmt::format("--type: found '{}', expected one of u8 i8 u16 i16 u32 i32 f16 f32 f64", request.type));
  options.type = *type;
  if (!request.range.empty()) {
    const std::vector<double> range = parse_numbers(request.range, "--range");
    if (range.size() != 2)
      throw InputError(fmt::format("--range: found '{}', expected LO,HI", request.range));
    options.range = ValueRange{range[0], range[1]};
  }
  return options;
}

SparseWriteOptions sparse_options(const Request& request) {
  if (!request.range.empty())
    throw InputError("found --range for a sparse grid, whose whole numbers are the rounded values");
  SparseWriteOptions options;
  options.type = sparse_type_for(request.output, request.type);
  if (!request.band.empty() && !request.background.empty())
    throw InputError("found --band and --background, expected one of them: a band's background is its width");
  if (!request.band.empty()) options.band = parse_number(request.band, "--band");
  if (!request.background.empty()) options.background = parse_number(request.background, "--background");
  return options;
}

// What was written, up to how to get values back.
void print_start(const Request& request, const SampleGrid& grid, std::string_view type,
                 const WriteReport& report) {
  const std::string range =
      report.values.lo <= report.values.hi
          ? fmt::format("values from {:.6g} to {:.6g}", report.values.lo, report.values.hi)
          : "no finite value";
  fmt::print("wrote {}: {}x{}x{} {}, {}, {} bytes", request.output, grid.dims[0], grid.dims[1], grid.dims[2],
             type, range, report.bytes);
}

// One line.
void print_report(const Request& request, const SampleGrid& grid, SampleType type,
                  const WriteReport& report) {
  print_start(request, grid, name_of(type), report);
  if (!is_float(type)) fmt::print(", value = {} * stored + {}", report.slope, report.intercept);
  if (report.values.nan_count > 0)
    fmt::print(", {} NaN{}", report.values.nan_count,
               is_float(type) ? "" : fmt::format(" stored as {}", integer_range(type).lowest));
  if (request.output.ends_with(".raw"))
    fmt::print(", to be read with --dims {},{},{} --type {}", grid.dims[0], grid.dims[1], grid.dims[2],
               name_of(type));
  fmt::print("\n");
}

void run(const Request& request) {
  // everything that can be refused is refused before the first sample
  const bool sparse = is_sparse_file(request.output);
  if (!sparse && !is_dense_file(request.output))
    throw InputError(fmt::format(
        "found the output {}, expected a name that ends in one of .nrrd .raw .nii .mha .vdb .nvdb",
        request.output));
  if (!sparse && (!request.band.empty() || !request.background.empty()))
    throw InputError("found --band or --background, which only .vdb and .nvdb have");
  const WriteOptions dense_options = sparse ? WriteOptions{} : write_options(request);
  const SparseWriteOptions tree_options = sparse ? sparse_options(request) : SparseWriteOptions{};
  const Source source = find_source(request);
  const SampleGrid grid = {parse_dims(request.resolution, "--resolution"),
                           request.domain.empty() ? source.domain : parse_domain(request.domain, "--domain")};
  if (!sparse)
    return print_report(request, grid, dense_options.type,
                        write_field(source.field, grid, request.output, dense_options));
  const WriteReport report = write_sparse_field(source.field, grid, request.output, tree_options);
  print_start(request, grid, name_of(tree_options.type), report);
  fmt::print("\n");
}

std::string input_help() {
  std::string help = "A formula of x y z w, a .vm tape, @id of the catalogue, or a test volume:";
  for (const TestVolume& volume : test_volumes()) {
    help += fmt::format("\n{} ({}", volume.name, volume.meaning);
    for (const TestVolumeOption& option : volume.options)
      help += fmt::format("; --set {}={} {}", option.name, option.default_value, option.meaning);
    help += ")";
  }
  return help;
}

}  // namespace

void add_sample(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("sample", "Sample a formula into a volume file");
  const auto request = std::make_shared<Request>();
  const auto many = [](CLI::Option* option) { option->allow_extra_args(false)->type_name("NAME=VALUE"); };
  verb->add_option("INPUT", request->input, input_help())->required();
  verb->add_option("--resolution", request->resolution, "Samples along the axes, N or X,Y,Z")
      ->capture_default_str();
  verb->add_option("--type", request->type,
                   "u8 i8 u16 i16 u32 i32 f32 f64, of .raw also f16; of .vdb f32 f64 i32 i64, of .nvdb also "
                   "i16 fp4 fp8 "
                   "fp16 fpn")
      ->capture_default_str();
  verb->add_option("-o,--output", request->output, "OUT.nrrd, OUT.raw, OUT.nii, OUT.mha, OUT.vdb or OUT.nvdb")
      ->required();
  verb->add_option(
      "--domain", request->domain,
      "LO,HI or XLO,XHI,YLO,YHI,ZLO,ZHI of the first and last samples [-1,1, or the catalogue's]");
  many(verb->add_option("--param", request->params, "A parameter of the formula, such as a=2"));
  many(verb->add_option("--set", request->settings, "An option of a test volume, such as seed=1"));
  verb->add_option("--time", request->time, "The time w of a formula")->capture_default_str();
  verb->add_option(
      "--band", request->band,
      "A narrow band of a .vdb or .nvdb: values up to this far from 0 are active [all samples are]");
  verb->add_option("--background", request->background, "The value outside of a .vdb or .nvdb [0]");
  verb->add_option("--range", request->range,
                   "LO,HI: the values that become the lowest and the largest integer [the sampled range]");
  verb->callback([request] { run(*request); });
}

}  // namespace isocast::verbs
