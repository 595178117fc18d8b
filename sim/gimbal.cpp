// SPDX-License-Identifier: MIT
#include "sim/gimbal.hpp"

#include <numbers>

namespace fantail::sim {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

struct Turning {
  Vector3 rate_rad_s;
  Vector3 acceleration_rad_s2;
};

// The mean of 1 - cos is one, so that the whole turn has its angle.
Turning turning(const HandTurn& hands, double time_s) {
  const double share = (time_s - hands.time_s) / hands.duration_s;
  if (share <= 0.0 || share >= 1.0) {
    return {};
  }
  const auto [sine, cosine] = sine_cosine(turn * share);
  const double pace = 1.0 / hands.duration_s;
  return {.rate_rad_s = pace * (1.0 - cosine) * hands.angle_rad,
          .acceleration_rad_s2 = pace * pace * turn * sine * hands.angle_rad};
}

}  // namespace

void Gimbal::step(double time_s, double dt_s) {
  while (!to_come_.empty() && time_s - dt_s >= to_come_.front().time_s + to_come_.front().duration_s) {
    to_come_ = to_come_.subspan(1);
  }
  if (to_come_.empty()) {
    rate_rad_s_ = {};
    acceleration_rad_s2_ = {};
    return;
  }
  const Vector3 middle_rad_s = turning(to_come_.front(), time_s - 0.5 * dt_s).rate_rad_s;
  attitude_ = renormalized(attitude_ * small_rotation(dt_s * middle_rad_s));
  roll_angle_rad_ += dt_s * middle_rad_s.x;
  const Turning end = turning(to_come_.front(), time_s);
  rate_rad_s_ = end.rate_rad_s;
  acceleration_rad_s2_ = end.acceleration_rad_s2;
}

BodyMotion Gimbal::motion() const {
  return {.specific_force_m_s2 = rotated_back(attitude_, {.x = gravity_m_s2, .y = 0.0, .z = 0.0}),
          .rate_rad_s = rate_rad_s_,
          .angular_acceleration_rad_s2 = acceleration_rad_s2_};
}

}  // namespace fantail::sim
