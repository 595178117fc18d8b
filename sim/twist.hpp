// SPDX-License-Identifier: MIT
#pragma once

#include "sim/rotation.hpp"

namespace fantail::sim {

/// How far a frame is turned about its x axis, relative to the earth: the angle by which it would have to be turned
/// about that axis before it is tilted the shortest way, about a horizontal axis, from upright to where it points
/// (swing and twist). This is what a camera on the rocket sees. Not wrapped; zero where it is first looked at.
///
/// The roll angle is another: the integral of the roll rate of the body. Both are the same while the axis swings to and
/// fro in a plane. Where it goes around, they come apart by the area that it encloses on the unit sphere: on a cone of
/// half-angle theta, f times a second, by 2 pi f (1 - cos theta); 2.74 deg/s at 5 deg and 2 Hz. Nose down it is
/// undefined.
class Twist {
 public:
  /// `upright` stands so that x points up. From the frame to the earth, as the next.
  Twist(const Quaternion& upright, const Quaternion& attitude)
      : to_upright_{.w = upright.w, .x = -upright.x, .y = -upright.y, .z = -upright.z},
        wrapped_rad_{wrapped_rad(attitude)} {}

  /// Each step: a turn of less than half a turn.
  void follow(const Quaternion& attitude);

  [[nodiscard]] double rad() const { return rad_; }

 private:
  [[nodiscard]] double wrapped_rad(const Quaternion& attitude) const;

  Quaternion to_upright_;
  double wrapped_rad_;
  double rad_ = 0.0;
};

}  // namespace fantail::sim
