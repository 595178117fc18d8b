// SPDX-License-Identifier: MIT

#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "degree.hpp"
#include "sim/roll_plant.hpp"
#include "sim/servo.hpp"
#include "test.hpp"

// The whole loop, as a reader would draw it: the flight law of the board, one servo and the roll of a rocket in a
// tunnel.
namespace fantail::sim {
namespace {

using core::Microseconds;

constexpr double density_kg_m3 = 1.2;
constexpr double speed_m_s = 22.0;
constexpr RollPlant rocket{
    .inertia_kg_m2 = 0.00393, .reference_area_m2 = 5.0265e-5, .damping_m2 = 19.4, .torque_m = 9.6};

core::FlightPlan held_in_the_tunnel(float limit_deg) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  plan.run.control_time = Microseconds{60'000'000};
  plan.reference.kind = core::ReferenceKind::hold;
  plan.reference.initial = core::Angle::from_degrees(45.0F);
  plan.excitation.form = core::ExcitationForm::none;
  plan.controller.proportional_gain = 0.5F;
  plan.controller.derivative_gain_s = 0.05F;
  plan.controller.canard_limit = core::Angle::from_degrees(limit_deg);
  return plan;
}

// Armed after four seconds at rest, started after five.
core::Inputs measured(Microseconds time, const RollState& roll, const Servo& servo) {
  core::Inputs inputs{.time = time, .arm_switch_closed = true};
  inputs.gyro = {time, {static_cast<float>(roll.rate_rad_s), 0.0F, 0.0F}, core::SampleQuality::valid};
  inputs.accelerometers.fill({time, {core::standard_gravity_m_s2, 0.0F, 0.0F}, core::SampleQuality::valid});
  inputs.encoders.fill(core::Angle::from_radians(static_cast<float>(servo.angle_rad())));
  inputs.arm_command = time == Microseconds{4'000'000};
  inputs.start_command = time == Microseconds{5'000'000};
  return inputs;
}

RollState after_30_s(float limit_deg, double disturbance_rad) {
  core::Autopilot autopilot{held_in_the_tunnel(limit_deg)};
  Servo servo{ServoParameters{}};
  RollState roll;
  for (Microseconds time{}; time < Microseconds{35'000'000}; time += Microseconds{1'000}) {
    const core::TickRecord& record = autopilot.step(measured(time, roll, servo));
    servo.step(1e-6 * static_cast<double>(time.count()), 1e-3, record.canards[0].pulse_us);
    if (record.phase == core::Phase::controlling) {
      roll = rocket.step(roll, density_kg_m3, speed_m_s, servo.mean_angle_rad() + disturbance_rad, 1e-3);
    }
  }
  return roll;
}

TEST(ClosedLoop, SettlesAtTheReferencePlusTheDisturbanceOverTheProportionalGain) {
  for (const double disturbance_deg : {-6.1, 0.0, 3.0}) {
    const RollState roll = after_30_s(9.0F, disturbance_deg * degree);
    // Half of the servo's play of 0.1 degrees moves the end by twice as much.
    EXPECT_NEAR(roll.angle_rad / degree, 45.0 + disturbance_deg / 0.5, 0.11) << disturbance_deg;
    EXPECT_NEAR(roll.rate_rad_s / degree, 0.0, 1.0) << disturbance_deg;
  }
}

TEST(ClosedLoop, RollsOnWhereTheDisturbanceIsLargerThanTheCanardLimit) {
  // Equation 27 with what the canards leave of the disturbance: p = beta v (u + u_d) / alpha.
  const double left_rad = (6.0 - 8.0) * degree;
  EXPECT_NEAR(after_30_s(6.0F, -8.0 * degree).rate_rad_s, 9.6 * speed_m_s * left_rad / 19.4, 0.02);
}

}  // namespace
}  // namespace fantail::sim
