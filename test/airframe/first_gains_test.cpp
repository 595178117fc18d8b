// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "airframe/model/build_up.hpp"
#include "airframe/new_rocket.hpp"
#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "sim/units.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

TEST(FirstGains, SayTheMarginThatTheyHaveAndWhereNoGainsHaveOne) {
  const sim::Vehicle vehicle =
      input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, "tasha3_launch2").string()));
  const model::BuildUp computed = model::build_up(vehicle);
  const core::FlightPlan plan = core::default_plan();
  const auto found = first_gains(vehicle, computed, plan, 0.0);
  ASSERT_TRUE(found && found->reach_phase_margin);
  const std::vector<std::string> said = figures(sentence(*found));
  for (const std::string& number :
       {std::string{"30"}, text::fixed(found->lowest_speed_m_s, 0), text::fixed(found->highest_speed_m_s, 0)}) {
    EXPECT_NE(std::ranges::find(said, number), said.end()) << number << ": " << sentence(*found);
  }
  // 6 m from the foot of the guide at about 40 m/s2.
  EXPECT_NEAR(found->begin_speed_m_s, std::sqrt(2.0 * 6.0 * 31.0), 2.5);
  EXPECT_EQ(found->lowest_speed_m_s, std::min(found->begin_speed_m_s, 20.0)) << "it goes on to apogee";
  EXPECT_NEAR(found->highest_speed_m_s, 82.2, 0.5);

  const double offset_rad = 4.0 * sim::radians_per_degree;
  ASSERT_GT(offset_rad / found->gains.proportional, 2.0 * sim::radians_per_degree) << "else no observer is needed";
  const auto observing = first_gains(vehicle, computed, plan, -offset_rad);
  ASSERT_TRUE(observing && observing->observer_bandwidth_rad_s);
  EXPECT_EQ(figures(sentence(*observing)).back(),
            text::fixed(offset_rad / observing->gains.proportional / sim::radians_per_degree, 0))
      << sentence(*observing);
  EXPECT_LT(observing->gains.proportional, found->gains.proportional);

  model::BuildUp sail = computed;
  sail.roll_torque_m3 = model::Estimate{.value = 1.0, .low = 0.0, .high = 2.0};
  const auto none = first_gains(vehicle, sail, plan, 0.0);
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->reach_phase_margin);
  EXPECT_EQ(none->gains.derivative_s, gains_of(plan).derivative_s);
  const std::vector<std::string> said_of_none = figures(sentence(*none));
  EXPECT_NE(std::ranges::find(said_of_none, "30"), said_of_none.end()) << sentence(*none);

  // A cough that lets it hop on the pad, half a second before the motor burns: the same flight.
  sim::Vehicle coughing = vehicle;
  std::vector<sim::ThrustPoint> points{{0.0, 0.0}, {0.02, 60.0}, {0.04, 0.0}, {0.5, 0.0}};
  for (const sim::ThrustPoint& point : vehicle.motor.points()) {
    points.push_back({point.time_s + 0.501, point.thrust_n});
  }
  coughing.motor = sim::ThrustCurve{points, vehicle.motor.propellant_kg()};
  const auto later = first_gains(coughing, computed, plan, 0.0);
  ASSERT_TRUE(later);
  EXPECT_NEAR(later->highest_speed_m_s, 82.2, 0.5);

  // A tenth of the thrust does not lift it.
  sim::Vehicle heavy = vehicle;
  heavy.mass_kg *= 10.0;
  EXPECT_FALSE(first_gains(heavy, computed, plan, 0.0));
  EXPECT_EQ(figures(why_none(plan)), (std::vector<std::string>{"2.5", "0.1", "10", "6"})) << why_none(plan);

  model::BuildUp without = computed;
  without.roll_torque_m3.reset();
  EXPECT_FALSE(first_gains(vehicle, without, plan, 0.0));
}

/// The damped linear roll equation itself, step by step, with the gains at one steady speed: how long it takes from a
/// radian to a tenth of one.
double return_s(const sim::Vehicle& vehicle, double speed_m_s, double proportional, double derivative_s) {
  constexpr double density_kg_m3 = 1.2;
  const sim::RollPlant& plant = vehicle.roll_plant;
  const double pressure = 0.5 * density_kg_m3 * speed_m_s * plant.reference_area_m2 / plant.inertia_kg_m2;
  double angle_rad = 1.0;
  double rate_rad_s = 0.0;
  double time_s = 0.0;
  constexpr double step_s = 1e-4;
  while (angle_rad > 0.1 && time_s < 600.0) {
    const double command_rad = -proportional * angle_rad - derivative_s * rate_rad_s;
    rate_rad_s += step_s * pressure * (-plant.damping_m2 * rate_rad_s + speed_m_s * plant.torque_m * command_rad);
    angle_rad += step_s * rate_rad_s;
    time_s += step_s;
  }
  return time_s;
}

TEST(FirstGains, OfARocketWithFarApartSpeedsAreScheduledWhereThatBringsTheRollBackFasterAtTheSlowest) {
  sim::Vehicle vehicle =
      input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, "tasha3_launch2").string()));
  vehicle.mass_kg *= 0.45;  // twice as fast, and control begins as early
  const model::BuildUp computed = model::build_up(vehicle);
  vehicle.roll_plant.damping_m2 = computed.roll_damping_m4.value / vehicle.roll_plant.reference_area_m2;
  vehicle.roll_plant.torque_m = computed.roll_torque_m3->value / vehicle.roll_plant.reference_area_m2;
  const auto found = first_gains(vehicle, computed, core::default_plan(), 0.0);
  ASSERT_TRUE(found && found->reach_phase_margin);
  ASSERT_GT(found->highest_speed_m_s, 3.0 * found->lowest_speed_m_s);
  ASSERT_GT(found->schedule.speeds_count, 0);
  const auto factor = static_cast<double>(found->schedule.factors.front());
  EXPECT_FLOAT_EQ(found->schedule.factors[found->schedule.factors_count - 1U], 1.0F);
  EXPECT_NEAR(static_cast<double>(found->schedule.speeds_m_s.front()), found->lowest_speed_m_s, 0.1);
  const stability::Gains& gains = found->gains;
  const double scheduled_s =
      return_s(vehicle, found->lowest_speed_m_s, factor * gains.proportional, factor * gains.derivative_s);
  EXPECT_LT(1.4 * scheduled_s, return_s(vehicle, found->lowest_speed_m_s, gains.proportional, gains.derivative_s));
  EXPECT_NE(sentence(*found).find("falling to 1"), std::string::npos) << sentence(*found);
  EXPECT_NE(plan_file(found, core::default_plan()).find("[gain_schedule]"), std::string::npos);
}

}  // namespace
}  // namespace fantail::airframe
