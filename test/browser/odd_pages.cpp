// SPDX-License-Identifier: MIT
#include "browser/odd_pages.hpp"

#include <limits>
#include <string>
#include <vector>

#include "page/chart.hpp"
#include "result/document.hpp"

namespace fantail::test {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::string repeated(const char* letter, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    all += letter;
  }
  return all;
}

std::vector<std::string> names() {
  return {"صاروخ الاختبار الثاني",     "試験ロケット第二号", "🚀👩‍🚀🇦🇹 Z̷̢͎a̸l̵g̶o̷",
          R"(<b>bold</b> & "quoted")", repeated("W", 200),   repeated("ロ", 200),
          repeated("ع", 200),          repeated("🚀", 100)};
}

page::Chart chart_of(const std::string& name, std::vector<double> x, std::vector<double> y) {
  return {.label = "Chart of " + name,
          .x_label = name,
          .y_label = name,
          .series = {{name, page::Role::measured, page::Mark::line, x, y},
                     {"other " + name, page::Role::model, page::Mark::points, x, y}},
          .shaded_ranges = {{0.2, 0.4, name}},
          .levels = {{.value = 0.5, .label = name}}};
}

result::Document document(const std::string& title, const std::string& sentence) {
  return {.kind = "test",
          .title = title,
          .subtitle = title,
          .verdict = {.answer = result::Answer::no, .heading = "Not met", .sentence = sentence},
          .facts = {{"vehicle", "vehicle", title}},
          .made = {.command = "fantail fly " + title, .version = "test", .seed = {}, .changes = {}}};
}

std::string odd_names() {
  result::Document all = document(names()[0], names()[4] + " is not met by " + names()[2] + ".");
  for (const std::string& name : names()) {
    result::Table table{.columns = {{.key = name, .label = name}, {.key = "value", .label = "value"}}};
    table.rows = {{name, 1.0}, {result::Named{name, name}, 2.0}};
    all.sections.push_back({name,
                            {name, result::Picture{chart_of(name, {0.0, 1.0}, {0.0, 1.0}), name}, table,
                             result::Sentences{.all = {name, name}},
                             result::Links{{{.href = "report.html", .text = name, .about = name}}}}});
  }
  return result::html(all);
}

std::string no_data() {
  result::Document all = document("no data", "No run was flown.");
  const std::vector<double> none;
  all.sections = {{"Nothing", {result::Picture{chart_of("nothing", none, none), "Nothing."}}},
                  {"One point", {result::Picture{chart_of("point", {1.0}, {2.0}), "One point."}}},
                  {"Missing", {result::Picture{chart_of("missing", {0.0, missing, 2.0}, {missing, 1.0, missing}), ""}}},
                  {"An empty table", {result::Table{.columns = {{.key = "a", .label = "a"}}}}},
                  {"Values",
                   {result::Table{.columns = {{.key = "a", .label = "a", .absent = "unknown"}},
                                  .rows = {{result::Cell{}}, {missing}}}}}};
  return result::html(all);
}

}  // namespace

std::array<text::NamedFile, 2> odd_pages() { return {{{"odd_names.html", odd_names()}, {"no_data.html", no_data()}}}; }

}  // namespace fantail::test
