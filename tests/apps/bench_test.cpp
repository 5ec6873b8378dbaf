// The bench around the intersectors: quantiles, Pareto fronts, result files, timing.
#include <isocast/apps/bench/cells.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/apps/bench/pareto.h>
#include <isocast/apps/bench/timing.h>
#include <isocast/base/error.h>
#include <unistd.h>
#include <volume/cell/diagonal_cell.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace isocast;
using namespace isocast::bench;

namespace {

Row row_of(const char* case_name, double seconds, double error, std::int64_t misses = 0) {
  Row row;
  row.suite = "cells";
  row.case_name = case_name;
  row.rays = 100;
  row.seconds = seconds;
  row.t_error_mean = error;
  row.false_misses = misses;
  return row;
}

}  // namespace

TEST_CASE("quantiles take the nearest rank") {
  CHECK(quantile({}, 0.5) == 0);
  CHECK(quantile({3}, 0.99) == 3);
  CHECK(quantile({5, 1, 3, 2, 4}, 0) == 1);
  CHECK(quantile({5, 1, 3, 2, 4}, 0.5) == 3);
  CHECK(quantile({5, 1, 3, 2, 4}, 1) == 5);
}

TEST_CASE("the Pareto front: a wrong answer counts a voxel, cases are apart") {
  std::vector<Row> rows = {row_of("a", 1, 0.1),       row_of("a", 2, 0.2), row_of("a", 3, 0.01),
                           row_of("a", 4, 0.001, 50), row_of("a", 1, 0.1), row_of("b", 9, 0.9)};
  CHECK(pareto_error(rows[3]) == Approx(0.501));
  mark_pareto(rows);
  const bool expected[] = {true, false, true, false, true, true};
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i].pareto == expected[i]);
}

TEST_CASE("verdicts") {
  const auto truth = reference::solve(test::diagonal_cell_with_roots(1, 0.125, 0.5, 0.75));
  const auto empty = reference::solve(test::diagonal_cell(1, 1, 1, 1));
  CHECK(judge(truth, true, 0.2).verdict == Verdict::hit);
  CHECK(judge(truth, true, 0.2).error == Approx(0.075));
  CHECK(judge(truth, true, 0.4).verdict == Verdict::wrong_root);
  CHECK(judge(truth, false, 0.2).verdict == Verdict::false_miss);
  CHECK(judge(empty, true, 0.2).verdict == Verdict::false_hit);
  CHECK(judge(empty, false, 0.2).verdict == Verdict::miss);
}

TEST_CASE("every candidate runs once more than it is measured") {
  int first = 0, second = 0;
  const auto timings = time_interleaved({[&] { ++first; }, [&] { ++second; }}, 5, Clock::wall);
  CHECK(first == 6);
  CHECK(second == 6);
  REQUIRE(timings.size() == 2);
  CHECK(timings[0].seconds >= 0);
}

TEST_CASE("the quick suite has its six cases, every setting, and errors within what is documented") {
  const std::vector<Row> rows = run_cells({.quick = true, .isas = {Isa::scalar, widest_isa()}});
  CHECK(rows.size() == 6 * 15 * 2 * 2);
  std::size_t front = 0;
  for (const Row& row : rows) {
    front += row.pareto;
    CHECK(row.rays == 8192);
    CHECK(row.seconds > 0);
    CHECK(row.t_error_p50 <= row.t_error_max);
    if (row.method == "marmitt" && row.case_name == "random" && row.precision == "double" &&
        row.setting == "adaptive=1") {
      CHECK(row.false_misses + row.false_hits + row.wrong_root == 0);
      CHECK(row.t_error_max < 1e-13);
      CHECK(row.normal_error_deg_max < 1e-9);
    }
    if (row.method == "linear" && row.case_name == "random") CHECK(row.false_misses > 100);
  }
  CHECK(front >= 6 * 2 * 2);
  CHECK_THAT(cell_summary(rows), Catch::Contains("random  float") && Catch::Contains("gain of"));
}

TEST_CASE("result files: the columns of the interface, quoted where needed, with their provenance") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("isocast_bench_test_" + std::to_string(getpid()));
  std::vector<Row> rows = {row_of("a \"b\", c", 0.5, 0.25)};
  prepare_folder(folder / "deep");
  write_results(folder / "deep", rows, provenance());
  std::ifstream csv(folder / "deep" / "results.csv");
  std::string header, line;
  std::getline(csv, header);
  std::getline(csv, line);
  CHECK(header ==
        "suite,case,method,isa,precision,setting,proves,rays,seconds,seconds_mad,mrays_per_s,false_misses,"
        "false_hits,wrong_root,undecided,"
        "t_error_mean,t_error_p50,t_error_p99,t_error_max,normal_error_deg_p50,normal_error_deg_max,pareto,"
        "undecided_reference");
  CHECK(line == "cells,\"a \"\"b\"\", c\",,,,,,100,0.5,0,0,0,0,0,0,0.25,0,0,0,0,0,0,0");
  std::ifstream file(folder / "deep" / "results.json");
  const auto json = nlohmann::json::parse(file);
  CHECK(json.at("rows").size() == 1);
  CHECK(json.at("rows")[0].at("t_error_mean") == 0.25);
  CHECK(json.at("host").at("cores").get<int>() > 0);
  for (const char* key : {"compiler", "commit", "date"}) CHECK_FALSE(json.at(key).get<std::string>().empty());
  // a file in the way of the folder
  CHECK_THROWS_AS(prepare_folder(folder / "deep" / "results.csv"), InputError);
  std::filesystem::remove_all(folder);
}
