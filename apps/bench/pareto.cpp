#include <isocast/apps/bench/pareto.h>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace isocast::bench {

double pareto_error(const Row& row) {
  const double share = static_cast<double>(row.failures()) / static_cast<double>(row.rays);
  return row.t_error_mean + (row.rays > 0 ? share : 0);
}

void mark_pareto(std::vector<Row>& rows) {
  std::map<std::tuple<std::string, std::string, std::string, std::string>, std::vector<Row*>> groups;
  for (Row& row : rows) groups[{row.suite, row.case_name, row.isa, row.precision}].push_back(&row);

  // in order of time, a row is on the front if its error is below all before it; equal times stand by error
  for (auto& [key, group] : groups) {
    std::sort(group.begin(), group.end(), [](const Row* a, const Row* b) {
      return std::tuple(a->seconds, pareto_error(*a)) < std::tuple(b->seconds, pareto_error(*b));
    });
    double least = std::numeric_limits<double>::infinity(), at = -1;
    for (Row* row : group) {
      const double error = pareto_error(*row);
      row->pareto = error < least || (error == least && row->seconds == at);
      if (error < least) at = row->seconds;
      least = std::min(least, error);
    }
  }
}

}  // namespace isocast::bench
