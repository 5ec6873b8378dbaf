#include <fmt/chrono.h>
#include <fmt/format.h>
#include <isocast/apps/bench/rows.h>
#include <isocast/base/error.h>
#include <isocast/base/output_file.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <system_error>
#include <thread>

namespace isocast::bench {
namespace {

// Calls visit(name, value) for every column, in the order of interface.md.
template <class Visit> void visit_columns(const Row& row, Visit&& visit) {
  visit("suite", row.suite);
  visit("case", row.case_name);
  visit("method", row.method);
  visit("isa", row.isa);
  visit("precision", row.precision);
  visit("setting", row.setting);
  visit("proves", row.proves);
  visit("rays", row.rays);
  visit("seconds", row.seconds);
  visit("seconds_mad", row.seconds_mad);
  visit("mrays_per_s", row.mrays_per_s);
  visit("false_misses", row.false_misses);
  visit("false_hits", row.false_hits);
  visit("wrong_root", row.wrong_root);
  visit("undecided", row.undecided);
  visit("t_error_mean", row.t_error_mean);
  visit("t_error_p50", row.t_error_p50);
  visit("t_error_p99", row.t_error_p99);
  visit("t_error_max", row.t_error_max);
  visit("normal_error_deg_p50", row.normal_error_deg_p50);
  visit("normal_error_deg_max", row.normal_error_deg_max);
  visit("pareto", int(row.pareto));
  visit("undecided_reference", row.undecided_reference);
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}
template <class Number> std::string csv_cell(Number number) { return fmt::format("{}", number); }

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  return "unknown";
}

}  // namespace

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const auto rank =
      static_cast<std::size_t>(std::max(0.0, std::ceil(q * static_cast<double>(values.size())) - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[rank];
}

void ErrorSamples::summarize(Row& row) const {
  if (!t.empty()) row.t_error_mean = std::accumulate(t.begin(), t.end(), 0.0) / static_cast<double>(t.size());
  row.t_error_p50 = quantile(t, 0.5);
  row.t_error_p99 = quantile(t, 0.99);
  row.t_error_max = quantile(t, 1);
  row.normal_error_deg_p50 = quantile(normal_deg, 0.5);
  row.normal_error_deg_max = quantile(normal_deg, 1);
}

Provenance provenance() {
  return {processor_name(), "g++ " __VERSION__, ISOCAST_COMMIT,
          fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))),
          std::thread::hardware_concurrency()};
}

std::string csv_of(const std::vector<Row>& rows) {
  std::string text;
  const auto append = [&text](const std::string& cell) {
    text += (text.empty() || text.back() == '\n' ? "" : ",") + cell;
  };
  visit_columns(Row{}, [&](const char* name, const auto&) { append(name); });
  text += '\n';
  for (const Row& row : rows) {
    visit_columns(row, [&](const char*, const auto& value) { append(csv_cell(value)); });
    text += '\n';
  }
  return text;
}

std::string json_of(const std::vector<Row>& rows, const Provenance& provenance) {
  nlohmann::ordered_json json;
  json["host"] = {{"processor", provenance.processor}, {"cores", provenance.cores}};
  json["compiler"] = provenance.compiler;
  json["commit"] = provenance.commit;
  json["date"] = provenance.date;
  json["rows"] = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json object;
    visit_columns(row, [&](const char* name, const auto& value) { object[name] = value; });
    json["rows"].push_back(std::move(object));
  }
  return json.dump(1) + "\n";
}

void prepare_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError(fmt::format("folder '{}' cannot be made: {}", folder.string(), error.message()));
  OutputFile probe(folder / "results.csv");
}

void write_results(const std::filesystem::path& folder, const std::vector<Row>& rows,
                   const Provenance& provenance) {
  write_text_file(folder / "results.csv", csv_of(rows));
  write_text_file(folder / "results.json", json_of(rows, provenance));
}

}  // namespace isocast::bench
