// SPDX-License-Identifier: MIT

#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "json/value.hpp"
#include "look_away.hpp"
#include "predict/answer.hpp"
#include "predict/prediction.hpp"
#include "predict/run.hpp"
#include "predict/sentences.hpp"
#include "runs/runner.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::predict {
namespace {

// A launch in six degrees of freedom, in a wind that is known roughly.

sim::Scenario scenario(const std::vector<std::string>& changes) {
  return input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
}

sim::Scenario windy(std::vector<std::string> more = {}) {
  more.insert(more.end(), {"flight.motion=six_dof", "wind.speed_m_s=5", "wind.from_deg=270", "wind.turbulence=0.1"});
  return scenario(more);
}

sim::Scenario uncertain() { return windy({"wind.speed_spread_m_s=1.5", "wind.direction_spread_deg=180"}); }

Prediction predicted(const sim::Scenario& flown, const Options& options) {
  return predict(flown, read_tunnel_result(flown.tunnel_result.value(), {}), options, look_away);
}

TEST(WindyPrediction, FliesEveryRunInAWindOfItsOwn) {
  const sim::Scenario flown = uncertain();
  const Prediction p = predicted(flown, {.runs = 6});
  for (std::size_t i = 0; i < p.runs.size(); ++i) {
    const auto& run = p.runs[i];
    const sim::WindParameters wind = drawn_wind(flown.wind, flown.wind_spread, runs::seed_of_run(flown.seed, i));
    EXPECT_EQ(run.wind.value().speed_m_s, wind.speed_m_s);
    EXPECT_EQ(run.wind.value().from_rad, wind.from_rad);
    // The same launch in exactly this wind.
    sim::Scenario alone = flown;
    alone.wind = wind;
    alone.wind_spread = {};
    const auto again = fly_run(alone, run.airframe, run.seed);
    EXPECT_EQ(again.apogee_m, run.apogee_m);
    EXPECT_EQ(again.drift_m, run.drift_m);
    EXPECT_GT(run.drift_m.value(), 5.0);
  }
}

// Against the path that its flight report has; an upright rocket in calm air does not tilt.
TEST(WindyPrediction, KeepsTheLargestTiltUnderControlOfARun) {
  const sim::Scenario flown = windy();
  const Prediction p = predicted(flown, {.runs = 3});
  const flight::Flight flight = fly_airframe(p.flown, p.runs[0].airframe, p.runs[0].seed, fly::Log::kept);
  double largest_rad = 0.0;
  for (const flight::PathPoint& point : flight.path) {
    const bool counts = point.time_s >= *flight.events.control_start_s && point.time_s <= *flight.events.control_end_s;
    largest_rad = counts ? std::max(largest_rad, point.tilt_rad) : largest_rad;
  }
  EXPECT_GT(text::degrees(largest_rad), 5.0);
  EXPECT_EQ(p.runs[0].largest_tilt_rad, largest_rad);
  EXPECT_FALSE(predicted(scenario({}), {.runs = 1}).runs[0].largest_tilt_rad) << "along a straight line";
}

std::string runs_of(const Prediction& p) { return result::csv(answer(p, {}, {}).spreadsheets.front()); }

TEST(WindyPrediction, IsTheSameWithEveryNumberOfThreadsAndRuns) {
  const Prediction one = predicted(uncertain(), {.runs = 5, .threads = 1});
  const Prediction three = predicted(uncertain(), {.runs = 5, .threads = 3});
  EXPECT_EQ(runs_of(one), runs_of(three));
  const Prediction two = predicted(uncertain(), {.runs = 2, .threads = 2});
  EXPECT_TRUE(runs_of(one).starts_with(runs_of(two)));
  const auto repeated = repeat_run(uncertain(), read_tunnel_result(uncertain().tunnel_result.value(), {}), {}, 4);
  EXPECT_EQ(repeated.run.drift_m, one.runs[4].drift_m);
  EXPECT_EQ(repeated.run.wind.value().speed_m_s, one.runs[4].wind.value().speed_m_s);
}

TEST(WindyPrediction, TellsHeightDriftAndWindWithTheirRanges) {
  const Prediction p = predicted(uncertain(), {.runs = 8});
  EXPECT_LT(p.apogee_m.value().p5, p.apogee_m.value().p95);
  EXPECT_LT(p.drift_m.value().p5, p.drift_m.value().p95);
  std::vector<double> drifts;
  for (const auto& run : p.runs) {
    drifts.push_back(run.drift_m.value());
  }
  EXPECT_EQ(p.drift_m.value().p95, campaign::quantiles(drifts).p95);
  const Decision d = decide(p, {});
  const std::string wind = wind_sentence(p.flown);
  EXPECT_EQ(figures(wind), (Numbers{"5", "1.5"})) << "from anywhere";
  EXPECT_NE(wind.find("turbulence"), std::string::npos) << wind;
  for (const std::string& said : {std::string{"  apogee  "}, std::string{"  drift at apogee  "}, wind}) {
    EXPECT_NE(result::text(answer(p, d, {})).find(said), std::string::npos) << said;
  }
  EXPECT_NE(result::html(answer(p, d, {})).find("drift at apogee"), std::string::npos);
  const json::Value json = json::parse(result::json(answer(p, d, {})));
  EXPECT_NEAR(json["drift_m"]["p95"].number(), p.drift_m.value().p95, 1e-3);
  EXPECT_NEAR(json["apogee_m"]["p5"].number(), p.apogee_m.value().p5, 1e-3);
}

TEST(WindyPrediction, WithoutASpreadSaysThatTheWindIsTheSameInAllRuns) {
  const Prediction p = predicted(windy(), {.runs = 2});
  EXPECT_EQ(p.wind_m_s.value().p5, 5.0);
  EXPECT_EQ(p.wind_m_s.value().p95, 5.0);
  const std::string wind = wind_sentence(p.flown);
  EXPECT_EQ(figures(wind), (Numbers{"5", "270"}));
  EXPECT_NE(wind.find("wind.speed_spread_m_s"), std::string::npos) << wind;
  EXPECT_NE(result::text(answer(p, decide(p, {}), {})).find(wind), std::string::npos);
}

TEST(WindyPrediction, SaysInHowMuchLessWindTheTiltLimitEndsNoControl) {
  sim::Scenario flown = windy({"launch_guide.tilt_deg=5", "launch_guide.azimuth_deg=270"});
  flown.wind.speed_m_s = 4.0;
  const Prediction p = predicted(flown, {.runs = 3});
  ASSERT_TRUE(p.runs[0].ended_by_tilt && p.runs[1].ended_by_tilt && p.runs[2].ended_by_tilt);
  const Decision d = decide(p, {});
  ASSERT_FALSE(d.advice.empty());
  const std::string& said = d.advice.back();
  EXPECT_EQ(figures(said), (Numbers{"3", "3", "3"})) << "none again, and all hold their roll: " << said;
  for (const char* changed : {"half", "upright"}) {
    EXPECT_NE(said.find(changed), std::string::npos) << said;
  }
  // Tried here once more: in half of it control lasts, in three quarters it does not always.
  const auto ended_by_tilt = [&](double wind_m_s) {
    sim::Scenario other = flown;
    other.wind.speed_m_s = wind_m_s;
    return std::ranges::count_if(p.runs,
                                 [&](const auto& run) { return fly_run(other, run.airframe, run.seed).ended_by_tilt; });
  };
  EXPECT_EQ(ended_by_tilt(2.0), 0);
  EXPECT_GT(ended_by_tilt(3.0), 0);
}

TEST(WindyPrediction, DoesNotBlameTheWindWhereTheGuideLeansTooFar) {
  const Prediction p = predicted(windy({"launch_guide.tilt_deg=15", "launch_guide.azimuth_deg=270"}), {.runs = 2});
  const Decision d = decide(p, {});
  ASSERT_FALSE(d.advice.empty());
  // Tried here once more.
  sim::Scenario upright = p.flown;
  upright.guide.tilt_rad = 0.0;
  const auto held = std::ranges::count_if(p.runs, [&upright](const auto& run) {
    const auto again = fly_run(upright, run.airframe, run.seed);
    EXPECT_FALSE(again.ended_by_tilt);
    return again.outcome == report::Outcome::held;
  });
  EXPECT_EQ(figures(d.advice.back()), (Numbers{"2", "2", "2", "2", std::to_string(held)})) << "2 still do without wind";
  EXPECT_NE(d.advice.back().find("upright"), std::string::npos) << d.advice.back();
  const Prediction calm = predicted(scenario({"flight.motion=six_dof", "launch_guide.tilt_deg=15"}), {.runs = 2});
  const std::string calm_advice = decide(calm, {}).advice.back();
  EXPECT_EQ(figures(calm_advice), (Numbers{"2", "2", "2"})) << calm_advice;
  EXPECT_NE(calm_advice.find("upright"), std::string::npos) << calm_advice;
}

TEST(WindyPrediction, OnAStraightLineHasNoDrift) {
  const Prediction p = predicted(scenario({}), {.runs = 2});
  EXPECT_FALSE(p.drift_m);
  EXPECT_FALSE(p.apogee_m);
  EXPECT_FALSE(p.runs[0].wind);
  EXPECT_EQ(wind_sentence(p.flown), "");
}

TEST(WindyPrediction, ASpreadOnAStraightLineIsRefused) {
  for (const char* change : {"wind.speed_spread_m_s=1", "wind.direction_spread_deg=20"}) {
    EXPECT_THROW((void)scenario({change}), text::Error) << change;
  }
}

using text::degrees;
using text::radians;

constexpr int draws = 40000;

struct WindMoments {
  double mean = 0.0;
  double deviation = 0.0;
};

template <typename ValueOf>
WindMoments moments(const sim::WindParameters& stated, const sim::WindSpread& spread, ValueOf value_of) {
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 0; seed < draws; ++seed) {
    const double value = value_of(drawn_wind(stated, spread, static_cast<std::uint64_t>(seed)));
    sum += value;
    squares += value * value;
  }
  return {sum / draws, std::sqrt(squares / draws - sum * sum / draws / draws)};
}

double speed(const sim::WindParameters& wind) { return wind.speed_m_s; }

TEST(DrawnWind, WithoutSpreadIsTheStatedOne) {
  const sim::WindParameters stated{.speed_m_s = 5.0, .from_rad = 1.0, .gust_m_s = 3.0, .turbulence = 0.1};
  const sim::WindParameters drawn = drawn_wind(stated, {}, 7);
  EXPECT_EQ(drawn.speed_m_s, 5.0);
  EXPECT_EQ(drawn.from_rad, 1.0);
  EXPECT_EQ(drawn.gust_m_s, 3.0);
  EXPECT_EQ(drawn.turbulence, 0.1);
}

TEST(DrawnWind, HasANormalSpeed) {
  const WindMoments found = moments({.speed_m_s = 8.0}, {.speed_m_s = 1.5}, speed);
  EXPECT_NEAR(found.mean, 8.0, 4.0 * 1.5 / std::sqrt(draws));
  EXPECT_NEAR(found.deviation, 1.5, 4.0 * 1.5 / std::sqrt(2.0 * draws));
}

// About zero, what is left of a normal distribution is one side of it: its mean is sqrt(2 / pi) of the deviation.
TEST(DrawnWind, IsCutAtZero) {
  const WindMoments found = moments({.speed_m_s = 0.0}, {.speed_m_s = 2.0}, speed);
  const double mean = 2.0 * std::sqrt(2.0 / std::numbers::pi);
  const double deviation = 2.0 * std::sqrt(1.0 - 2.0 / std::numbers::pi);
  EXPECT_NEAR(found.mean, mean, 4.0 * deviation / std::sqrt(draws));
  EXPECT_NEAR(found.deviation, deviation, 0.02);
}

TEST(DrawnWind, ComesFromAnywhereWithinTheSpreadAlike) {
  const sim::WindParameters stated{.speed_m_s = 5.0, .from_rad = radians(90.0)};
  const WindMoments found = moments(stated, {.direction_rad = radians(30.0)}, [](const sim::WindParameters& wind) {
    EXPECT_EQ(wind.speed_m_s, 5.0);
    EXPECT_GE(wind.from_rad, radians(60.0));
    EXPECT_LE(wind.from_rad, radians(120.0));
    return degrees(wind.from_rad);
  });
  EXPECT_NEAR(found.mean, 90.0, 0.4);
  EXPECT_NEAR(found.deviation, 30.0 / std::sqrt(3.0), 0.2);
}

TEST(DrawnWind, OfNoKnownDirectionComesFromEverywhereAlike) {
  const sim::WindParameters stated{.speed_m_s = 5.0, .from_rad = radians(350.0)};
  const sim::WindSpread unknown{.direction_rad = radians(180.0)};
  const WindMoments angle =
      moments(stated, unknown, [](const sim::WindParameters& wind) { return degrees(wind.from_rad); });
  EXPECT_NEAR(angle.mean, 180.0, 2.1);
  EXPECT_NEAR(angle.deviation, 360.0 / std::sqrt(12.0), 1.5);
  const WindMoments north =
      moments(stated, unknown, [](const sim::WindParameters& wind) { return std::cos(wind.from_rad); });
  EXPECT_NEAR(north.mean, 0.0, 0.015);
}

}  // namespace

}  // namespace fantail::predict
