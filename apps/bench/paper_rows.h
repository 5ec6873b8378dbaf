// What the tables of papers look up in their rows, and how their methods are set.
#pragma once

#include <isocast/apps/bench/paper.h>
#include <isocast/apps/bench/picture_run.h>
#include <isocast/ray/method.h>

#include <span>

namespace isocast::bench {

/// A method of the table as its paper ran it: of the options that are ours, those that it has are off, bounds
/// are rounded to the nearest, and the frustum's signs prove nothing. Throws InputError for methods and options that there are not.
[[nodiscard]] MethodSetting paper_setting(std::span<const Method> table, const std::string& method,
                                          const std::map<std::string, std::string>& set = {});

/// Rows of many cases, to be asked by name.
class PaperRows {
 public:
  void add(const std::vector<Row>& rows) { rows_.insert(rows_.end(), rows.begin(), rows.end()); }
  [[nodiscard]] const std::vector<Row>& all() const { return rows_; }
  [[nodiscard]] std::vector<Row> take() { return std::move(rows_); }

  /// Null where it was not run.
  [[nodiscard]] const Row* find(std::string_view case_name, std::string_view method, std::string_view setting,
                                Isa isa, std::string_view precision = "float") const;
  /// NaN where it was not run.
  [[nodiscard]] double seconds(std::string_view case_name, std::string_view method, std::string_view setting,
                               Isa isa) const;

 private:
  std::vector<Row> rows_;
};

/// Of all rays, those that were not answered rightly, where the reference knows.
[[nodiscard]] inline double failing_share(const Row& row) {
  return static_cast<double>(row.failures()) / static_cast<double>(row.rays);
}

/// The catalogue's surface with the default camera, size x size rays.
[[nodiscard]] PictureCase paper_surface(std::string_view id, int size);

/// Two digits, or a dash for NaN.
[[nodiscard]] std::string table_number(double value);

/// The instruction set of 4 floats, as the papers' processors had it, or the narrowest there is.
[[nodiscard]] Isa four_lanes();

}  // namespace isocast::bench
