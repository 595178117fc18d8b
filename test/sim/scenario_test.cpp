// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "flown_world.hpp"

namespace fantail::sim {
namespace {

// Whatever a scenario may say, the run ends, and no truth is ever infinite or no number.
RC_GTEST_PROP(Scenario, AtTheEndsOfItsRangesFliesToAnEndWithFiniteNumbers, ()) {
  struct Corner {
    const char* key;
    std::vector<const char*> values;
  };
  static const std::vector<Corner> corners{
      {"body.mass_kg", {"0.4", "1000"}},
      {"body.drag_area_m2", {"0", "1"}},
      {"body.roll_inertia_kg_m2", {"1e-6", "0.9"}},
      {"aerodynamics.reference_area_m2", {"1e-8", "1"}},
      {"aerodynamics.damping_m2", {"0", "1e4"}},
      {"aerodynamics.torque_m", {"0", "1e4"}},
      {"aerodynamics.canard_stall_deg", {"5", "30"}},
      {"aerodynamics.canard_wash", {"0.3", "2"}},
      {"aerodynamics.canard_wash_distance_m", {"0", "30"}},
      {"aerodynamics.canard_hinge_moment_m3", {"-0.01", "0.01"}},
      {"servo.torque_n_m", {"0.005", "100"}},
      {"aerodynamics.compressibility", {"prandtl_glauert"}},
      {"environment.density", {"exponential", "isa", "constant"}},
      {"environment.density_kg_m3", {"0.01", "5"}},
      {"launch_guide.tilt_deg", {"0", "15"}},
      {"servo.lag_s", {"0.0005", "1"}},
      {"servo.delay_s", {"0", "0.05"}},
      {"servo.frame_rate_hz", {"40", "1000"}},
      {"servo.rate_limit_deg_s", {"1", "1e5"}},
      {"servo.stop_deg", {"1", "90"}},
      {"servo.backlash_deg", {"0", "5"}},
      {"servo.spread", {"0", "0.3"}},
      {"servo.centre_spread_deg", {"0", "1"}},
      {"servo.pulse_per_degree_us", {"-40", "-0.1", "0.1", "40"}},
      {"imu.full_scale_deg_s", {"50", "4000"}},
      {"imu.rate_noise_deg_s", {"0", "100"}},
      {"imu.full_scale_g", {"2", "400"}},
      {"imu.delay_s", {"0", "0.02"}},
      {"imu.misalignment_deg", {"0", "10"}},
      {"accelerometer.specific_force_noise_m_s2", {"0", "50"}},
      {"encoder.noise_counts", {"0", "1000"}},
      {"controller.proportional_gain", {"0", "10"}},
      {"controller.derivative_gain_s", {"0", "2"}},
      {"disturbance.angles_deg", {"[-45]", "[45]"}},
  };
  std::vector<std::string> changes{"aerodynamics.reference_area_range_m2=[]"};  // it holds for the file's area
  for (const Corner& corner : corners) {
    const auto pick = *rc::gen::inRange<std::size_t>(0, 2 * corner.values.size());
    if (pick < corner.values.size()) {
      changes.push_back(std::string{corner.key} + "=" + corner.values[pick]);
    }
  }
  const FlownWorld flown = fly("tasha3_launch2", changes);
  for (const Tick& tick : flown.ticks) {
    RC_ASSERT(std::isfinite(tick.truth.roll_angle_rad) && std::isfinite(tick.truth.roll_rate_rad_s));
    RC_ASSERT(std::isfinite(tick.truth.speed_m_s) && std::isfinite(tick.truth.height_m));
    RC_ASSERT(std::isfinite(tick.truth.canard_rad) && std::isfinite(tick.record.command.radians()));
  }
}

}  // namespace
}  // namespace fantail::sim
