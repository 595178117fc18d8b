// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "report/verdict.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::sil {
namespace {

// What the same rocket would have done with its canards at trim.

using Changes = std::vector<input::Override>;

struct Pair {
  explicit Pair(const char* name, const Changes& changes = {})
      : scenario{input::load_scenario(name, changes)},
        flown{fly::fly_scenario(scenario)},
        free{fly::roll_without_control(scenario, flown)} {}

  sim::Scenario scenario;
  flight::Flight flown;
  std::vector<flight::FreeRollPoint> free;
};

TEST(WithoutControl, RollsAsTheFlightDidUntilControlStartsAndFartherAfterwards) {
  const Pair pair{"tasha3_launch2"};
  const double start_s = pair.flown.events.control_start_s.value();
  double largest_difference_rad = 0.0;
  for (const flight::Row& row : pair.flown.rows) {
    const auto free_rad = flight::free_roll_angle_rad(pair.free, row.time_s);
    if (free_rad && row.time_s <= start_s) {
      // Between two points 10 ms apart the line is off by an eighth of the acceleration's 1e-4 s2.
      ASSERT_NEAR(*free_rad, row.truth->roll_angle_rad, 1e-4) << row.time_s;
    } else if (free_rad) {
      largest_difference_rad = std::max(largest_difference_rad, std::abs(*free_rad - row.truth->roll_angle_rad));
    }
  }
  EXPECT_GT(largest_difference_rad, 2.0 * std::numbers::pi);  // the fins turn it by more than a turn
}

// Eq 1 where the rate is steady: alpha p = beta v u_d, the area on both sides. In the tunnel alpha is 19.4, beta 9.6,
// the wind 22 m/s, and fins and swirl come to -6.1 deg.
TEST(WithoutControl, InASteadyWindTurnsAsFastAsTheFinOffsetDrivesItAgainstTheDamping) {
  const Pair pair{"tunnel_steps", {{"run", "control_time_s", "20"}}};
  const double expected_deg_s = 9.6 / 19.4 * 22.0 * -6.1;
  EXPECT_NEAR(text::degrees(pair.free.back().true_roll_rate_rad_s), expected_deg_s, 0.05 * std::abs(expected_deg_s));
}

TEST(WithoutControl, IsTheFlightOfAPlanWhoseGainsAreZero) {
  const Pair pair{"tasha3_launch1"};
  const Changes zero{{"controller", "proportional_gain", "0"},
                     {"controller", "derivative_gain_s", "0"},
                     {"excitation", "form", "none"}};
  const flight::Flight slack = fly::fly_scenario(input::load_scenario("tasha3_launch1", zero));
  std::size_t compared = 0;
  for (const flight::Row& row : slack.rows) {
    const auto same = std::ranges::find(pair.free, row.time_s, &flight::FreeRollPoint::time_s);
    if (same != pair.free.end()) {
      ASSERT_EQ(same->true_roll_angle_rad, row.truth->roll_angle_rad) << row.time_s;
      ++compared;
    }
  }
  EXPECT_EQ(compared, pair.free.size());
}

TEST(WithoutControl, IsNotFlownWhereItSaysNothing) {
  EXPECT_TRUE(Pair{"gimbal"}.free.empty());
  EXPECT_TRUE(Pair{"tunnel_stability"}.free.empty());
  EXPECT_TRUE((Pair{"tasha3_launch1",
                    {{"controller", "proportional_gain", "0"},
                     {"controller", "derivative_gain_s", "0"},
                     {"excitation", "form", "none"}}}
                   .free.empty()))
      << "a law that never moves a canard by itself is without control already";
  EXPECT_TRUE((Pair{"tasha3_launch2", {{"launch_detection", "threshold_g", "10"}}}.free.empty()));  // never launched
}

TEST(WithoutControl, CanBeGivenUp) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const flight::Flight flown = fly::fly_scenario(scenario);
  EXPECT_THROW((void)fly::roll_without_control(scenario, flown, [](double) { throw 1; }), int);
}

// The second launch, with its fin offset of -4.9 degrees, flown with each mode of the law (docs/control.md).

constexpr double offset_deg = -4.9;

flight::Flight fly(const std::string& scenario, const std::vector<std::string>& changes = {}) {
  return fly::fly_scenario(input::load_scenario(scenario, input::parse_overrides(changes)));
}

const std::vector<std::string> observed{"offset.rejection=observer", "roll_model.roll_inertia_kg_m2=0.00393",
                                        "roll_model.reference_area_m2=5.0265e-5", "roll_model.damping_m2=23",
                                        "roll_model.torque_m=9"};

struct Seen {
  double mean_error_deg;  ///< of phi - R, outside of the first second after control start and after each step
  double angle_deg;       ///< mean of 7.5 to 9 s after lift-off, behind step and chirp
  double estimate_deg;    ///< likewise
};

Seen look(const flight::Flight& flight) {
  double error = 0.0;
  double errors = 0.0;
  double angle = 0.0;
  double estimate = 0.0;
  double rest = 0.0;
  double reference_rad = std::nan("");
  double counts_from_s = 0.0;
  for (const flight::Row& row : flight.rows) {
    if (row.phase != core::Phase::controlling) {
      continue;
    }
    if (row.reference_rad != reference_rad) {
      reference_rad = row.reference_rad;
      counts_from_s = row.time_s + 1.0;
    }
    if (row.time_s >= counts_from_s) {
      error += text::degrees(std::abs(row.roll_angle_rad - row.reference_rad));
      errors += 1.0;
    }
    if (row.time_s >= 7.7 && row.time_s < 9.0) {
      angle += text::degrees(row.roll_angle_rad);
      estimate += text::degrees(row.offset_estimate_rad);
      rest += 1.0;
    }
  }
  return {.mean_error_deg = error / errors, .angle_deg = angle / rest, .estimate_deg = estimate / rest};
}

TEST(OffsetRejection, AsPublishedTheLoopRestsBesideItsReferenceByOffsetOverGain) {
  const Seen seen = look(fly("tasha3_launch2"));
  EXPECT_NEAR(seen.angle_deg, -20.0 + offset_deg / 0.5, 0.2);
  EXPECT_GT(seen.mean_error_deg, 9.0);
  EXPECT_EQ(seen.estimate_deg, 0.0);
}

TEST(OffsetRejection, WithTheIntegralTheShippedPlanRestsAtItsReference) {
  const Seen seen = look(fly("tasha3_launch2_integral"));
  EXPECT_NEAR(seen.angle_deg, -20.0, 0.2);
  EXPECT_LT(seen.mean_error_deg, 1.0);
  EXPECT_NEAR(seen.estimate_deg, offset_deg, 0.1);
}

TEST(OffsetRejection, WithTheObserverTheLoopRestsAtItsReferenceToo) {
  const Seen seen = look(fly("tasha3_launch2", observed));
  EXPECT_NEAR(seen.angle_deg, -20.0, 0.2);
  EXPECT_LT(seen.mean_error_deg, 1.0);
  EXPECT_NEAR(seen.estimate_deg, offset_deg, 0.1);
}

TEST(OffsetRejection, AScheduleAloneMovesTheRestByItsFactor) {
  const Seen seen = look(fly("tasha3_launch2", {"gain_schedule.speeds_m_s=[20]", "gain_schedule.factors=[2]"}));
  EXPECT_NEAR(seen.angle_deg, -20.0 + offset_deg / (2.0 * 0.5), 0.2);
}

TEST(OffsetRejection, BesideAScheduleTheIntegralRestsAtItsReferenceAllTheSame) {
  const Seen seen = look(
      fly("tasha3_launch2_integral", {"gain_schedule.speeds_m_s=[20,40,80]", "gain_schedule.factors=[1.5,1.2,0.7]"}));
  EXPECT_NEAR(seen.angle_deg, -20.0, 0.2);
  EXPECT_NEAR(seen.estimate_deg, offset_deg, 0.1);
}

// Nothing is green that the simulation of roll does not hold for: rockets that are not stable, and air that meets the
// rocket where its fins stall. What is expected is made from the numbers of the files and from the path that was flown.

sim::Scenario launch_with(const std::vector<std::string>& changes) {
  return input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
}

report::Verdict verdict_on(const flight::Flight& flight) { return report::verdict(flight, report::figures(flight)); }

report::Verdict verdict_with(const std::vector<std::string>& changes) {
  return verdict_on(fly::fly_scenario(launch_with(changes)));
}

/// Of the flown path, from the beginning of control to its end, where the rocket was as fast as at first.
double largest_attack_deg(const flight::Flight& flight) {
  const auto speed_m_s = [](const flight::PathPoint& p) {
    return std::sqrt(p.north_m_s * p.north_m_s + p.east_m_s * p.east_m_s + p.up_m_s * p.up_m_s);
  };
  double first_m_s = 0.0;
  double largest_deg = 0.0;
  for (const flight::PathPoint& p : flight.path) {
    if (p.time_s < *flight.events.control_start_s ||
        p.time_s > flight.events.control_end_s.value_or(*flight.events.apogee_s)) {
      continue;
    }
    first_m_s = first_m_s > 0.0 ? first_m_s : speed_m_s(p);
    if (speed_m_s(p) >= first_m_s) {
      largest_deg = std::max(largest_deg, p.angle_of_attack_rad * 57.29577951308232);
    }
  }
  return largest_deg;
}

// The centre of gravity is at 0.9 m at lift-off and 0.875 after burn-out, a calibre 0.08 m.
TEST(OutsideModel, ARocketWithItsCentreOfPressureInFrontOfItsCentreOfGravityIsAmberInEveryMotion) {
  for (const double position_m : {0.5, 0.88, 0.899, 0.9}) {
    for (const char* const motion : {"straight", "six_dof"}) {
      const report::Verdict v = verdict_with(
          {fmt::format("airframe.centre_of_pressure_m={}", position_m), fmt::format("flight.motion={}", motion)});
      EXPECT_NE(v.outcome, report::Outcome::held) << position_m << " " << motion << ": " << v.text;
      EXPECT_TRUE(says(v.text, "static margin") && tells(v.text, {text::fixed((position_m - 0.9) / 0.08, 2)}))
          << position_m << " " << motion << ": " << v.text;
    }
  }
  EXPECT_EQ(verdict_with({"airframe.centre_of_pressure_m=0.901"}).outcome, report::Outcome::held);
}

TEST(OutsideModel, ARocketThatIsStableAtLiftOffAloneIsAmber) {
  const report::Verdict v = verdict_with({"airframe.centre_of_gravity_after_burnout_m=1.06"});
  EXPECT_EQ(v.outcome, report::Outcome::outside_model);
  EXPECT_TRUE(says(v.text, "static margin") && tells(v.text, {"-0.50"})) << v.text;
}

TEST(OutsideModel, WhereTheVehicleStatesNoCentresNothingIsSaidOfThem) {
  sim::Scenario unknown = launch_with({});
  unknown.vehicle.airframe.reset();
  const flight::Flight flight = fly::fly_scenario(unknown);
  EXPECT_EQ(verdict_on(flight).outcome, report::Outcome::held);
  EXPECT_FALSE(flight.extremes.static_margin_calibres);
}

// At 20 m/s, where control begins after a guide of 4 m, a wind of 3, 5 and 8 m/s comes at 8.5, 14 and 22 degrees.
TEST(OutsideModel, AirThatMeetsTheRocketAtMoreThanFifteenDegreesUnderControlIsAmber) {
  for (const std::vector<std::string>& changes : {std::vector<std::string>{"wind.speed_m_s=3"},
                                                  {"wind.speed_m_s=5"},
                                                  {"wind.speed_m_s=8", "run.tilt_limit_deg=90"},
                                                  {"wind.speed_m_s=8", "launch_guide.length_m=0.5"}}) {
    std::vector<std::string> six_dof = changes;
    six_dof.emplace_back("flight.motion=six_dof");
    const flight::Flight flight = fly::fly_scenario(launch_with(six_dof));
    const report::Verdict v = verdict_on(flight);
    const double attack_deg = largest_attack_deg(flight);
    EXPECT_EQ(v.outcome, attack_deg > 15.0 ? report::Outcome::outside_model : report::Outcome::held) << v.text;
    EXPECT_NEAR(*flight.extremes.angle_of_attack_rad * 57.29577951308232, attack_deg, 1e-6);
  }
  EXPECT_EQ(verdict_with({"wind.speed_m_s=5"}).outcome, report::Outcome::held) << "on a straight line";
  EXPECT_EQ(verdict_with({"wind.speed_m_s=8"}).outcome, report::Outcome::outside_model) << "on a straight line";
}

}  // namespace

}  // namespace fantail::sil
