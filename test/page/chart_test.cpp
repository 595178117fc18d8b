// SPDX-License-Identifier: MIT
#include "page/chart.hpp"

#include "svg_reader.hpp"
#include "test.hpp"

namespace fantail::page {
namespace {

constexpr double not_drawn = std::numeric_limits<double>::quiet_NaN();

constexpr double pixel = 0.06;  // coordinates are written to a tenth

Series line(std::vector<double> x, std::vector<double> y) {
  return {"", Role::measured, Mark::line, std::move(x), std::move(y)};
}

Chart with_ranges(Series series) {
  return {.series = {std::move(series)}, .x_range = Range{0.0, 10.0}, .y_range = Range{-1.0, 1.0}};
}

TEST(Chart, APointInTheMiddleOfTheRangesLandsInTheMiddleOfTheFrame) {
  const SvgReader read{svg(with_ranges(line({0.0, 5.0, 10.0}, {-1.0, 0.0, 1.0})))};
  const auto strokes = SvgReader::strokes(read.tags("path", "line measured").at(0));
  ASSERT_EQ(strokes.size(), 1U);
  ASSERT_EQ(strokes[0].size(), 3U);
  for (const auto& [index, part] : {std::pair{0U, 0.0}, {1U, 0.5}, {2U, 1.0}}) {
    EXPECT_NEAR(strokes[0][index].x, read.at(part, part).x, pixel);
    EXPECT_NEAR(strokes[0][index].y, read.at(part, part).y, pixel);
  }
}

// Three decades: one of them is a third of the frame.
TEST(Chart, OnALogarithmicAxisADecadeIsALength) {
  Chart chart{.series = {line({0.1, 1.0, 10.0, 100.0}, {-1.0, 0.0, 1.0, 0.5})},
              .y_range = Range{-1.0, 1.0},
              .x_scale = Scale::logarithmic};
  const SvgReader read{svg(chart)};
  const auto strokes = SvgReader::strokes(read.tags("path", "line measured").at(0));
  ASSERT_EQ(strokes.at(0).size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(strokes[0][i].x, read.at(static_cast<double>(i) / 3.0, 0.0).x, pixel) << i;
  }
  for (const char* tick : {"0.1", "0.2", "0.5", "1", "10", "100"}) {
    EXPECT_TRUE(read.has_text(tick)) << tick;
  }
  EXPECT_FALSE(read.has_text("40")) << "as on an even one";
  EXPECT_TRUE(read.holds(" data-x=\"0.1 100\"") && read.holds(" data-x-scale=\"logarithmic\""));
  chart.series[0].x.front() = 0.0;  // which has no logarithm
  EXPECT_TRUE(SvgReader{svg(chart)}.finite());
  chart.series.clear();
  EXPECT_TRUE(SvgReader{svg(chart)}.has_text("no data"));
}

TEST(Chart, AGapBreaksTheLine) {
  const SvgReader read{svg(with_ranges(line({0, 1, 2, 3, 4, 5, 6}, {0, 1, not_drawn, 1, 0, not_drawn, 0.5})))};
  const auto strokes = SvgReader::strokes(read.tags("path", "line measured").at(0));
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_NEAR(strokes[0].back().x, read.at(0.1, 0.0).x, pixel);
  EXPECT_NEAR(strokes[1].front().x, read.at(0.3, 0.0).x, pixel);
  // The sample that stands alone between gap and end is a dot.
  const auto dots = SvgReader::strokes(read.tags("path", "dots lone").at(0));
  ASSERT_EQ(dots.size(), 1U);
  EXPECT_NEAR(dots[0][0].x, read.at(0.6, 0.75).x, pixel);
  EXPECT_NEAR(dots[0][0].y, read.at(0.6, 0.75).y, pixel);
}

TEST(Chart, AGapOfOneSampleInAHundredThousandStillBreaksTheLine) {
  Series series = line({}, {});
  for (int i = 0; i < 100'000; ++i) {
    series.x.push_back(1e-4 * i);
    series.y.push_back(i == 43'210 ? not_drawn : 0.5);
  }
  const SvgReader read{svg(with_ranges(series))};
  EXPECT_EQ(SvgReader::strokes(read.tags("path", "line measured").at(0)).size(), 2U);
}

TEST(Chart, WhereSamplesAreMissingASampledLineBreaksAndOthersDoNot) {
  Chart chart = with_ranges(line({0, 1, 2, 3, 4, 9.5, 10}, {0, 0.1, 0, 0.1, 0, 0.1, 0}));
  EXPECT_EQ(SvgReader::strokes(SvgReader{svg(chart)}.tags("path", "line measured").at(0)).size(), 1U);
  chart.sampled = true;
  EXPECT_EQ(SvgReader::strokes(SvgReader{svg(chart)}.tags("path", "line measured").at(0)).size(), 2U);
}

TEST(Chart, TheHeightOfARangeIsThatOfWhatIsSeen) {
  const Chart chart{.series = {line({0, 1, 2, 3}, {0, 1, 0, 1000})}, .x_range = Range{0, 2}};
  EXPECT_TRUE(SvgReader{svg(chart)}.has_text("1"));
  EXPECT_FALSE(SvgReader{svg(chart)}.has_text("1000"));
}

TEST(Chart, APeakOfOneSampleIsNeverThinnedAway) {
  Series series = line({}, {});
  for (int i = 0; i < 100'000; ++i) {
    series.x.push_back(1e-4 * i);
    series.y.push_back(i == 77'777 ? 0.9 : i == 12'345 ? -0.9 : 0.1 * std::sin(i));
  }
  const std::string text = svg(with_ranges(series));
  EXPECT_LT(text.size(), 60'000U);
  const SvgReader read{text};
  bool peak = false;
  bool dip = false;
  const auto strokes = SvgReader::strokes(read.tags("path", "line measured").at(0));
  for (const Place p : strokes.at(0)) {
    peak = peak || (std::abs(p.y - read.at(0, 0.95).y) < pixel && std::abs(p.x - read.at(0.77777, 0).x) < pixel);
    dip = dip || (std::abs(p.y - read.at(0, 0.05).y) < pixel && std::abs(p.x - read.at(0.12345, 0).x) < pixel);
  }
  EXPECT_TRUE(peak);
  EXPECT_TRUE(dip);
}

TEST(Chart, AShortRangeOfALongSeriesIsDrawnInFull) {
  Series series = line({}, {});
  for (int i = 0; i < 100'000; ++i) {
    series.x.push_back(0.1 * i);  // 0 to 10 are the first hundred
    series.y.push_back(i % 2 == 0 ? 0.5 : -0.5);
  }
  const SvgReader read{svg(with_ranges(series))};
  EXPECT_EQ(SvgReader::strokes(read.tags("path", "line measured").at(0)).at(0).size(), 102U);
}

TEST(Chart, AStepHoldsItsValueUntilTheNextSample) {
  Series series = line({2.0, 6.0, 8.0}, {0.0, 1.0, -1.0});
  series.mark = Mark::step;
  const SvgReader read{svg(with_ranges(series))};
  const auto stroke = SvgReader::strokes(read.tags("path", "line measured").at(0)).at(0);
  ASSERT_EQ(stroke.size(), 5U);
  EXPECT_NEAR(stroke[1].x, read.at(0.6, 0).x, pixel);
  EXPECT_NEAR(stroke[1].y, read.at(0, 0.5).y, pixel);
  EXPECT_NEAR(stroke[2].x, read.at(0.6, 0).x, pixel);
  EXPECT_NEAR(stroke[2].y, read.at(0, 1.0).y, pixel);
  EXPECT_NEAR(stroke[4].y, read.at(0, 0.0).y, pixel);
}

TEST(Chart, PointsOutsideTheRangesAreNotDrawnIntoTheTexts) {
  Series series = line({5.0, 20.0, 5.0, -3.0, not_drawn}, {0.0, 0.0, 7.0, 0.0, 0.0});
  series.mark = Mark::points;
  const SvgReader read{svg(with_ranges(series))};
  EXPECT_EQ(SvgReader::strokes(read.tags("path", "dots measured").at(0)).size(), 1U);
}

TEST(Chart, AnAreaRunsAlongItsUpperEdgeAndBackAlongTheLower) {
  Chart chart = with_ranges(line({}, {}));
  chart.areas = {{"", Role::model, {0.0, 10.0}, {-1.0, -0.5}, {0.0, 1.0}}};
  const SvgReader read{svg(chart)};
  const auto corners = SvgReader::strokes(read.tags("path", "area model").at(0)).at(0);
  ASSERT_EQ(corners.size(), 4U);
  const double parts[4][2] = {{0.0, 0.5}, {1.0, 1.0}, {1.0, 0.25}, {0.0, 0.0}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(corners[i].x, read.at(parts[i][0], parts[i][1]).x, pixel) << i;
    EXPECT_NEAR(corners[i].y, read.at(parts[i][0], parts[i][1]).y, pixel) << i;
  }
}

TEST(Chart, AStripeIsCutToTheAxis) {
  Chart chart = with_ranges(line({0, 1}, {0, 0}));
  chart.shaded_ranges = {{2.0, 4.0, "thrust"}, {9.0, 1e9, "coast"}, {50.0, 60.0, "later"}};
  const SvgReader read{svg(chart)};
  const auto stripes = read.tags("rect", "stripe");
  ASSERT_EQ(stripes.size(), 2U);
  EXPECT_NEAR(SvgReader::number(stripes[0], "x"), read.at(0.2, 0).x, pixel);
  EXPECT_NEAR(SvgReader::number(stripes[0], "width"), read.at(0.4, 0).x - read.at(0.2, 0).x, 2 * pixel);
  EXPECT_NEAR(SvgReader::number(stripes[1], "width"), read.at(1.0, 0).x - read.at(0.9, 0).x, 2 * pixel);
  EXPECT_TRUE(read.has_text("thrust"));
  EXPECT_FALSE(read.has_text("later"));
}

// A path seen from above that goes west and comes back, all at one height of the picture.
TEST(Chart, ALevelLineThatTurnsBackIsDrawnBothWays) {
  const SvgReader read{svg(with_ranges(line({5, 3, 3, 1, 2, 9}, {0.5, 0.5, 0.5, 0.5, 0.5, 0.5})))};
  const auto strokes = SvgReader::strokes(read.tags("path", "line measured").at(0));
  ASSERT_EQ(strokes.at(0).size(), 3U);
  EXPECT_NEAR(strokes[0][0].x, read.at(0.5, 0).x, pixel);
  EXPECT_NEAR(strokes[0][1].x, read.at(0.1, 0).x, pixel);
  EXPECT_NEAR(strokes[0][2].x, read.at(0.9, 0).x, pixel);
}

TEST(Chart, LevelsStandAtTheirValue) {
  Chart chart = with_ranges(line({0, 1}, {0, 0}));
  chart.levels = {{.value = 0.5, .label = "limit", .role = Role::limit},
                  {.value = 2.5, .label = "burn-out", .upright = true}};
  const SvgReader read{svg(chart)};
  EXPECT_NEAR(SvgReader::strokes(read.tags("path", "level limit").at(0)).at(0).at(0).y, read.at(0, 0.75).y, pixel);
  EXPECT_NEAR(SvgReader::strokes(read.tags("path", "level neutral").at(0)).at(0).at(0).x, read.at(0.25, 0).x, pixel);
  EXPECT_TRUE(read.has_text("limit"));
  EXPECT_TRUE(read.has_text("burn-out"));
}

TEST(Chart, WhatHasNoRangeOfItsOwnShowsAllThatIsDrawn) {
  Chart chart{.series = {line({0, 10}, {0, 1})}};
  chart.levels = {{.value = 40.0, .label = ""}};
  chart.areas = {{"", Role::model, {0, 20}, {-30, -30}, {0, 0}}};
  const SvgReader read{svg(chart)};
  const auto level = SvgReader::strokes(read.tags("path", "level").at(0)).at(0);
  EXPECT_GT(level[0].y, read.at(0, 1).y);
  const auto area = SvgReader::strokes(read.tags("path", "area").at(0));
  for (const Place p : area.at(0)) {
    EXPECT_LT(p.y, read.at(0, 0).y);
  }
  EXPECT_NEAR(SvgReader::strokes(read.tags("path", "line").at(0)).at(0).at(1).x, read.at(0.5, 0).x, pixel);
}

}  // namespace
}  // namespace fantail::page
