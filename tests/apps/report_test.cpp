// The report: what is written is escaped and well-formed, and says what the rows say.
#include <apps/well_formed.h>
#include <isocast/apps/bench/condition_plot.h>
#include <isocast/apps/bench/findings.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/markup.h>
#include <isocast/apps/bench/report.h>
#include <isocast/apps/bench/scatter_plot.h>
#include <isocast/apps/bench/small_picture.h>
#include <temporary_folder.h>

#include <algorithm>
#include <catch2/catch.hpp>

using namespace isocast;
using namespace isocast::bench;
using test::is_well_formed;

namespace {

Row row_of(const char* method, const char* isa, const char* precision, double seconds, double error,
           std::int64_t misses = 0) {
  Row row;
  row.suite = "input";
  row.case_name = "a<b & \"c\"";
  row.method = method;
  row.isa = isa;
  row.precision = precision;
  row.proves = "nothing";
  row.rays = 1000;
  row.seconds = seconds;
  row.mrays_per_s = 1;
  row.false_misses = misses;
  row.t_error_mean = row.t_error_p50 = row.t_error_p99 = row.t_error_max = error;
  return row;
}

// fast fails in float, slow never; nothing errs in double.
CaseRows two_methods() {
  CaseRows rows{"input", "a<b & \"c\"", "voxels", {}, {}};
  for (const char* isa : {"scalar", "avx2"}) {
    const double factor = isa == std::string_view("scalar") ? 4 : 1;
    rows.rows.push_back(row_of("fast", isa, "float", 0.001 * factor, 1e-6, 7));
    rows.rows.push_back(row_of("slow", isa, "float", 0.010 * factor, 1e-5));
    rows.rows.push_back(row_of("fast", isa, "double", 0.002 * factor, 0));
    rows.rows.push_back(row_of("slow", isa, "double", 0.020 * factor, 0));
  }
  rows.conditions = {{"fast", "float", {{1, 500, 0, 1e-7, 1e-6}, {4, 500, 7, 1e-7, 0}}},
                     {"slow", "double", {{1, 500, 0, 0, 0}, {4, 500, 0, 0, 0}}}};
  return rows;
}

Report report_of_two_methods() {
  const Provenance provenance{"a processor", "a compiler", "a commit", "a date", 2};
  const CaseRows rows = two_methods();
  return {"bench </title><script>", provenance, {{rows, "what it is", {}}}, {"a note"}};
}

}  // namespace

TEST_CASE("markup: texts and attributes are escaped, what is open is closed") {
  Markup markup;
  markup.open("p", {{"title", "a\"b<c"}}).text("1 < 2 & 3").element("img", {{"src", "'"}}).open("b");
  CHECK(markup.finish() ==
        "<p title=\"a&quot;b&lt;c\">1 &lt; 2 &amp; 3<img src=\"&#39;\"/>\n<b></b>\n</p>\n");
  CHECK(is_well_formed("<p>a<br/></p>"));
  CHECK_FALSE(is_well_formed("<p><b></p></b>"));
  CHECK_FALSE(is_well_formed("<p>a & b</p>"));
}

TEST_CASE("numbers for readers") {
  CHECK(short_number(0) == "0");
  CHECK(short_number(1) == "1");
  CHECK(short_number(9.96) == "10");
  CHECK(short_number(0.0341) == "0.034");
  CHECK(short_number(123.4) == "123");
  CHECK(short_number(9.99e-5) == "1.0·10⁻⁴");
  CHECK(short_time(3.4e-4) == "340 µs");
  CHECK(short_time(0.0123) == "12 ms");
  CHECK(grouped(12) == "12");
  CHECK(grouped(1234567) == "1\u202f234\u202f567");
  CHECK(power_of_ten(-12) == "10⁻¹²");
  CHECK(short_setting("eps-rel=0.0009765625") == "eps-rel=2⁻¹⁰");
  CHECK(short_setting("iterations=3") == "iterations=3");
  const LogAxis axis = log_axis({0, 2e-3, 0.5}, 0, 30);
  CHECK(axis.first == -3);
  CHECK(axis.last == 0);
  CHECK(axis.place(0.1) == Approx(20));
  CHECK(axis.place(100) == 30);
}

TEST_CASE("base64 as in RFC 4648") {
  const char* const expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t n = 0; n <= 6; ++n) CHECK(base64(std::string_view("foobar").substr(0, n)) == expected[n]);
}

TEST_CASE("pictures of errors: verdicts have colours of their own") {
  const std::vector<PixelAnswer> answers = {{Verdict::hit, 0, 0},        {Verdict::hit, 1, 0},
                                            {Verdict::false_miss, 0, 0}, {Verdict::miss, 0, 0},
                                            {Verdict::undecided, 0, 0},  {Verdict::unknown, 0, 0}};
  const SmallPicture picture = picture_of_errors(answers, 3);
  CHECK(picture.height == 2);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < i; ++k) CHECK(picture.pixels[i] != picture.pixels[k]);
  CHECK(picture.pixels[0] == error_color(1e-12));
  CHECK(hex_of({1, 255, 16}) == "#01ff10");
}

TEST_CASE("a case: the fastest row that is right, and the precision to use") {
  CaseRows rows = two_methods();
  CaseFinding finding = examine(rows);
  CHECK(finding.right);
  CHECK(finding.best->method == "fast");
  CHECK(finding.best->precision == "double");
  CHECK(finding.best->isa == "avx2");
  CHECK(finding.proved == nullptr);
  CHECK(finding.precision == "float");  // slow is right in it

  // what proves counts more than what is right by luck
  for (Row& row : rows.rows)
    if (row.method == "fast") row.proves = "both";
  finding = examine(rows);
  CHECK(finding.proved->precision == "double");
  CHECK(finding.precision == "double");
  CHECK_THAT(finding.reason, Catch::Contains("in float fast fails at 7") &&
                                 Catch::Contains("its float is right up to condition 10⁴"));

  // an error beyond the bound is not right
  for (Row& row : rows.rows) row.t_error_max = 1;
  CHECK_FALSE(examine(rows).right);
}

TEST_CASE("findings are sentences with the numbers of the rows") {
  const std::vector<CaseRows> cases = {two_methods()};
  const std::vector<std::string> all = findings(cases);
  REQUIRE(all.size() == 5);
  CHECK_THAT(all[0], Catch::Contains("right at all rays. The fastest of these is fast in 1.") &&
                         !Catch::Contains("prove"));
  CHECK_THAT(all[1], Catch::Contains("fast at 7 of 1\u202f000 rays") && Catch::Contains("None: slow"));
  CHECK_THAT(all[2], Catch::Contains(
                         "Against avx2, scalar takes 4.0 times as long in float and 4.0 times in double"));
  CHECK_THAT(all[3], Catch::Contains("Double takes 2.00 times as long") && Catch::Contains("go from 7 to 0"));
  CHECK_THAT(all[4], Catch::Contains("Float is enough in every case"));
}

TEST_CASE("plots and report are well-formed, escaped and refer to nothing outside") {
  const CaseRows rows = two_methods();
  CHECK(is_well_formed(scatter_plot(rows.rows, rows.unit)));
  CHECK(is_well_formed(condition_plot(rows.conditions, methods_of(rows.rows), rows.unit)));
  CHECK(is_well_formed(condition_plot({}, {}, "voxels")));

  const test::TemporaryFolder folder;
  write_report(folder.path, report_of_two_methods());
  const std::string html = test::bytes_of(folder / "report.html");
  CHECK(is_well_formed(html));
  CHECK_THAT(html, Catch::Contains("bench &lt;/title&gt;&lt;script&gt;") &&
                       Catch::Contains("a&lt;b &amp; &quot;c&quot;") && !Catch::Contains("<script"));
  for (const char* link : {"src=\"http", "href=\"http", "url(", "@import", "<link"})
    CHECK_THAT(html, !Catch::Contains(link));
  CHECK(std::filesystem::exists(folder / "input_a_b____c_.svg"));
  CHECK(std::filesystem::exists(folder / "input_a_b____c__condition.svg"));
}
