// SPDX-License-Identifier: MIT
#include "sim/gimbal.hpp"

#include <algorithm>
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

/// Euler's equations of a body that is alike about every axis across its long one.
Vector3 free_acceleration_rad_s2(const FreeTurning& body, const Vector3& rate_rad_s) {
  const double drag_n_m_s = body.friction_n_m / length(rate_rad_s);
  const double gyroscopic = rate_rad_s.x * (1.0 - body.roll_inertia_kg_m2 / body.transverse_inertia_kg_m2);
  const double across_s = drag_n_m_s / body.transverse_inertia_kg_m2;
  return {.x = -drag_n_m_s / body.roll_inertia_kg_m2 * rate_rad_s.x,
          .y = gyroscopic * rate_rad_s.z - across_s * rate_rad_s.y,
          .z = -gyroscopic * rate_rad_s.y - across_s * rate_rad_s.z};
}

}  // namespace

void Gimbal::step(double time_s, double dt_s) {
  const double held_share = free_ ? 0.5 : 1.0;
  while (!to_come_.empty() && time_s - dt_s >= to_come_.front().time_s + held_share * to_come_.front().duration_s) {
    to_come_ = to_come_.subspan(1);
  }
  if (!to_come_.empty() && time_s > to_come_.front().time_s) {
    turn_by_hand(to_come_.front(), time_s, dt_s);
  } else if (free_) {
    turn_freely(dt_s);
  } else {
    rate_rad_s_ = {};
    acceleration_rad_s2_ = {};
  }
}

void Gimbal::turn_by_hand(const HandTurn& hands, double time_s, double dt_s) {
  turn_on(turning(hands, time_s - 0.5 * dt_s).rate_rad_s, dt_s);
  const Turning end = turning(hands, time_s);
  rate_rad_s_ = end.rate_rad_s;
  acceleration_rad_s2_ = end.acceleration_rad_s2;
}

void Gimbal::turn_freely(double dt_s) {
  // In less than a step friction would turn the rate of the lightest axis round: the bearings hold the rocket.
  if (length(rate_rad_s_) <=
      dt_s * free_->friction_n_m / std::min(free_->roll_inertia_kg_m2, free_->transverse_inertia_kg_m2)) {
    rate_rad_s_ = {};
    acceleration_rad_s2_ = {};
    return;
  }
  const Vector3 middle_rad_s = rate_rad_s_ + 0.5 * dt_s * free_acceleration_rad_s2(*free_, rate_rad_s_);
  turn_on(middle_rad_s, dt_s);
  acceleration_rad_s2_ = free_acceleration_rad_s2(*free_, middle_rad_s);
  rate_rad_s_ = rate_rad_s_ + dt_s * acceleration_rad_s2_;
}

void Gimbal::turn_on(const Vector3& middle_rad_s, double dt_s) {
  attitude_ = renormalized(attitude_ * small_rotation(dt_s * middle_rad_s));
  roll_angle_rad_ += dt_s * middle_rad_s.x;
}

BodyMotion Gimbal::motion() const {
  return {.specific_force_m_s2 = rotated_back(attitude_, {.x = gravity_m_s2, .y = 0.0, .z = 0.0}),
          .rate_rad_s = rate_rad_s_,
          .angular_acceleration_rad_s2 = acceleration_rad_s2_};
}

}  // namespace fantail::sim
