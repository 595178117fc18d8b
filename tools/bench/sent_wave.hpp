// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bench/exercise.hpp"
#include "bench/trace.hpp"

namespace fantail::bench {

/// What the avionics commanded in a sine, held against the sine that was asked for.
struct SentWave {
  std::vector<double> asked_rad{};     ///< within the limit, a value for each of the trace, where it fits best
  double difference = 0.0;             ///< root mean square of command - asked, over that of the wave
  std::size_t longest_standstill = 0;  ///< of the command within the sine, in ticks
};
/// Empty when the trace has no sine, or the limit leaves nothing of it.
[[nodiscard]] std::optional<SentWave> sent_wave(const CanardTrace& trace, const Exercise& exercise, std::size_t canard);

/// The largest difference with which what was commanded still is the sine asked for.
[[nodiscard]] double most_difference(double frequency_hz);

}  // namespace fantail::bench
