// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "link/avionics_link.hpp"
#include "link/place.hpp"
#include "sim/rotation.hpp"

// A person turns the rocket as told. The roll is held against the turn that was asked for, the two tilts against
// gravity: a gyro and an accelerometer that see the same tilt otherwise have an axis, a sense or a scale that is wrong.
namespace fantail::bench {

inline constexpr std::size_t accelerometer_count = 2;  ///< of the IMU, and the second one

struct AskedTurn {
  std::string_view name;  ///< "roll"
  std::string_view instruction;
};

/// Roll once around; lay down; stand up again; lay down across.
inline constexpr std::size_t turn_count = 4;
[[nodiscard]] const std::array<AskedTurn, turn_count>& asked_turns();

/// Means over a second in which the rocket lay still; empty: of that sensor came no valid report.
using ForcesAtRest = std::array<std::optional<sim::Vector3>, accelerometer_count>;

struct TurnSeen {
  ForcesAtRest before_m_s2{};
  ForcesAtRest after_m_s2{};
  sim::Vector3 angle_rad{};  ///< integral of the rates, less what the gyro read at rest
  sim::Quaternion turned{};  ///< by the same rates: from the body after the turn to the body before it
};
using TurnsSeen = std::array<TurnSeen, turn_count>;

/// Nobody turned the rocket for a minute, or it did not come to rest again, or its rates were not all heard. what()
/// says it.
class NotTurned : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Each turn lasts from rest to rest, as the avionics reports it. `tell` is given each of the turns as it is due.
/// Throws NotTurned, link::LinkError when the avionics falls silent.
[[nodiscard]] TurnsSeen watch_turns(link::Place& place, link::AvionicsLink& link,
                                    const std::function<void(const AskedTurn&)>& tell);

}  // namespace fantail::bench
