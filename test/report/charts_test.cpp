// SPDX-License-Identifier: MIT

#include "json/value.hpp"
#include "report/answer.hpp"
#include "report/figures.hpp"
#include "report/results.hpp"
#include "report/sections.hpp"
#include "report/verdict_parts.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

// 3.8 s by the events, and 3.75 s from the first row to the last.
TEST(Html, SaysWhyTheTimeUnderControlIsShorterThanItsEventsAreApart) {
  SyntheticFlight synthetic;
  synthetic.end_control(4.4, core::PhaseReason::apogee);
  const auto page = [&synthetic] {
    const Figures f = figures(synthetic.flight);
    return result::html(answer(synthetic.flight, f, verdict(synthetic.flight, f)));
  };
  const auto time_under_control = [&page] {
    const std::string all = page();
    const std::size_t begin = all.find("<dt>time under control</dt>");
    return all.substr(begin, all.find("</dd>", begin) - begin);
  };
  EXPECT_EQ(time_under_control().find("<small>"), std::string::npos);
  std::erase_if(synthetic.flight.rows, [count = 0](const flight::Row&) mutable { return count++ % 50 != 0; });
  EXPECT_NE(time_under_control().find("3.75 <span>s</span><small>from"), std::string::npos) << time_under_control();
}

// A plot of no time at all has no ticks, and what draws it in a browser gives up.
TEST(Charts, ShowSomeTimeOfTheShortestTableAndOfEventsFarFromItsRows) {
  const auto least_view_s = [](const flight::Flight& flight) {
    double least_s = 1e9;
    for (const auto& view : charts(flight).views) {
      least_s = std::min(least_s, view.end_s - view.begin_s);
    }
    return least_s;
  };
  flight::Flight table;
  table.rows = {SyntheticFlight{}.flight.rows[1000]};
  EXPECT_GE(least_view_s(table), 0.01) << "one row";
  table.rows.push_back(table.rows.front());
  table.rows.back().time_s += 1e-6;
  EXPECT_GE(least_view_s(table), 0.01) << "two rows";
  table.events = {.liftoff_s = 900.0, .control_start_s = 700.0, .control_end_s = 600.0, .apogee_s = -50.0};
  EXPECT_GE(least_view_s(table), 0.01) << "events in no order";
}

// Launched from 0.2 s, controlling from 0.6 s to 3 s; the path is known from 0.1 s to 4 s.
TEST(Charts, HaveTheSameColorForAPhaseBehindEveryCurveOverTime) {
  SyntheticFlight synthetic;
  synthetic.end_control(3.0, core::PhaseReason::apogee);
  flight::Flight& flight = synthetic.flight;
  for (double time_s = 0.1; time_s < 4.005; time_s += 0.01) {
    flight.path.push_back({.time_s = time_s, .tilt_rad = 0.1 * time_s});
    flight.turning.push_back({.time_s = time_s, .true_roll_rate_rad_s = time_s});
  }
  const std::vector<page::ShadedRange> live = charts(flight).charts.at(0).shaded_ranges;
  ASSERT_EQ(live.size(), 4U);
  EXPECT_NE(live[1].role, live[2].role);
  const auto chart_of = [](const result::Section& section, std::size_t block) {
    return std::get<result::Picture>(section.blocks.at(block)).chart;
  };
  for (const page::Chart& chart : {chart_of(path_section(flight), 2), chart_of(turning_section(flight), 0)}) {
    ASSERT_EQ(chart.shaded_ranges.size(), live.size()) << chart.label;
    EXPECT_NEAR(chart.x_range.value().low, 0.1, 1e-9);
    EXPECT_NEAR(chart.x_range.value().high, 4.0, 1e-6) << "no wider than its curves";
    for (std::size_t i = 0; i < live.size(); ++i) {
      EXPECT_EQ(chart.shaded_ranges[i].label, live[i].label);
      EXPECT_EQ(chart.shaded_ranges[i].role, live[i].role) << live[i].label;
      EXPECT_NEAR(chart.shaded_ranges[i].begin, std::max(live[i].begin, 0.1), 1e-9);
      EXPECT_NEAR(chart.shaded_ranges[i].end, std::min(live[i].end, 4.0), 1e-6);
    }
  }
  flight.known.phase = false;
  EXPECT_TRUE(chart_of(path_section(flight), 2).shaded_ranges.empty());
}

/// Coning of 5 deg at 2 Hz since the pad: the camera turns by 2.74 deg/s, which no integral of a roll rate has.
constexpr double cone_deg = 5.0;
const double apart_deg_s = 720.0 * (1.0 - std::cos(cone_deg * std::numbers::pi / 180.0));

flight::Flight coning() {
  SyntheticFlight synthetic;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->geometric_roll_rad = row.truth->roll_angle_rad + text::radians(apart_deg_s * (row.time_s + 0.5));
  }
  synthetic.end_control(3.6, core::PhaseReason::control_time_over);
  return synthetic.flight;
}

TEST(CameraRoll, CountsFromLaunchDetectionToTheEndOfControl) {
  const Figures f = figures(coning());
  ASSERT_TRUE(f.camera_roll);
  // Detection at 0.2 s, the last row under control at 3.599 s.
  EXPECT_NEAR(text::degrees(f.camera_roll->at_end_rad), 3.399 * apart_deg_s, 1e-9);
  EXPECT_EQ(f.camera_roll->largest_rad, f.camera_roll->at_end_rad);
}

TEST(CameraRoll, IsToldOnThePageAndInTheSummary) {
  const flight::Flight flight = coning();
  const Figures f = figures(flight);
  const Verdict v = verdict(flight, f);
  const auto camera = json::parse(result::json(summary(flight, f, v)))["camera_roll"];
  EXPECT_NEAR(camera["largest_apart_deg"].number(), 3.399 * apart_deg_s, 1e-4);
  EXPECT_NEAR(camera["at_end_apart_deg"].number(), 3.399 * apart_deg_s, 1e-4);
  const std::string page = result::html(answer(flight, f, v));
  EXPECT_NE(page.find("9.3 deg", page.find("camera")), std::string::npos);
}

TEST(CameraRoll, IsNotMentionedWhereNothingIsKnownOfIt) {
  const flight::Flight flight = SyntheticFlight{}.flight;
  const Figures f = figures(flight);
  const Verdict v = verdict(flight, f);
  EXPECT_FALSE(f.camera_roll);
  EXPECT_FALSE(json::parse(result::json(summary(flight, f, v))).contains("camera_roll"));
  EXPECT_EQ(result::html(answer(flight, f, v)).find("camera"), std::string::npos);
}

constexpr double g_m_s2 = 9.80665;

/// Two seconds of falling after an apogee at 10 s, a row a millisecond, with a pull from 10.5 s on.
flight::Flight falling(double pull_g, double pull_for_s) {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.events.apogee_s = 10.0;
  for (int i = 0; i < 2000; ++i) {
    const double time_s = 10.001 + 0.001 * i;
    const bool pulled = time_s >= 10.4995 && time_s < 10.4995 + pull_for_s;
    flight.rows.push_back({.time_s = time_s, .specific_force_m_s2 = (pulled ? pull_g : -0.9) * g_m_s2});
  }
  return flight;
}

TEST(JoltAfterApogee, IsWhereTheAccelerometerFeelsMoreThanOneAndAHalfG) {
  for (const double pull_g : {4.0, -4.0}) {
    const auto jolt = jolt_after_apogee(falling(pull_g, 0.3));
    ASSERT_TRUE(jolt);
    EXPECT_NEAR(jolt->time_s, 10.5, 1e-9);
    EXPECT_NEAR(jolt->specific_force_m_s2, 4.0 * g_m_s2, 1e-9);
  }
}

TEST(JoltAfterApogee, IsNoKnockAndNoFallThroughAir) {
  EXPECT_FALSE(jolt_after_apogee(falling(9.0, 0.015)));
  EXPECT_FALSE(jolt_after_apogee(falling(1.4, 0.5)));
}

// Of a rocket that turned over while its motor burned.
TEST(JoltAfterApogee, IsNotTheThrustOfAMotorThatStillBurns) {
  flight::Flight flight = falling(4.0, 0.3);
  flight.events.burnout_s = 10.9;
  EXPECT_FALSE(jolt_after_apogee(flight));
  flight.events.burnout_s = 3.0;
  EXPECT_TRUE(jolt_after_apogee(flight));
}

TEST(JoltAfterApogee, NeedsAnApogee) {
  flight::Flight flight = falling(4.0, 0.3);
  flight.events.apogee_s.reset();
  EXPECT_FALSE(jolt_after_apogee(flight));
  flight.phase_changes.push_back({.time_s = 10.1, .phase = core::Phase::finished, .reason = core::PhaseReason::apogee});
  EXPECT_TRUE(jolt_after_apogee(flight));
  flight.tunnel = true;
  EXPECT_FALSE(jolt_after_apogee(flight));
}

TEST(GainMarginText, SaysWhereLessGainIsWhatMakesTheLoopSwing) {
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0, .gain_margin = 3.21}), "3.2 times");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0, .gain_margin = 0.4}), "0.4 times, and oscillates with less");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0}), "any");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = -0.2, .gain_margin = 0.7}), "0.7 times");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = -0.2, .gain_margin = 1.5}), "1.5 times, and oscillates with less");
}

TEST(Html, OfALoopThatSwingsWithLessGainPageAndTerminalSaySo) {
  SyntheticFlight synthetic;
  const flight::Flight& flight = synthetic.flight;
  synthetic.flight.loop_margins = {{.speed_m_s = 20.0, .phase_margin_rad = 0.5, .gain_margin = 0.4},
                                   {.speed_m_s = 50.0, .phase_margin_rad = 0.6, .gain_margin = 3.0},
                                   {.speed_m_s = 80.0, .phase_margin_rad = 0.7}};
  const Figures f = figures(flight);
  const result::Document document = summary(flight, f, verdict(flight, f));
  for (const std::string& out : {result::text(document), result::html(answer(flight, f, verdict(flight, f)))}) {
    EXPECT_NE(out.find(gain_margin_text(flight.loop_margins[0])), std::string::npos);
    EXPECT_NE(out.find("3 times"), std::string::npos);
    EXPECT_NE(out.find("any"), std::string::npos);
  }
  EXPECT_EQ(json::parse(result::json(document))["loop_margins"][0]["gain_margin"], 0.4);
}

TEST(DifferentMargins, OfThoseThatArePrintedAlikeTheWorstIsShown) {
  const auto margin = [](double speed_m_s, double degrees) {
    return flight::LoopMargin{.speed_m_s = speed_m_s, .phase_margin_rad = text::radians(degrees)};
  };
  flight::Flight flight;
  flight.loop_margins = {margin(21.9, 56.2), margin(22.0, 55.9), margin(22.4, 56.4), margin(22.4, 50.0)};
  const std::vector<flight::LoopMargin> shown = different_margins(flight);
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0].speed_m_s, 22.0);
  EXPECT_EQ(shown[1].speed_m_s, 22.4);
}

SideDeflection of(flight::Flight& flight, const std::array<double, 4>& shafts_deg) {
  for (flight::Row& row : flight.rows) {
    for (std::size_t i = 0; i < shafts_deg.size(); ++i) {
      row.encoders_rad[i] = text::radians(shafts_deg[i]);
    }
    row.truth->speed_m_s = 60.0;
  }
  return figures(flight).side_deflection.value();
}

double largest_deg(const std::array<double, 4>& shafts_deg) {
  SyntheticFlight synthetic;
  return text::degrees(of(synthetic.flight, shafts_deg).largest_rad);
}

TEST(SideDeflection, OfFourThatTurnAlikeIsNone) { EXPECT_NEAR(largest_deg({5, 5, 5, 5}), 0.0, 1e-9); }

// Three at 6 and one at 0: the pair without a fault cancels, the other leaves 6.
TEST(SideDeflection, OfOneThatStandsStillIsThatOfItsPartner) {
  EXPECT_NEAR(largest_deg({0, 6, 6, 6}), 6.0, 1e-9);
  EXPECT_NEAR(largest_deg({6, 6, 6, 0}), 6.0, 1e-9);
}

TEST(SideDeflection, OfNeighboursAddsAsVectorsAndOfOppositeOnesAsNumbers) {
  EXPECT_NEAR(largest_deg({0, 0, 3, 4}), 5.0, 1e-9);
  EXPECT_NEAR(largest_deg({-4, 2, 6, 2}), 10.0, 1e-9);
}

TEST(SideDeflection, CountsFromTheTrimInTheSenseOfRoll) {
  SyntheticFlight synthetic;
  synthetic.flight.plan.canards.each[2].direction = core::Direction::reversed;
  synthetic.flight.plan.canards.each[2].trim = core::Angle::from_degrees(1.0F);
  EXPECT_NEAR(text::degrees(of(synthetic.flight, {5, 5, -4, 5}).largest_rad), 0.0, 1e-5);
}

// 1/2 rho v^2 = 2205 Pa at 60 m/s; 2e-4 m3 a radian; 6 degrees.
TEST(SideDeflection, HasAMomentWhereTheVehicleSaysWhereItsCanardsAre) {
  SyntheticFlight synthetic;
  EXPECT_FALSE(of(synthetic.flight, {0, 6, 6, 6}).largest_moment_n_m);
  synthetic.flight.side_moment_m3 = 2e-4;
  EXPECT_NEAR(of(synthetic.flight, {0, 6, 6, 6}).largest_moment_n_m.value(), 2205.0 * 2e-4 * text::radians(6.0), 1e-6);
}

TEST(SideDeflection, IsNotKnownWithoutAllFourEncoders) {
  SyntheticFlight synthetic;
  of(synthetic.flight, {0, 6, 6, 6});
  for (flight::Row& row : synthetic.flight.rows) {
    row.encoders_rad[3].reset();
  }
  EXPECT_FALSE(figures(synthetic.flight).side_deflection);
}

// 1.2 and 2 rad/m at 50 m/s are 3438 and 5730 deg/s, out of sight of a roll of 100 deg/s; at 1 m/s they are in sight.
TEST(RollRateChart, HasTheResonanceWithThePitchAsFarAsItIsInSight) {
  SyntheticFlight synthetic;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->roll_rate_rad_s = text::radians(100.0);
    row.truth->speed_m_s = row.time_s < 2.0 ? 50.0 : 1.0;
  }
  const auto rates = [&] { return charts(synthetic.flight).charts[1]; };
  EXPECT_TRUE(rates().areas.empty()) << "a vehicle that does not say how it swings";
  synthetic.flight.resonance_1_m = {1.2, 2.0};
  const page::Chart chart = rates();
  ASSERT_EQ(chart.areas.size(), 2U);
  for (std::size_t i = 0; i < chart.areas[0].x.size(); ++i) {
    if (chart.areas[0].x[i] < 2.0) {
      EXPECT_TRUE(std::isnan(chart.areas[0].low[i]));
    } else {
      EXPECT_NEAR(chart.areas[0].low[i], 68.755, 1e-3);
      EXPECT_NEAR(chart.areas[0].high[i], 114.592, 1e-3);
      EXPECT_NEAR(chart.areas[1].low[i], -114.592, 1e-3);
      EXPECT_NEAR(chart.areas[1].high[i], -68.755, 1e-3);
    }
  }
  EXPECT_EQ(chart.areas[0].name, "roll resonance");
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->speed_m_s = row.time_s < 4.2 ? 50.0 : 1.0;
  }
  EXPECT_TRUE(rates().areas.empty()) << "a scrap at the end";
}

}  // namespace

}  // namespace fantail::report
