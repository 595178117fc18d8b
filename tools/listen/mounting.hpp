// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "listen/imu_log.hpp"
#include "sim/rotation.hpp"

namespace fantail::listen {

/// How a logger sits in the rocket.
struct Mounting {
  std::string words{};          ///< as it was said
  sim::Quaternion to_rocket{};  ///< a vector in the logger's axes becomes one in the rocket's
  bool turns_axis = false;      ///< not about x alone
  bool by_pad = false;          ///< the rotation is not known yet
};

/// The word for: the force that the logger reads at rest points to the nose. Which way it is turned about the axis of
/// the rocket stays unknown, and with it which of its sides is y.
inline constexpr std::string_view mounting_by_pad = "pad";

/// mounting_by_pad, or "45 about x" or "90 about z, 10 about x": from the rocket's own axes the logger was turned by
/// each of these angles, in degrees, about an axis of the rocket, right-handed, in this order. Throws text::Error
/// (bad_configuration) for anything else, and beyond 360 degrees either way.
[[nodiscard]] Mounting parse_mounting(std::string_view text);

/// Puts specific force and rates into the rocket's axes. Of samples that were not taken at one time only those count
/// that all three axes have. Throws text::Error (bad_data) where a component that the rotation needs is not in the log,
/// and for a mounting by the pad of a log without 0.2 s of 0.8 to 1.2 g before its first push. `axial_is_from_rest`:
/// then a rotation about y or z is refused, since what was taken off on the pad is not known.
void turn_into_rocket(ImuLog& log, Mounting mounting, bool axial_is_from_rest);

}  // namespace fantail::listen
