// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "listen/fly_log.hpp"
#include "listen/heard.hpp"

namespace fantail::listen {

enum class Finding : std::uint8_t {
  heard,                ///< the launch was detected, and nothing before it
  late,                 ///< likewise, but more than late_s after lift-off
  imagined,             ///< a launch was detected before lift-off, or in a log without one
  imagined_and_missed,  ///< a launch was detected before lift-off, and the real one was not
  missed,               ///< lift-off, and no detection
  no_launch,            ///< neither
};

/// After it a detection is no longer that of the beginning of a flight.
inline constexpr double late_s = 1.0;
/// late_s after lift-off, or after its gap, where there is a lift-off.
[[nodiscard]] double listened_until_s(const Heard& heard);

[[nodiscard]] Finding finding(const Heard& heard);
/// "Launch detected 0.061 s after lift-off, and nothing in the 4.3 s before it."
[[nodiscard]] std::string headline(const Heard& heard);
/// That further pushes would be lift-offs, and are not judged; empty where there are none.
[[nodiscard]] std::string further_sentence(const Heard& heard);
/// The rule of lift_off.hpp, a sentence.
[[nodiscard]] std::string lift_off_rule();

/// Where two accelerometers differed, and what the law did not do for it; empty where nothing came of it.
[[nodiscard]] std::string disagreement_sentence(const Heard& heard);
/// Was the launch not detected, or late, or never controlled, while the two differed?
[[nodiscard]] bool is_refused_for_disagreement(const Heard& heard);

/// Why the finding may be wrong: columns, signs, units and clocks that do not look right.
[[nodiscard]] std::vector<std::string> doubts_of(const Heard& heard);

/// What a reader must know about the run: the log's own notes, its rate, gaps, what is fed twice, ends of ranges.
[[nodiscard]] std::vector<std::string> notes_of(const Heard& heard, const Question& question);

}  // namespace fantail::listen
