// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "airframe/summary.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"

namespace fantail::airframe {
namespace {

sim::Vehicle shipped_vehicle(const std::string& name) {
  return input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, name).string()));
}

page::Chart margin_chart(const sim::Vehicle& rocket) {
  return std::get<result::Picture>(margin_over_time(rocket, summarize(rocket)).at(0)).chart;
}

// 120 N for a second and 40 N for another: after the first three quarters of the propellant are gone. The first moment
// of what is left then follows by hand.
TEST(MarginOverTime, IsThatOfTheMassThatIsLeft) {
  sim::Vehicle rocket = shipped_vehicle("tasha3_launch2");
  rocket.motor =
      sim::ThrustCurve{{{0.0, 120.0}, {1.0, 120.0}, {1.0 + 1e-9, 40.0}, {2.0, 40.0}, {2.0 + 1e-9, 0.0}}, 0.4};
  rocket.mass_kg = 4.0;
  rocket.airframe->at_liftoff.centre_of_gravity_m = 0.9;
  rocket.airframe->after_burnout.centre_of_gravity_m = 0.85;
  const page::Chart chart = margin_chart(rocket);
  const auto at = [](const page::Series& series, double time_s) {
    const auto found = std::ranges::lower_bound(series.x, time_s - 1e-9);
    return series.y.at(static_cast<std::size_t>(found - series.x.begin()));
  };
  const page::Series& by_shape = chart.series.at(0);
  const page::Series& by_file = chart.series.at(1);
  const double shape_m = summarize(rocket).build_up.centre_of_pressure_m.value;
  const double after_a_second_m = (4.0 * 0.9 - 0.75 * (4.0 * 0.9 - 3.6 * 0.85)) / (4.0 - 0.3);
  for (const auto& [time_s, gravity_m] : {std::pair{0.0, 0.9}, {1.0, after_a_second_m}, {2.0, 0.85}}) {
    EXPECT_NEAR(at(by_file, time_s), (1.02 - gravity_m) / 0.08, 0.01) << time_s;
    EXPECT_NEAR(at(by_shape, time_s), (shape_m - gravity_m) / 0.08, 0.01) << time_s;
  }
  EXPECT_EQ(chart.levels.at(0).value, 1.0);
  EXPECT_EQ(chart.levels.at(1).value, 0.0);
}

model::Estimate margin_of(const Summary& summary, const std::string& what) {
  return std::ranges::find(summary.lines, what, &Line::what)->computed.value();
}

TEST(MarginOverTime, BeginsAndEndsWithTheMarginsOfTheTable) {
  for (const bool has_airframe : {true, false}) {
    sim::Vehicle rocket = shipped_vehicle("smokey");
    if (!has_airframe) {
      rocket.airframe.reset();
    }
    const Summary summary = summarize(rocket);
    const page::Chart chart = margin_chart(rocket);
    EXPECT_EQ(chart.series.size(), has_airframe ? 2U : 1U);
    const std::string whose = has_airframe ? ", file's centre of gravity" : "";
    const model::Estimate first = margin_of(summary, "static margin at lift-off" + whose);
    const model::Estimate last = margin_of(summary, "static margin after burn-out" + whose);
    EXPECT_NEAR(chart.series[0].y.front(), first.value, 1e-9);
    EXPECT_NEAR(chart.series[0].y.back(), last.value, 1e-9);
    EXPECT_NEAR(chart.areas[0].low.front(), first.low, 1e-9);
    EXPECT_NEAR(chart.areas[0].high.back(), last.high, 1e-9);
  }
}

TEST(MarginOverTime, SaysWhyItIsNotShown) {
  sim::Vehicle rocket = shipped_vehicle("smokey");
  rocket.airframe.reset();
  rocket.geometry->propellant.reset();
  const auto said = [&] { return std::get<std::string>(margin_over_time(rocket, summarize(rocket)).at(0)); };
  EXPECT_NE(said().find("[masses]"), std::string::npos);
  EXPECT_NE(result::html(answer(rocket, summarize(rocket), {})).find("Not shown over time"), std::string::npos);
}

/// Where in a drawing: from its tag on.
double number(const std::string& svg, std::size_t from, const std::string& behind) {
  return std::stod(svg.substr(svg.find(behind, from) + behind.size(), 12));
}

// For any places of the two centres: a label lies wholly above or below the foot of the other's line.
TEST(SideView, NoLineGoesThroughALabel) {
  sim::Vehicle rocket = shipped_vehicle("tasha3_launch2");
  for (double gravity_m = 0.2; gravity_m < 1.5; gravity_m += 0.05) {
    rocket.airframe->at_liftoff.centre_of_gravity_m = gravity_m;
    const std::string svg = side_view(*rocket.geometry, summarize(rocket), page::half_page);
    struct Mark {
      double from_y, foot_y, label_y;
    };
    std::vector<Mark> marks;
    for (std::size_t at = svg.find(" level\" d="); at != std::string::npos; at = svg.find(" level\" d=", at + 1)) {
      const std::size_t text = svg.find("<text", at);
      marks.push_back({number(svg, at, ","), number(svg, at, "V"), number(svg, text, " y=\"")});
    }
    ASSERT_EQ(marks.size(), 2U);
    for (const auto& [line, label] : {std::pair{marks[0], marks[1]}, {marks[1], marks[0]}}) {
      const double top = std::min(line.from_y, line.foot_y);
      const double bottom = std::max(line.from_y, line.foot_y);
      EXPECT_TRUE(label.label_y < top || label.label_y - 12.0 > bottom) << gravity_m;
    }
  }
}

TEST(SideView, ShowsEveryFinCanardAndCentre) {
  const sim::Vehicle rocket = shipped_vehicle("tasha3_launch2");
  for (const double width : {880.0, 428.0}) {
    const std::string svg = side_view(*rocket.geometry, summarize(rocket), width);
    for (const char* part : {"centre of pressure", "centre of gravity 0.900 m", "measured area", "model area"}) {
      EXPECT_NE(svg.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(svg.find("nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace fantail::airframe
