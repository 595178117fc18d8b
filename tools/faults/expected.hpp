// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace fantail::faults {

/// What a rocket with a fault may come to. Each is looked for in the truth of the flight.
enum class Outcome : std::uint8_t {
  not_armed = 1U << 0U,   ///< stays in Safe
  no_control = 1U << 1U,  ///< never in Controlling
  holds =
      1U << 2U,  ///< control as long as without the fault, and the roll angle within `within_deg` of it all the time
  recovers = 1U << 3U,  ///< likewise, but from `settle_s` after the fault on; until then within `meanwhile_deg`
  goes_on = 1U << 4U,   ///< likewise, within `meanwhile_deg` all the time
  over = 1U << 5U,      ///< every canard commanded to trim `trim_s` after the fault began, from there on for good
  anything = 1U << 6U,  ///< nothing can be done by the avionics: only what holds for every flight is asked
};
inline constexpr unsigned outcomes = 7;

/// What is safe in one cell, stated before anything is flown.
struct Expected {
  unsigned allowed = 0;  ///< any of these, as bits of Outcome; 0: the fault does not exist in this phase
  double within_deg = 10.0;
  double settle_s = 1.5;
  double meanwhile_deg = 60.0;
  double trim_s = 0.3;

  [[nodiscard]] constexpr bool allows(Outcome outcome) const { return (allowed & static_cast<unsigned>(outcome)) != 0; }
  [[nodiscard]] constexpr bool applies() const { return allowed != 0; }
};

[[nodiscard]] constexpr Expected any_of(auto... each) { return {.allowed = (static_cast<unsigned>(each) | ...)}; }

/// "not armed, or no control". Of one that does not apply: "not applicable".
[[nodiscard]] std::string sentence(const Expected& expected);

/// For files: "over".
[[nodiscard]] const char* name(Outcome outcome);

}  // namespace fantail::faults
