// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "page/chart.hpp"
#include "page/heat_map.hpp"
#include "page/page.hpp"
#include "svg_reader.hpp"
#include "test.hpp"

// Whatever a page is made of, it is made: whole, readable, and no larger than a page may be.
namespace fantail::page {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The tags that are closed in another order than they were opened, or never; empty: none.
std::string unbalanced(const std::string& markup) {
  std::vector<std::string> open;
  for (std::size_t at = markup.find('<'); at != std::string::npos; at = markup.find('<', at + 1)) {
    const std::size_t end = markup.find('>', at);
    if (end == std::string::npos) {
      return "a tag without an end";
    }
    const bool closes = markup[at + 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = markup.substr(begin, markup.find_first_of(" />", begin) - begin);
    if (name == "!doctype" || name == "meta" || name == "link" || name == "br" || markup[end - 1] == '/') {
      continue;
    }
    if (!closes) {
      open.push_back(name);
      if (name == "style" || name == "script") {
        at = markup.find("</" + name, end) - 1;
      }
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> after <" + (open.empty() ? "" : open.back()) + ">";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

std::string long_name(const std::string& letter, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    all += letter;
  }
  return all;
}

/// Arabic, Japanese, emoji of one and of several code points, letters on top of each other, markup, and very long ones.
std::vector<std::string> odd_names() {
  return {"",
          "صاروخ الاختبار",
          "試験ロケット第二号",
          "🚀👩‍🚀🇦🇹",
          "Z̷̢͎a̸l̵g̶o̷",
          R"(<script>alert("x")</script> & ' ")",
          "\xff\xfe no UTF-8 \x01",
          long_name("W", 200),
          long_name("ロ", 200),
          long_name("🚀", 200),
          long_name("ع", 200),
          long_name("word ", 40)};
}

struct Data {
  const char* what;
  std::vector<double> x;
  std::vector<double> y;
};

std::vector<Data> odd_data() {
  std::vector<Data> all{{"none", {}, {}},
                        {"one point", {3.0}, {4.0}},
                        {"one missing point", {missing}, {missing}},
                        {"all missing", {0.0, 1.0, 2.0}, {missing, missing, missing}},
                        {"missing times", {missing, 1.0, missing}, {1.0, 2.0, 3.0}},
                        {"infinite", {0.0, 1.0, 2.0, 3.0}, {infinite, 1.0, -infinite, 2.0}},
                        {"the same", {0.0, 1.0, 2.0}, {5.0, 5.0, 5.0}},
                        {"the same time", {1.0, 1.0, 1.0}, {4.0, 5.0, 6.0}},
                        {"huge", {0.0, 1.0, 2.0}, {-1e300, 0.0, 1e300}},
                        {"tiny", {0.0, 1e-300, 2e-300}, {0.0, 1e-300, 2e-300}},
                        {"zero both ways", {0.0, 1.0}, {-0.0, 0.0}}};
  Data flight{"600 s of flight", {}, {}};
  Data many{"a million rows", {}, {}};
  for (int i = 0; i < 600'000; ++i) {
    flight.x.push_back(1e-3 * i);
    flight.y.push_back(std::sin(0.37 * i));
  }
  for (int i = 0; i < 1'000'000; ++i) {
    many.x.push_back(i);
    many.y.push_back(i % 1000 == 7 ? missing : std::cos(0.11 * i));
  }
  all.push_back(std::move(flight));
  all.push_back(std::move(many));
  return all;
}

void expect_whole(const std::string& svg, const std::string& what) {
  EXPECT_TRUE(SvgReader{svg}.finite()) << what;
  EXPECT_EQ(unbalanced(svg), "") << what;
  EXPECT_LT(svg.size(), 700'000U) << what;
  for (const char* const word : {"nan", "inf\"", "inf "}) {
    EXPECT_EQ(svg.find(word), std::string::npos) << what << ": " << svg.substr(0, 2000);
  }
}

TEST(BadInput, EveryMarkOfAChartOfAnyDataIsWhole) {
  for (const Data& data : odd_data()) {
    for (const Mark mark : {Mark::line, Mark::step, Mark::points, Mark::line_and_points}) {
      const std::string drawn = svg({.label = data.what,
                                     .x_label = "time / s",
                                     .y_label = "roll / deg",
                                     .series = {{"roll", Role::measured, mark, data.x, data.y}},
                                     .levels = {{.value = 1.0, .label = "limit"}}});
      expect_whole(drawn, data.what);
    }
  }
}

TEST(BadInput, ABandOfAnyDataIsWhole) {
  for (const Data& data : odd_data()) {
    std::vector<double> high = data.y;
    for (double& value : high) {
      value += 1.0;
    }
    expect_whole(svg({.label = data.what, .areas = {{"band", Role::model, data.x, data.y, high}}}), data.what);
  }
}

TEST(BadInput, LevelsAndStretchesThatAreNoNumbersAreLeftOut) {
  for (const double value : {missing, infinite, -infinite, 1e300}) {
    expect_whole(svg({.label = "chart",
                      .series = {{"roll", Role::measured, Mark::line, {0.0, 1.0}, {0.0, 1.0}}},
                      .shaded_ranges = {{value, value, "coast"}, {0.2, value, "burn", Role::limit}},
                      .levels = {{.value = value, .label = "a"}, {.value = value, .label = "b", .upright = true}}}),
                 std::to_string(value));
  }
}

TEST(BadInput, NamesInAnyScriptLeaveAChartWhole) {
  for (const std::string& name : odd_names()) {
    for (const double width : {full_page, half_page}) {
      expect_whole(svg({.label = name,
                        .x_label = name,
                        .y_label = name,
                        .width = width,
                        .series = {{name, Role::measured, Mark::line, {0.0, 1.0}, {0.0, 1.0}},
                                   {name + " 2", Role::model, Mark::line, {0.0, 1.0}, {1.0, 0.0}}},
                        .shaded_ranges = {{0.2, 0.4, name}},
                        .levels = {{.value = 0.5, .label = name}, {.value = 0.5, .label = name, .upright = true}}}),
                   name);
    }
  }
}

TEST(BadInput, AHeatMapOfAnyDataAndNamesIsWhole) {
  for (const double value : {missing, infinite, -infinite, 0.0, -1.0, 1e300, 1e-300}) {
    for (const bool logarithmic : {true, false}) {
      expect_whole(svg(HeatMap{.label = "map",
                               .x = {0.0, 1.0},
                               .y = {0.0, 1.0},
                               .value = {value, 1.0, value, 2.0},
                               .spots = {{value, value, "spot"}, {0.5, 0.5, "middle"}},
                               .logarithmic = logarithmic}),
                   std::to_string(value));
    }
  }
  for (const std::string& name : odd_names()) {
    expect_whole(svg(HeatMap{.label = name,
                             .x_label = name,
                             .y_label = name,
                             .value_label = name,
                             .x = {0.0},
                             .y = {0.0},
                             .value = {1.0},
                             .spots = {{0.0, 0.0, name}},
                             .width = half_page}),
                 name);
  }
}

TEST(BadInput, APageWithNamesInAnyScriptIsWhole) {
  for (const std::string& name : odd_names()) {
    const std::vector<Cell> row{{name}, {.text = name, .below = name}};
    const std::string made =
        html({.kind = name,
              .title = name,
              .subtitle = name,
              .facts = {{name, name}},
              .verdict_heading = name,
              .verdict = name,
              .findings = {{name, name}},
              .body_html =
                  section(name, paragraph(name) + note(name) +
                                    table(std::vector<Column>{{name}, {name}}, std::vector<std::vector<Cell>>{row}) +
                                    figure(svg(Chart{.label = name}), name)),
              .footer = name,
              .command = name});
    EXPECT_EQ(unbalanced(made), "") << name;
    EXPECT_EQ(made.find("<script>alert"), std::string::npos);
    EXPECT_EQ(made.find('\x01'), std::string::npos);
  }
}

}  // namespace
}  // namespace fantail::page
