// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"

namespace fantail::tool {

/// The commands of a flight that was flown beside those that another plan would have given on the same inputs.
struct WhatIf {
  std::string log;
  std::string clock;                 ///< what its times count from: "lift-off"
  std::vector<std::string> changes;  ///< "controller.canard_limit_deg=9"
  std::vector<double> time_s;        ///< of the ticks that were replayed, on the flown flight's clock
  std::vector<double> flown_rad;     ///< roll commands
  std::vector<double> what_if_rad;
  std::vector<double> offset_estimate_rad;  ///< of the other plan's law
  std::vector<double> roll_angle_rad;       ///< of the flown flight, as the other plan's law would have known it
  std::vector<core::Phase> flown_phase;
  std::vector<core::Phase> what_if_phase;

  std::size_t differing = 0;  ///< ticks with another roll command or phase
  std::optional<double> first_difference_s;
  double largest_difference_rad = 0.0;
  double largest_difference_s = 0.0;
  double flown_saturated = 0.0;  ///< share of the ticks under control
  double what_if_saturated = 0.0;
  std::size_t unreachable = 0;
  bool rejects_offset = false;  ///< the other plan, by integral action or an observer
};

/// Replays with both plans. The flight has a plan, and neither replay meets an obstacle.
[[nodiscard]] WhatIf what_if(const flight_log::Flight& flight, const flight_log::Regeneration& flown,
                             const flight_log::Regeneration& changed);

[[nodiscard]] std::string what_if_text(const WhatIf& result);
[[nodiscard]] std::string what_if_csv(const WhatIf& result);
[[nodiscard]] std::string what_if_html(const WhatIf& result);

/// What must stand beside every figure of it.
inline constexpr const char* open_loop_sentence =
    "Open loop: the recorded sensor readings do not respond to these commands. The commands are right for the first "
    "moments after they begin to differ. Later ones show what the flight law would have commanded, not how the rocket "
    "would have rolled.";

/// And beside those of a plan that rejects the offset.
inline constexpr const char* winding_sentence =
    "The changed plan rejects the offset. Commands in a replay do not move the rocket, so an integral or an observer "
    "gets no response to its commands. Its estimate of the offset may grow up to the plan limit.";

}  // namespace fantail::tool
