// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/gyro_gate.hpp"
#include "core/gyro_pair.hpp"
#include "core/inputs.hpp"
#include "core/vector3.hpp"
#include "proof.hpp"

namespace fantail::core {

/// As the real one; any_motion_is_the_real_one in CMakeLists.txt compares the two.
struct Motion {
  Angle roll_angle;              ///< zero at launch detection (tunnel: at control start); not wrapped
  float roll_rate_rad_s = 0.0F;  ///< gyro bias taken off
  Vector3 gyro_bias_rad_s;       ///< what is taken off
  Vector3 specific_force_m_s2;   ///< the sample that was integrated
  float height_m = 0.0F;         ///< above the place of lift-off, as far as `height_origin` lets it be known
  float horizontal_distance_m = 0.0F;
  float distance_along_guide_m = 0.0F;
  float speed_m_s = 0.0F;           ///< along the guide
  float vertical_speed_m_s = 0.0F;  ///< earth frame, positive up
  float speed_squared_m2_s2 = 0.0F;
  Angle tilt;  ///< of the rocket's axis from the vertical
  std::optional<Angle> tilt_from_guide;
  SensorState gyro = SensorState::failed;
  SensorState accelerometer = SensorState::failed;
  /// The gyro stood at the end of its range: the rocket turns faster than this, in this sense.
  bool rate_is_lower_bound = false;
  /// Since its zero the roll angle has gone through rates that nobody measured: a gap longer than the plan's stale
  /// time, or a gyro at the end of its range.
  bool roll_is_bridged = false;
  /// Since lift-off an accelerometer stood at the end of its range while no other measured: height and speed are at
  /// least these.
  bool speed_is_lower_bound = false;
  Microseconds at_rest_for{};
  bool has_moved = false;
  bool has_fallen = false;
  /// Start of the integrated window: where the specific force left the pad's 1 g.
  Microseconds thrust_since{};
};

/// In the place of the estimator, which uses Eigen, and which the prover cannot read: any motion at all, in every tick.
class MotionEstimator {
 public:
  explicit MotionEstimator(const MotionPlan&, const SensorsPlan&, TiltOrigin) {}
  void update(const Inputs&) {}
  void begin_flight(Microseconds) {}
  void leave_guide() {}
  void begin_tunnel_run(Microseconds) {}
  void return_to_pad() {}
  void bridge(const Inputs&) {}
  [[nodiscard]] Motion motion(Microseconds) const {
    Motion motion{};
    motion.roll_angle = proof::any_angle();
    motion.roll_rate_rad_s = nondet_float();
    motion.distance_along_guide_m = nondet_float();
    motion.speed_m_s = nondet_float();
    motion.vertical_speed_m_s = nondet_float();
    motion.tilt = proof::any_angle();
    motion.tilt_from_guide = proof::any_optional_angle();
    motion.gyro = proof::any_of<SensorState>(sensor_states);
    motion.rate_is_lower_bound = nondet_bool();
    motion.speed_is_lower_bound = nondet_bool();
    motion.at_rest_for = proof::any_instant();
    motion.has_moved = nondet_bool();
    motion.has_fallen = nondet_bool();
    return motion;
  }
  void motion(Microseconds now, Motion& made) const { made = motion(now); }
  [[nodiscard]] bool votes() const { return nondet_bool(); }
  [[nodiscard]] GyroVote gyro_vote() const { return proof::any_of<GyroVote>(gyro_votes); }
  [[nodiscard]] const void* end_of_flight_memory() const { return this + 1; }
};

}  // namespace fantail::core
