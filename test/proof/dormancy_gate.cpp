// SPDX-License-Identifier: MIT
// From any state of the gate that one of its ticks can leave, with any plan and any motion, a later tick:
//   - leaves the gate of a plan that waits for the guide open;
//   - opens no other one before an estimate of the speed was above 15 m/s;
//   - opens one by burn-out only with a measured specific force, and when the time since first thrust, less the pauses
//     that ended in thrust again, has come to the plan's factor times its burn time; no pause is less than nothing;
//   - closes one by burn-out when a pause has ended in thrust again;
//   - opens one by height only where the height, less the error that the plan allows for, or what a barometer makes of
//     that, is above the plan's height, no tick lacked the accelerometer or had a gyro at the end of its range, and in
//     this one the accelerometers agree;
//   - opens one by dynamic pressure only where the same is so, and not at a new largest one;
//   - opens a gate by two of these only where both are so.
// The low-pass may give any number, and so may the roots in the density of the air.
#include "any_root.hpp"
#define sqrt any_root
#include "core/dormancy_gate.cpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

namespace {

/// What is true of a gate after any of its ticks, and before the first: its times are in order.
bool is_in_order(const DormancyGate& gate, Microseconds last) {
  const auto past = [last](const std::optional<Microseconds>& time) { return !time || *time <= last; };
  return gate.pauses_ >= Microseconds{0} && past(gate.coasts_since_) && past(gate.pause_since_) &&
         past(gate.thrust_since_) && !(gate.coasts_since_ && gate.thrust_since_) &&
         !(gate.pause_since_ && gate.thrust_since_ && *gate.thrust_since_ < *gate.pause_since_);
}

}  // namespace

int main() {
  DormancyPlan plan{};
  plan.until = any_of<DormantUntil>(6);
  plan.height_m = nondet_float();
  plan.burn_time = any_instant();
  plan.burn_clock_factor = nondet_float();
  plan.scale_error = nondet_float();
  plan.bias_error_m_s2 = nondet_float();

  DormancyGate gate{plan};
  CLAIM(is_in_order(gate, Microseconds{0}));
  CLAIM(gate.is_open() == (plan.until == DormantUntil::guide));
  Anything anything;
  gate.visit_state(anything);
  const Microseconds last = any_instant();
  assume(is_in_order(gate, last));

  const Microseconds now = any_instant();
  assume(now > last);
  Motion motion{};
  motion.specific_force_m_s2.x = nondet_float();
  motion.height_m = nondet_float();
  motion.horizontal_distance_m = nondet_float();
  motion.speed_m_s = nondet_float();
  motion.speed_squared_m2_s2 = nondet_float();
  motion.accelerometer = any_of<SensorState>(4);
  motion.rate_is_lower_bound = nondet_bool();
  motion.thrust_since = any_instant();

  const DormancyGate before = gate;
  const bool agree = nondet_bool();
  const std::optional<float> by_barometer = nondet_bool() ? std::optional{nondet_float()} : std::nullopt;
  gate.update(now, motion, agree, by_barometer);

  const bool by_guide = plan.until == DormantUntil::guide;
  const bool by_burn_out = plan.until == DormantUntil::burn_out || plan.until == DormantUntil::burn_out_and_height;
  const bool by_pressure =
      plan.until == DormantUntil::max_dynamic_pressure || plan.until == DormantUntil::max_dynamic_pressure_and_height;
  const bool by_height = plan.until == DormantUntil::height || plan.until == DormantUntil::burn_out_and_height ||
                         plan.until == DormantUntil::max_dynamic_pressure_and_height;
  const bool opened = gate.is_open() && !before.is_open();
  const bool moved = before.moves_ || motion.speed_m_s > 15.0F;
  const bool unsure =
      before.is_unsure_ || !agree || motion.accelerometer == SensorState::failed || motion.rate_is_lower_bound;
  const bool burnt = gate.is_burnt_out_ && !before.is_burnt_out_;
  const bool high = gate.is_past_height_ && !before.is_past_height_;
  const bool past = gate.is_past_pressure_ && !before.is_past_pressure_;
  const float fallen_m = 0.5F * seconds(now - motion.thrust_since) * seconds(now - motion.thrust_since);

  CLAIM(is_in_order(gate, now));
  CLAIM(!by_guide || (before.is_open() && gate.is_open()));
  CLAIM(!opened || (moved && (burnt || high || past)));
  CLAIM(!burnt || (moved && motion.accelerometer == SensorState::fresh &&
                   now - motion.thrust_since - gate.pauses_ >= gate.burn_clock_));
  CLAIM(gate.pauses_ == before.pauses_ || !gate.is_burnt_out_);
  const float tilt_error = 1.4143F / standard_gravity_m_s2 * plan.bias_error_m_s2;
  const float error_m = plan.scale_error * (motion.height_m + standard_gravity_m_s2 * fallen_m) +
                        plan.bias_error_m_s2 * fallen_m + tilt_error * motion.horizontal_distance_m;
  CLAIM(!high || (moved && !unsure &&
                  (motion.height_m - error_m > plan.height_m || (by_barometer && *by_barometer > plan.height_m))));
  CLAIM(!past || (moved && !unsure));
  CLAIM(by_guide || gate.largest_pressure_ <= before.largest_pressure_ || !gate.is_past_pressure_);
  CLAIM(!gate.is_open() || !by_burn_out || gate.is_burnt_out_);
  CLAIM(!gate.is_open() || !by_height || gate.is_past_height_);
  CLAIM(!gate.is_open() || !by_pressure || gate.is_past_pressure_);

  REACHABLE(1, opened && plan.until == DormantUntil::burn_out);
  REACHABLE(2, opened && plan.until == DormantUntil::height);
  REACHABLE(3, opened && plan.until == DormantUntil::max_dynamic_pressure);
  REACHABLE(4, before.is_open() && !gate.is_open() && plan.until == DormantUntil::burn_out);
  REACHABLE(5, opened && plan.until == DormantUntil::burn_out_and_height && !high);
  REACHABLE(6, high && !(motion.height_m - error_m > plan.height_m));
  return 0;
}
