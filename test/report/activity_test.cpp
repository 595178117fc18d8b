// SPDX-License-Identifier: MIT
#include "report/activity.hpp"

#include <filesystem>
#include <fstream>

#include "json/value.hpp"
#include "report/answer.hpp"
#include "report/results.hpp"
#include "report/running_figures.hpp"
#include "report/verdict_parts.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

constexpr double settling_s = 1.0;

/// Five seconds under control at 1 kHz, the canards at an angle in degrees that is a function of time.
std::vector<flight::Row> canards_at(const std::function<double(double time_s)>& angle_deg) {
  std::vector<flight::Row> rows(5000);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].time_s = static_cast<double>(i) / 1000.0;
    rows[i].canard_rad = text::radians(angle_deg(rows[i].time_s));
    rows[i].command_rad = *rows[i].canard_rad;
  }
  return rows;
}

std::optional<Oscillation> find_oscillation(const std::vector<flight::Row>& control) {
  OscillationWatch watch{settling_s};
  for (const flight::Row& row : control) {
    watch.add(row);
  }
  return watch.found();
}

double sine(double frequency_hz, double time_s) { return std::sin(2.0 * std::numbers::pi * frequency_hz * time_s); }

TEST(Oscillation, HasTheFrequencyAndTheEndsOfTheSwing) {
  for (const double frequency_hz : {4.0, 13.0, 40.0}) {
    const auto rows = canards_at([&](double t) { return 3.5 + 4.8 * sine(frequency_hz, t); });
    const auto found = find_oscillation(rows);
    ASSERT_TRUE(found) << frequency_hz;
    EXPECT_NEAR(found->frequency_hz, frequency_hz, 0.05 * frequency_hz);
    EXPECT_NEAR(text::degrees(found->lowest_rad), -1.3, 0.1);
    EXPECT_NEAR(text::degrees(found->highest_rad), 8.3, 0.1);
    EXPECT_NEAR(found->from_s, 1.0, 1e-6);
  }
}

TEST(Oscillation, IsNoneWhereTheCanardsStandCreepOrTremble) {
  EXPECT_FALSE(find_oscillation({}));
  EXPECT_FALSE(find_oscillation(canards_at([](double) { return 5.0; })));
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 3.0 * t; })));
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 5.0 + 0.9 * sine(13.0, t); })));
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 5.0 * sine(1.0, t); })))
      << "slower than three swings a second";
}

TEST(Oscillation, IsNoneWhereASwingDiesAway) {
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 40.0 * std::exp(-t / 0.5) * sine(8.0, t); })));
}

TEST(Oscillation, DuringExcitationAndWhileAStepSettlesIsNotJudged) {
  auto rows = canards_at([](double t) { return 5.0 * sine(8.0, t); });
  for (flight::Row& row : rows) {
    row.excitation_rad = row.time_s < 3.6 ? 0.01 : 0.0;  // then 0.4 s are left
  }
  EXPECT_FALSE(find_oscillation(rows));
  for (flight::Row& row : rows) {
    row.excitation_rad = row.time_s < 2.5 ? 0.01 : 0.0;
  }
  EXPECT_TRUE(find_oscillation(rows));
  for (flight::Row& row : rows) {
    row.excitation_rad = 0.0;
    row.reference_rad = std::floor(row.time_s / 0.9);
  }
  EXPECT_FALSE(find_oscillation(rows));
}

TEST(Oscillation, IsNoneOfEncodersThatAreNoisy) {
  auto noisy = canards_at([](double t) { return 5.0 + 2.0 * sine(24.0, t); });
  for (flight::Row& row : noisy) {
    row.command_rad = text::radians(5.0);
  }
  EXPECT_FALSE(find_oscillation(noisy)) << "nothing commands it";
  auto known = canards_at([](double t) { return 5.0 + 2.0 * sine(24.0, t); });
  for (flight::Row& row : known) {
    row.truth = flight::Truth{.canard_rad = text::radians(5.0)};
  }
  EXPECT_FALSE(find_oscillation(known)) << "the true canards stand still";
}

TEST(Oscillation, IsThatOfTheTrueCanardsWhereTheyAreKnown) {
  auto rows = canards_at([](double) { return 5.0; });
  for (flight::Row& row : rows) {
    row.truth = flight::Truth{.canard_rad = text::radians(5.0 + 2.0 * sine(8.0, row.time_s))};
  }
  EXPECT_TRUE(find_oscillation(rows));
}

TEST(Oscillation, IsThatOfTheCommandWhereNoEncoderIsKnown) {
  auto rows = canards_at([](double) { return 0.0; });
  for (flight::Row& row : rows) {
    row.canard_rad.reset();
    row.command_rad = text::radians(3.0) * sine(10.0, row.time_s);
  }
  EXPECT_TRUE(find_oscillation(rows));
}

constexpr double ignition_s = 12.345;

/// As they are seen while the flight is flown: its rows count from power-up.
RunningFigures while_flown(const flight::Flight& flight) {
  RunningFigures running{flight.tunnel};
  flight::Flight so_far = flight;
  so_far.events = {};
  for (flight::Row row : flight.rows) {
    if (flight.events.apogee_s && row.time_s >= *flight.events.apogee_s) {
      so_far.events.apogee_s = *flight.events.apogee_s + ignition_s;
    }
    row.time_s += ignition_s;
    running.add(row, so_far);
  }
  return running;
}

TEST(RunningFigures, OnTheClockOfPowerUpAreThoseOfTheRowsOnTheirOwn) {
  SyntheticFlight synthetic;
  synthetic.end_control(4.1, core::PhaseReason::apogee);
  synthetic.flight.events.apogee_s = 4.3;
  for (flight::Row& row : synthetic.flight.rows) {
    row.saturated = row.time_s > 3.2;
    row.truth->canard_rad = text::radians(6.0) * std::sin(2.0 * std::numbers::pi * 7.0 * row.time_s);
    row.truth->roll_angle_rad += text::radians(row.time_s);
    row.truth->speed_m_s = 30.0 - row.time_s;
    row.truth->height_m = 10.0 * row.time_s;
  }
  const Figures kept = figures(synthetic.flight);
  EXPECT_TRUE(kept.oscillation && kept.at_limit_since_s && kept.roll_after_end_rad && kept.mean_hold_error_rad);
  Figures flown = while_flown(synthetic.flight).figures(synthetic.flight, {.zero_s = ignition_s});
  flown.side_deflection = kept.side_deflection;
  EXPECT_TRUE(flown == kept);
}

TEST(RunningFigures, RollAfterControlCountsUntilTheApogeeThatLasts) {
  SyntheticFlight synthetic;
  synthetic.end_control(3.0, core::PhaseReason::tilted_too_far);
  flight::Flight& flight = synthetic.flight;
  RunningFigures running{false};
  for (flight::Row& row : flight.rows) {
    const double deg = row.time_s < 3.25 ? 0.0 : row.time_s < 3.35 ? 20.0 : row.time_s < 4.0 ? 12.0 : 30.0;
    row.truth->roll_angle_rad = text::radians(deg);
    flight.events.apogee_s.reset();
    if (row.time_s >= 3.2 && row.time_s < 3.4) {
      flight.events.apogee_s = 3.2;  // a hop's
    } else if (row.time_s >= 3.9) {
      flight.events.apogee_s = 3.9;
    }
    running.add(row, flight);
  }
  EXPECT_NEAR(text::degrees(running.figures(flight).roll_after_end_rad.value()), 20.0, 1e-9);
}

TEST(RunningFigures, OfAFlightWhoseApogeeFellIntoAGapTheFirstRowBehindItCounts) {
  SyntheticFlight synthetic;
  synthetic.end_control(3.0, core::PhaseReason::tilted_too_far);
  flight::Flight& flight = synthetic.flight;
  std::erase_if(flight.rows, [](const flight::Row& row) { return row.time_s >= 3.0 && row.time_s < 4.0; });
  for (flight::Row& row : flight.rows) {
    row.truth->roll_angle_rad = text::radians(row.time_s < 3.0 ? 0.0 : row.time_s < 4.0005 ? 25.0 : 70.0);
  }
  flight.events.apogee_s = 3.5;
  EXPECT_NEAR(text::degrees(figures(flight).roll_after_end_rad.value()), 25.0, 1e-9);
}

/// A roll that is held throughout, of a rocket that turned over.
flight::Flight turned_over() {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.events.burnout_s = 5.25;
  flight.before_burnout = {
      .turned_over_s = 3.0, .largest_tilt_rad = text::radians(165.4), .sank_s = 4.5, .sank_m = 3.1};
  flight.path = {{.time_s = 0.0}};
  return flight;
}

TEST(FailedAscentText, TellsTheTurnFirstAndTheRestInTheOrderOfTime) {
  flight::Flight flight = turned_over();
  flight.before_burnout->parachute_s = 4.6;
  flight.before_burnout->ground_s = 5.1;
  const std::string text = before_burnout(flight);
  EXPECT_EQ(fantail::figures(text), (Numbers{"3.00", "165", "3.1", "4.50", "4.60", "5.10", "5.25"})) << text;
  EXPECT_LT(text.find("sank"), text.find("parachute")) << text;
  EXPECT_LT(text.find("parachute"), text.rfind("urn-out")) << text;
}

TEST(FailedAscentText, IsTheVerdictWhateverTheRoll) {
  EXPECT_EQ(verdict_of(SyntheticFlight{}.flight).outcome, Outcome::held);
  const flight::Flight flight = turned_over();
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::ascent_failed);
  EXPECT_EQ(result::tone(summary(flight, figures(flight), v).verdict), page::Tone::bad);
  EXPECT_TRUE(v.text.starts_with(before_burnout(flight) + " ")) << v.text;
  EXPECT_TRUE(v.roll_is_judged);
  EXPECT_EQ(numbers(v), (Numbers{"3.00", "165", "3.1", "4.50", "5.25", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_NE(result::html(answer(flight, figures(flight), v)).find("Ascent failed"), std::string::npos);
}

/// A roll that is held throughout, of a rocket that the air meets broadside and then from behind.
flight::Flight tail_first(double static_margin_calibres, double apogee_s) {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.events.apogee_s = apogee_s;
  flight.extremes.static_margin_calibres = static_margin_calibres;
  for (const auto& [time_s, angle_deg] : {std::pair{1.0, 4.0}, {4.0, 60.0}, {4.5, 91.0}, {5.0, 170.0}}) {
    flight.path.push_back({.time_s = time_s, .angle_of_attack_rad = text::radians(angle_deg)});
  }
  return flight;
}

TEST(FailedAscentText, SaysFromWhenOnAnUnstableRocketFliesTailFirst) {
  const Verdict v = verdict_of(tail_first(-0.5, 7.25));
  EXPECT_EQ(v.outcome, Outcome::ascent_failed);
  EXPECT_EQ(fantail::figures(v.text).at(0), "4.50") << v.text;
  EXPECT_EQ(fantail::figures(v.text).at(1), "2.75") << v.text;
  EXPECT_TRUE(says(v, "tail first") && says(v, "not stable")) << v.text;
  for (const flight::Flight& other : {tail_first(0.5, 7.25), tail_first(-0.5, 4.25), tail_first(-0.5, 4.99)}) {
    EXPECT_NE(verdict_of(other).outcome, Outcome::ascent_failed) << "stable, or after its highest point, or near it";
  }
  flight::Flight both = tail_first(-0.5, 7.25);
  both.before_burnout = turned_over().before_burnout;
  EXPECT_FALSE(says(verdict_of(both), "tail first")) << "it had turned over before";
}

TEST(FailedAscentText, AHopOnThePadIsToldAndDecidesNothing) {
  flight::Flight flight = SyntheticFlight{}.flight;
  flight.before_burnout = {.ground_s = 0.05, .left_again_s = 0.15};
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(numbers(v), (Numbers{"0.05", "0.15", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "pad")) << v.text;
}

TEST(FailedAscentText, IsReadBackFromTheSummary) {
  flight::Flight flight = turned_over();
  const Figures f = figures(flight);
  const Verdict v = verdict(flight, f);
  const std::string json = result::json(summary(flight, f, v));
  EXPECT_EQ(json::parse(json)["outcome"], "ascent_failed");
  EXPECT_EQ(json::parse(json)["before_burnout"]["turned_over_s"], 3.0);
  const auto file = std::filesystem::temp_directory_path() / "fantail_failed_ascent_test.json";
  std::ofstream{file} << json;
  flight::Flight again = SyntheticFlight{}.flight;
  again.path = flight.path;
  add_summary(again, file);
  std::filesystem::remove(file);
  EXPECT_EQ(before_burnout(again), before_burnout(flight));
  EXPECT_EQ(verdict_of(again).outcome, Outcome::ascent_failed);
  EXPECT_FALSE(json::parse(result::json(summary(SyntheticFlight{}.flight, f, v))).contains("before_burnout"));
}

}  // namespace

}  // namespace fantail::report
