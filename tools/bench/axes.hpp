// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "link/avionics_link.hpp"
#include "link/place.hpp"

// A person turns the rocket as told, one axis after the other. Of all rates the bus reports that of the roll alone, and
// no specific force: so this tells whether the gyro's roll axis is the rocket's, and nothing of the other axes.
namespace fantail::bench {

/// What is asked of the person, and by which angle that turns the rocket. The roll is a whole turn, because a mark that
/// comes round again is met to a degree or two, and an angle by eye is not.
struct AskedTurn {
  std::string_view axis;  ///< "roll"
  std::string_view instruction;
  double angle_rad;
};
[[nodiscard]] const std::array<AskedTurn, 3>& asked_turns();

/// Integral of the reported roll rate over each of the turns.
using RollSeen = std::array<double, 3>;

/// The rocket was not turned within a minute, or did not come to rest again.
class NotTurned : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Each turn lasts from rest to rest, as the avionics reports it; it may be made at any pace below the gyro's range.
/// `tell` is given each of the turns as it is due. Throws NotTurned, link::LinkError when the avionics falls silent.
[[nodiscard]] RollSeen watch_turns(link::Place& place, link::AvionicsLink& link,
                                   const std::function<void(const AskedTurn&)>& tell);

struct AxesResult {
  RollSeen seen_rad{};
  bool right = false;
  std::vector<std::string> sentences{};  ///< what is wrong; or that the roll axis is right
};
[[nodiscard]] AxesResult judge_axes(const RollSeen& seen_rad);

[[nodiscard]] std::string axes_text(const AxesResult& result);
[[nodiscard]] std::string axes_json(const AxesResult& result);

/// What stays unchecked, a sentence.
[[nodiscard]] std::string_view what_the_bus_does_not_report();

}  // namespace fantail::bench
