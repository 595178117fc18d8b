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
  EXPECT_NEAR(found->lowest_speed_m_s, std::sqrt(2.0 * 6.0 * 31.0), 2.5);
  EXPECT_NEAR(found->highest_speed_m_s, 82.2, 0.5);

  const double twice_the_limit_rad = 20.0 * sim::radians_per_degree * found->gains.proportional;
  const auto observing = first_gains(vehicle, computed, plan, -twice_the_limit_rad);
  ASSERT_TRUE(observing && observing->observer_bandwidth_rad_s);
  EXPECT_EQ(figures(sentence(*observing)).back(),
            text::fixed(twice_the_limit_rad / observing->gains.proportional / sim::radians_per_degree, 0))
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

}  // namespace
}  // namespace fantail::airframe
