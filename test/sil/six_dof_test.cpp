// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "fly/gravity_turn.hpp"
#include "input/scenario_file.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "report/verdict_parts.hpp"
#include "seed.hpp"
#include "sil/any_rocket.hpp"
#include "sil/plain_judge.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

// The whole avionics in flights of six degrees of freedom.

flight::Flight fly(std::vector<std::string> changes) {
  return fly::fly_scenario(input::load_scenario("tasha3_launch2", input::parse_overrides(changes)));
}

flight::Flight six_dof(std::vector<std::string> changes) {
  changes.emplace_back("flight.motion=six_dof");
  return fly(std::move(changes));
}

double apogee_m(const flight::Flight& flight) { return report::figures(flight).apogee_m.value(); }

TEST(SixDegreesOfFreedom, WithoutWindAndUprightFlyAsTheStraightWorldDoes) {
  const flight::Flight straight = fly({});
  const flight::Flight rigid = six_dof({});
  ASSERT_EQ(rigid.rows.size(), straight.rows.size());
  for (std::size_t i = 0; i < straight.rows.size(); ++i) {
    const flight::Truth& a = straight.rows[i].truth.value();
    const flight::Truth& b = rigid.rows[i].truth.value();
    ASSERT_NEAR(text::degrees(a.roll_angle_rad), text::degrees(b.roll_angle_rad), 0.1) << straight.rows[i].time_s;
    ASSERT_NEAR(a.height_m, b.height_m, 0.1) << straight.rows[i].time_s;
  }
  EXPECT_EQ(rigid.events.apogee_s, straight.events.apogee_s);
}

// A rocket of no inertia keeps its axis in the flow, as a point mass does: the gravity turn of a guide that leans by 15
// degrees, computed independently, reaches 369 m and passes 60 degrees of tilt at 8.0 s.
TEST(SixDegreesOfFreedom, AStiffRocketOnALeaningGuideFliesThePointMasssGravityTurn) {
  const flight::Flight flight =
      six_dof({"launch_guide.tilt_deg=15", "airframe.centre_of_pressure_m=1.5", "airframe.parts_spread_m=0.05",
               "airframe.normal_force_slope_per_rad=100", "airframe.transverse_inertia_kg_m2=0.01",
               "airframe.transverse_inertia_after_burnout_kg_m2=0.01", "airframe.centre_of_gravity_after_burnout_m=0.9",
               "airframe.body_lift_area_m2=0"});
  EXPECT_NEAR(apogee_m(flight), 369.0, 2.0);
  EXPECT_NEAR(flight.events.control_end_s.value(), 8.0, 0.15);
  EXPECT_EQ(flight.phase_changes.back().reason, core::PhaseReason::tilted_too_far);
}

// The rocket turns into the wind and lands its apogee upwind; on the way it loses height.
TEST(SixDegreesOfFreedom, WindCarriesTheRocketIntoItself) {
  const flight::Flight calm = six_dof({});
  const flight::Flight windy = six_dof({"wind.speed_m_s=5", "wind.from_deg=270"});
  const flight::PathPoint* top = flight::point_at(windy.path, windy.events.apogee_s.value());
  ASSERT_NE(top, nullptr);
  EXPECT_LT(top->east_m, -20.0);
  EXPECT_NEAR(top->north_m, 0.0, 1.0);
  EXPECT_LT(apogee_m(windy), apogee_m(calm) - 2.0);
}

// The same wind from eight sides: the flight is the same, turned.
TEST(SixDegreesOfFreedom, NoSideIsSpecial) {
  double drift_m = 0.0;
  for (int eighth = 0; eighth < 8; ++eighth) {
    const double from_deg = 45.0 * eighth;
    const flight::Flight flight = six_dof({"wind.speed_m_s=4", "wind.from_deg=" + std::to_string(from_deg)});
    const flight::PathPoint* top = flight::point_at(flight.path, flight.events.apogee_s.value());
    const double bearing_deg = text::degrees(std::atan2(top->east_m, top->north_m));
    EXPECT_NEAR(std::remainder(bearing_deg - from_deg, 360.0), 0.0, 0.2) << from_deg;
    drift_m = eighth == 0 ? flight::distance_m(*top) : drift_m;
    EXPECT_NEAR(flight::distance_m(*top), drift_m, 0.01) << from_deg;
  }
}

TEST(SixDegreesOfFreedom, ARailHoldsTheRollUntilTheRocketLeavesIt) {
  const flight::Flight tower = six_dof({"disturbance.angles_deg=[-40]"});
  const flight::Flight rail = six_dof({"disturbance.angles_deg=[-40]", "launch_guide.roll=held"});
  const auto roll_deg = [](const flight::Flight& flight, double time_s) {
    const auto row = std::ranges::lower_bound(flight.rows, time_s, {}, &flight::Row::time_s);
    return text::degrees(row->truth.value().roll_angle_rad);
  };
  EXPECT_EQ(roll_deg(rail, rail.events.guide_clear_s.value() - 0.002), 0.0);
  EXPECT_LT(roll_deg(tower, tower.events.control_start_s.value()), -10.0);
  EXPECT_GT(roll_deg(rail, rail.events.control_start_s.value()),
            0.5 * roll_deg(tower, tower.events.control_start_s.value()));
}

TEST(SixDegreesOfFreedom, TheSameSeedGivesTheSameGusts) {
  const std::vector<std::string> gusty{"wind.speed_m_s=5", "wind.turbulence=0.2"};
  const flight::Flight a = six_dof(gusty);
  const flight::Flight b = six_dof(gusty);
  EXPECT_EQ(a.log, b.log);
  EXPECT_EQ(flight::trajectory_csv(a.path, a.path_frame), flight::trajectory_csv(b.path, b.path_frame));
}

TEST(SixDegreesOfFreedom, AParachuteIsSeenByTheAccelerometer) {
  const flight::Flight flight =
      six_dof({"recovery.drag_area_m2=0.8", "recovery.delay_s=1", "timing.time_after_end_s=12"});
  const double apogee_s = flight.events.apogee_s.value();
  const flight::PathPoint* last = &flight.path.at(flight.path.size() - 2);  // the last is on the ground
  EXPECT_NEAR(last->up_m_s, -8.9, 0.5);  // sqrt(2 (3.99 - 0.226) g / (1.18 kg/m3 0.8 m2))
  EXPECT_NEAR(flight.events.parachute_s.value(), apogee_s + 1.0, 0.002);
  double largest_m_s2 = 0.0;
  for (const flight::Row& row : flight.rows) {
    if (row.time_s > apogee_s + 1.0) {
      largest_m_s2 = std::max(largest_m_s2, row.specific_force_m_s2);
    }
  }
  EXPECT_GT(largest_m_s2, 8.0);
  EXPECT_FALSE(six_dof({}).events.parachute_s);
}

TEST(SixDegreesOfFreedom, ARocketThatIsTooHeavyForItsMotorEndsItsFlightWithAParachuteAsWithoutOne) {
  const std::vector<std::string> changes{"flight.motion=six_dof", "recovery.drag_area_m2=0.8"};
  sim::Scenario heavy = input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
  heavy.vehicle.mass_kg *= 20.0;
  const flight::Flight with = fly::fly_scenario(heavy);
  EXPECT_FALSE(with.events.liftoff_s);
  EXPECT_FALSE(with.events.parachute_s);
}

TEST(SixDegreesOfFreedom, AParachuteThatOpensLateIsAJolt) {
  const flight::Flight flight =
      six_dof({"recovery.drag_area_m2=0.8", "recovery.delay_s=4", "timing.time_after_end_s=6"});
  const auto jolt = report::jolt_after_apogee(flight);
  ASSERT_TRUE(jolt);
  EXPECT_GE(jolt->time_s, flight.events.parachute_s.value());
  EXPECT_LE(jolt->time_s, *flight.events.parachute_s + 0.5);
  EXPECT_FALSE(report::jolt_after_apogee(six_dof({"timing.time_after_end_s=6"})));
}

// The point mass by which a leaning guide is judged where the flight is a straight line.
TEST(GravityTurn, LeavesTheGuideAtItsTrueEnd) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.guide.tilt_rad = 10.0 * sim::radians_per_degree;
  const double short_m = fly::gravity_turn(scenario).apogee_m;
  scenario.guide.length_m = 20.0;
  const double truly_long_m = fly::gravity_turn(scenario).apogee_m;
  scenario.guide.length_m.reset();
  scenario.plan.guide.length_m = 20.0F;
  EXPECT_EQ(truly_long_m, fly::gravity_turn(scenario).apogee_m);
  EXPECT_GT(truly_long_m, short_m + 1.0);
}

TEST(GravityTurn, CountsTheTiltFromWhereThePlanCountsIt) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.guide.tilt_rad = 10.0 * sim::radians_per_degree;
  const fly::GravityTurn vertical = fly::gravity_turn(scenario);
  scenario.plan.run.tilt_from = core::TiltOrigin::guide;
  const fly::GravityTurn guide = fly::gravity_turn(scenario);
  EXPECT_NEAR(guide.tilts_rad.front(), 0.0, 1e-9);
  EXPECT_NEAR(vertical.tilts_rad.at(3000) - guide.tilts_rad.at(3000), scenario.guide.tilt_rad, 1e-9);
  EXPECT_GT(guide.tilt_limit_s.value(), vertical.tilt_limit_s.value());
}

// Without wind a rocket bends over in the plane of its guide: both tilts are apart by the lean of the guide.
TEST(SixDegreesOfFreedom, KnowTheTiltFromTheGuide) {
  const flight::Flight flight = six_dof({"launch_guide.tilt_deg=8", "launch_guide.azimuth_deg=40"});
  const flight::PathPoint& late = *flight::point_at(flight.path, *flight.events.apogee_s - 2.0);
  EXPECT_NEAR(flight.path.front().tilt_from_guide_rad, 0.0, 1e-9);
  EXPECT_GT(late.tilt_from_guide_rad, 0.05);
  EXPECT_NEAR(late.tilt_rad - late.tilt_from_guide_rad, 8.0 * sim::radians_per_degree, 0.02);
}

// What the page of a held rocket shows of all three axes.

using flight::TurnPoint;

flight::Flight fly(const char* scenario) { return fly::fly_scenario(input::load_scenario(scenario, {})); }

double largest_deg(const flight::Flight& flight, double TurnPoint::* member) {
  double largest_rad = 0.0;
  for (const TurnPoint& point : flight.turning) {
    largest_rad = std::max(largest_rad, std::abs(point.*member));
  }
  return text::degrees(largest_rad);
}

// gimbal.toml: 20 degrees in roll and 45 in pitch and yaw, each within 2 s; the fastest moment is twice the mean.
TEST(Turning, OnTheGimbalIsWhatTheHandsDidAndWhatTheGyroMadeOfIt) {
  const flight::Flight flight = fly("gimbal");
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_roll_rate_rad_s), 20.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_pitch_rate_rad_s), 45.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_yaw_rate_rad_s), 45.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_tilt_rad), 45.0, 0.1);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::gyro_roll_rate_rad_s), 20.0, 2.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::gyro_pitch_rate_rad_s), 45.0, 2.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::gyro_yaw_rate_rad_s), 45.0, 2.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::tilt_rad), 45.0, 1.0);
  // The second turn in pitch brings it upright again.
  const auto upright = std::ranges::find_if(flight.turning, [](const TurnPoint& p) { return p.time_s >= 17.0; });
  EXPECT_NEAR(text::degrees(upright->true_tilt_rad), 0.0, 0.01);
}

TEST(Turning, OnPinsIsTheSwing) {
  const flight::Flight flight = fly("tunnel_stability");
  EXPECT_EQ(largest_deg(flight, &TurnPoint::true_roll_rate_rad_s), 0.0);
  EXPECT_EQ(largest_deg(flight, &TurnPoint::true_yaw_rate_rad_s), 0.0);
  EXPECT_NEAR(largest_deg(flight, &TurnPoint::true_pitch_rate_rad_s), 3.0, 0.3);  // the hardest push
}

TEST(Turning, IsNotShownOfAFlight) { EXPECT_TRUE(fly("tasha3_launch2").turning.empty()); }

// Rockets that nobody here has made, each held against a judge that knows nothing but the truth and what was asked.

int rockets() { return test::how_many("FANTAIL_FLIGHTS", 150); }

TEST(VerdictOracle, NoRocketWhateverItIsIsCalledHeldAgainstTheTruth) {
  const std::uint32_t first = test::seed();
  std::map<std::string, int> outcomes;
  int could_be_held = 0;
  for (int i = 0; i < rockets(); ++i) {
    const std::uint32_t seed = first + static_cast<std::uint32_t>(i);
    Draw draw{seed};
    sim::Scenario scenario = any_rocket(draw);
    scenario.seed = seed;
    const flight::Flight flight = fly::fly_scenario(scenario);
    const report::Figures figures = report::figures(flight);
    const report::Verdict verdict = report::verdict(flight, figures);
    const PlainTruth truth = look_plainly(flight.rows, scenario.atmosphere.elevation_m);
    const double limit_deg = text::degrees(scenario.rest_limit_rad);
    const std::string which = fmt::format("rocket of seed {} ({}): {}", seed, i, verdict.text);
    const std::vector<std::string> contradictions = not_held_because(truth, limit_deg);
    ++outcomes[std::string{report::name(verdict.outcome)}];
    could_be_held += contradictions.empty() ? 1 : 0;

    if (verdict.outcome == report::Outcome::held) {
      EXPECT_TRUE(contradictions.empty()) << fmt::format("{}", fmt::join(contradictions, ", ")) << "; " << which;
    }
    if (report::is_steady(verdict.outcome)) {
      const std::vector<std::string> restless = not_steady_because(truth);
      EXPECT_TRUE(restless.empty()) << fmt::format("{}", fmt::join(restless, ", ")) << "; " << which;
    }
    // What the truth says plainly is in the figures, and in the words.
    if (truth.controlled && figures.mean_reference_error_rad) {
      EXPECT_NEAR(text::degrees(*figures.mean_reference_error_rad), truth.mean_deg, 0.01) << which;
    }
    if (truth.top_mach > 0.802) {
      EXPECT_TRUE(flight::is_beyond(flight::ModelEnd::mach, flight.extremes) && says(verdict.text, "Mach")) << which;
      EXPECT_NEAR(std::stod(fantail::figures(verdict.text).at(0)), truth.top_mach, 0.008) << which;
    }
    if (truth.end_early_s > 0.503 && truth.turned_deg > 10.02) {
      EXPECT_EQ(verdict.outcome, report::Outcome::not_held) << truth.turned_deg << " deg after control; " << which;
    }
  }
  for (const auto& [name, count] : outcomes) {
    fmt::print("{:5} {}\n", count, name);
  }
  fmt::print("{:5} of {} might be called held by the truth alone\n", could_be_held, rockets());
  if (rockets() >= 100) {
    EXPECT_GE(outcomes["held"], rockets() / 50) << "the draw has become one-sided";
    EXPECT_GE(outcomes.size(), 6U) << "the draw has become one-sided";
  }
}

}  // namespace

}  // namespace fantail::sil
