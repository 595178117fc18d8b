// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "result/document.hpp"

namespace fantail::result {
namespace {

struct Point {
  double time_s = 0.0;
  double angle_rad = 0.0;
  double height_m = 0.0;
  std::string stop{};
  Spread rate{};
};

constexpr auto point_fields = fields<Point>({
    {"time", "time", units::s, 2, &Point::time_s, "a figure"},
    {"angle", "angle", units::deg, 1, &Point::angle_rad, "a figure", Worse::larger},
    {"height", "height", units::m, 1, &Point::height_m, "a figure", Worse::smaller},
    {"stop", "stop", units::none, 0, &Point::stop, "a figure"},
    {"rate", "rate", units::rad_s, 1, &Point::rate, "a figure"},
});

std::vector<Point> points() {
  return {
      {.time_s = 2.0, .angle_rad = 0.5 * std::numbers::pi, .height_m = 5.0, .stop = "a", .rate = {0.0, 1.0, 2.0, 4.0}},
      {.time_s = 1.0, .angle_rad = std::numbers::pi, .height_m = 7.0, .stop = "a", .rate = {0.0, -1.0, 0.0, 1.0}},
      {.time_s = 2.0,
       .angle_rad = 0.25 * std::numbers::pi,
       .height_m = 3.0,
       .stop = "b",
       .rate = {0.0, 1.0, 2.0, 4.0}}};
}

TEST(Plot, HasTheUnitsOfItsTableAndAtOneXTheWorst) {
  const page::Chart angle = plot(table({}, points(), point_fields), "angle", {.x = "time"}).chart;
  EXPECT_EQ(angle.x_label, "time / s");
  EXPECT_EQ(angle.y_label, "angle / deg");
  ASSERT_EQ(angle.series.size(), 1U);
  EXPECT_EQ(angle.series[0].x, (std::vector{1.0, 2.0}));
  EXPECT_EQ(angle.series[0].y, (std::vector{180.0, 90.0}));
  const page::Chart height = plot(table({}, points(), point_fields), "height", {.x = "time"}).chart;
  EXPECT_EQ(height.series[0].y, (std::vector{7.0, 3.0}));
}

TEST(Plot, HasACurveForEachValueOfAColumn) {
  const page::Chart chart = plot(table({}, points(), point_fields), "angle", {.x = "time", .curves = "stop"}).chart;
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_EQ(chart.series[0].y, (std::vector{180.0, 90.0}));
  EXPECT_EQ(chart.series[1].y, (std::vector{45.0}));
  EXPECT_NE(chart.series[0].role, chart.series[1].role);
}

TEST(Plot, DrawsASpreadAsABandAroundItsMiddle) {
  const page::Chart chart = plot(table({}, points(), point_fields), "rate", {.x = "time"}).chart;
  ASSERT_EQ(chart.areas.size(), 1U);
  EXPECT_EQ(chart.series[0].y, (std::vector{0.0, 2.0}));
}

TEST(Plot, OfAColumnThatTheTableDoesNotHaveIsAnError) {
  EXPECT_THROW((void)plot(table({}, points(), point_fields), "speed", {.x = "time"}), std::logic_error);
}

}  // namespace
}  // namespace fantail::result
