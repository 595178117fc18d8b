// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "listen/fly_log.hpp"
#include "listen/heard.hpp"

namespace fantail::listen {

enum class Finding : std::uint8_t {
  heard,      ///< the launch was detected, and nothing before it
  imagined,   ///< a launch was detected before lift-off, or in a log without one
  missed,     ///< lift-off, and no detection
  no_launch,  ///< neither
};

[[nodiscard]] Finding finding(const Heard& heard);
/// "Launch detected 0.061 s after lift-off, and nothing before it."
[[nodiscard]] std::string headline(const Heard& heard);

/// What a reader must know of how it was flown: the log's own notes, its rate, gaps, what is fed twice, ends of ranges.
[[nodiscard]] std::vector<std::string> notes_of(const Heard& heard, const Question& question);

}  // namespace fantail::listen
