// SPDX-License-Identifier: MIT

#include "page/chart.hpp"
#include "svg_reader.hpp"
#include "test.hpp"

namespace fantail::page {
namespace {

constexpr double gone = std::numeric_limits<double>::quiet_NaN();

Series named(std::string name, Role role = Role::measured) {
  return {std::move(name), role, Mark::line, {0, 1}, {0, 1}};
}

TEST(ChartLabels, EverythingThatIsTextIsEscaped) {
  const std::string bad = "<script>&\"'";
  const std::string good = "&lt;script&gt;&amp;&quot;&#39;";
  Chart chart{.label = bad, .x_label = bad, .y_label = bad, .series = {named(bad), named("b")}};
  chart.areas = {{bad + "area", Role::model, {0, 1}, {0, 0}, {1, 1}}};
  chart.shaded_ranges = {{0.0, 1.0, bad + "stripe"}};
  chart.levels = {{.value = 0.5, .label = bad + "level"}, {.value = 0.5, .label = bad + "upright", .upright = true}};
  const SvgReader read{svg(chart)};
  EXPECT_FALSE(read.holds("<script"));
  EXPECT_TRUE(read.holds("aria-label=\"" + good + "\""));
  for (const char* end : {"", "area", "stripe", "level", "upright"}) {
    EXPECT_TRUE(read.has_text(good + end)) << end;
  }
}

TEST(ChartLabels, OneNameNeedsNoLegendAndTwoDo) {
  EXPECT_FALSE(SvgReader{svg({.series = {named("alone")}})}.has_text("alone"));
  const SvgReader two{svg({.series = {named("measured"), named("model", Role::model), named("")}})};
  EXPECT_TRUE(two.has_text("measured"));
  EXPECT_TRUE(two.has_text("model"));
  EXPECT_EQ(two.tags("path", "line").size(), 3U + 2U);  // the curves and two pieces in the legend
}

TEST(ChartLabels, ACurveAndItsAreaShareALineOfTheLegend) {
  Chart chart{.series = {named("measured"), named("model", Role::model)}};
  chart.areas = {{"model", Role::model, {0, 1}, {0, 0}, {1, 1}}};
  const SvgReader read{svg(chart)};
  EXPECT_EQ(std::ranges::count(read.texts(), "model"), 1);
  EXPECT_EQ(read.tags("path", "area model").size(), 2U);
}

TEST(ChartLabels, TwoNamesOfOneRoleAreDashedDifferently) {
  const SvgReader read{svg({.series = {named("first"), named("second"), named("third")}})};
  EXPECT_EQ(read.tags("path", "line measured\"").size(), 2U);
  EXPECT_EQ(read.tags("path", "line measured dash1\"").size(), 2U);
  EXPECT_EQ(read.tags("path", "line measured dash2\"").size(), 2U);
}

TEST(ChartLabels, AColouredStripeIsNamedInTheLegendAndAGreyOneAboveItself) {
  Chart chart{.series = {named("measured")}};
  chart.shaded_ranges = {
      {0.0, 0.3, "pad"}, {0.3, 0.5, "control", Role::measured}, {0.6, 0.9, "control", Role::measured}};
  const SvgReader read{svg(chart)};
  EXPECT_EQ(std::ranges::count(read.texts(), "control"), 1);
  EXPECT_EQ(read.tags("path", "stripe measured").size(), 1U);
  EXPECT_EQ(read.tags("rect", "stripe measured").size(), 2U);
  EXPECT_TRUE(read.has_text("pad"));
}

TEST(ChartLabels, WhatWasMeasuredIsBroadUnderAModelUnlessATargetIs) {
  const Series model = named("model", Role::model);
  EXPECT_TRUE(SvgReader{svg({.series = {named("measured"), model}})}.holds("line measured beneath"));
  EXPECT_FALSE(SvgReader{svg({.series = {named("measured"), model, named("true", Role::target)}})}.holds("beneath"));
}

TEST(ChartLabels, TheLineOfAnEventReachesUpToItsLabelAndCrossesNoEarlierOne) {
  Chart chart{.series = {named("")}};
  for (const char* label : {"first event", "second event", "third event"}) {
    chart.levels.push_back(
        {.value = 0.5 + 0.01 * static_cast<double>(chart.levels.size()), .label = label, .upright = true});
  }
  const SvgReader read{svg(chart)};
  const auto lines = read.tags("path", "level neutral");
  const auto labels = read.tags("text", "mark");
  ASSERT_EQ(lines.size(), 6U);  // of each event in the frame, then above it
  ASSERT_EQ(labels.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto line = SvgReader::strokes(lines[3 + i]).at(0);
    EXPECT_LT(line[1].y, SvgReader::number(labels[i], "y"));
    EXPECT_LT(line[0].x, SvgReader::number(labels[i], "x"));
    EXPECT_TRUE(i == 0 || line[1].y > SvgReader::number(labels[i - 1], "y"));
  }
}

TEST(ChartLabels, LegendsThatDoNotFitOneRowTakeMore) {
  Chart chart{.width = 428.0};
  for (int i = 0; i < 12; ++i) {
    chart.series.push_back(named("a run with a long name " + std::to_string(i)));
  }
  const SvgReader read{svg(chart)};
  for (int i = 0; i < 12; ++i) {
    EXPECT_TRUE(read.has_text("a run with a long name " + std::to_string(i)));
  }
  EXPECT_GE(SvgReader::number(read.frame(), "height"), 80.0);
}

TEST(ChartLabels, ANameOfAnyLengthStaysInsideTheDrawing) {
  const SvgReader read{svg({.series = {named(std::string(5000, 'x')), named("b")}})};
  for (const std::string& text : read.texts()) {
    EXPECT_LT(text.size(), 200U);
  }
}

TEST(ChartLabels, ALabelInUtf8IsNeverCutInsideALetter) {
  std::string name;
  for (int i = 0; i < 400; ++i) {
    name += "\u00b0";
  }
  const SvgReader read{svg({.series = {named(name), named("b")}})};
  for (const std::string& text : read.texts()) {
    if (text.starts_with("\u00b0")) {
      EXPECT_EQ(text.find("\u2026") % 2, 0U);
    }
  }
}

TEST(ChartLabels, NegativeTicksHaveMinusSignsNotHyphens) {
  const SvgReader read{svg({.x_range = Range{-5, 5}, .y_range = Range{-10, 10}})};
  EXPECT_TRUE(read.has_text("\u221210"));
  EXPECT_TRUE(read.has_text("\u22124") || read.has_text("\u22122"));
  for (const std::string& text : read.texts()) {
    EXPECT_EQ(text.find('-'), std::string::npos) << text;
  }
}

TEST(ChartLabels, TicksCanStandAtTheCountsOfTheFirstSeries) {
  Chart chart{.series = {{"", Role::model, Mark::line_and_points, {1, 2, 3, 6}, {4, 3, 2, 1}}},
              .equal_x_ticks_at_points = true};
  chart.y_range = Range{100, 200};
  const SvgReader read{svg(chart)};
  for (const char* count : {"1", "2", "3", "6"}) {
    EXPECT_TRUE(read.has_text(count));
  }
  EXPECT_FALSE(read.has_text("4"));
}

TEST(ChartLabels, ADrawingWithoutDataSaysSo) {
  EXPECT_TRUE(SvgReader{svg(Chart{})}.has_text("no data"));
  EXPECT_TRUE(SvgReader{svg({.series = {{"", Role::measured, Mark::line, {0, 1}, {gone, gone}}}})}.has_text("no data"));
  EXPECT_FALSE(SvgReader{svg({.series = {named("")}})}.has_text("no data"));
}

TEST(ChartLabels, TheLegendSaysWhichOfTwoHasNoData) {
  const SvgReader read{svg({.series = {named("here"), {"gone", Role::model, Mark::line, {0}, {gone}}}})};
  EXPECT_TRUE(read.has_text("here"));
  EXPECT_TRUE(read.has_text("gone (no data)"));
}

TEST(ChartLabels, DegenerateDataGiveFiniteDrawings) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::max();
  const std::vector<std::vector<double>> values{{},         {5},       {5, 5, 5},       {gone},        {gone, 1, gone},
                                                {0, 0},     {-0.0},    {endless, 1},    {most, -most}, {1e-300, 2e-300},
                                                {1e9, 1e9}, {1, 2, 3}, {-endless, gone}};
  for (const Mark mark : {Mark::line, Mark::step, Mark::points, Mark::line_and_points, Mark::ring, Mark::cross}) {
    for (const auto& x : values) {
      for (const auto& y : values) {
        Chart chart{.series = {{"a", Role::measured, mark, x, y}, {"b", Role::model, mark, y, x}}};
        chart.areas = {{"c", Role::model, x, y, x}};
        chart.shaded_ranges = {{gone, 1.0, "s"}, {-endless, endless, "t"}};
        chart.levels = {{.value = gone, .label = "l"}, {.value = endless, .label = "u", .upright = true}};
        const SvgReader read{svg(chart)};
        ASSERT_TRUE(read.finite()) << svg(chart);
      }
    }
  }
}

TEST(ChartLabels, ChartsBelowEachOtherCanLineUp) {
  const Chart wide{.series = {{"", Role::measured, Mark::line, {0, 1}, {100'000, 200'000}}}, .least_left = 90.0};
  const Chart slim{.series = {{"", Role::measured, Mark::line, {0, 1}, {0, 1}}}, .least_left = 90.0};
  EXPECT_EQ(SvgReader::number(SvgReader{svg(wide)}.frame(), "x"), 90.0);
  EXPECT_EQ(SvgReader::number(SvgReader{svg(slim)}.frame(), "x"), 90.0);
}

TEST(ChartLabels, AFileOfItsOwnBringsItsStyle) {
  const std::string text = standalone(svg({.series = {named("")}}));
  EXPECT_EQ(text.find("<svg"), 0U);
  EXPECT_NE(text.find("<style>"), std::string::npos);
  EXPECT_NE(text.find("prefers-color-scheme"), std::string::npos);
}

// 120 letters of an em each are twice as wide as the chart.
TEST(ChartLabels, ALongNameOfTheXAxisIsShortenedInAnyScript) {
  for (const char* const letter : {"W", "\u30ed", "\U0001F680"}) {
    std::string name;
    for (int i = 0; i < 120; ++i) {
      name += letter;
    }
    const SvgReader read{svg({.x_label = name, .width = half_page, .series = {named("a")}})};
    const std::vector<std::string> texts = read.texts();
    const auto shown = std::ranges::find_if(texts, [&](const auto& text) { return text.starts_with(letter); });
    ASSERT_NE(shown, texts.end()) << letter;
    EXPECT_TRUE(shown->ends_with("\u2026")) << *shown;
    const auto letters = static_cast<double>((shown->size() - 3) / std::string_view{letter}.size());
    EXPECT_LT(12.0 * letters, half_page) << *shown;
  }
}

}  // namespace
}  // namespace fantail::page
