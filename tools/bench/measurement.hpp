// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bench/exercise.hpp"
#include "bench/trace.hpp"
#include "link/avionics_link.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::bench {

/// What one canard showed in one turn. Empty: could not be measured, or this exercise does not show it. Times come from
/// the tick numbers.
struct Figures {
  std::size_t received_ticks = 0;
  std::size_t dropouts = 0;  ///< ticks without a valid reading
  std::size_t undriven = 0;  ///< ticks with the servo's output off
  bool saturated = false;    ///< read beyond what the bus can carry (20.47 deg) at a limit

  std::optional<int> sign;               ///< 1 follows, -1 moves the other way, 0 does not move
  std::optional<double> slope;           ///< of the encoder against the lagged command, over the ramps or the sine
  std::optional<double> gain;            ///< way between the two ends reached, over the way commanded
  std::optional<double> positive_share;  ///< way from the centre to this end, over the way commanded
  std::optional<double> negative_share;

  std::optional<double> largest_command_rad;  ///< without sign
  std::optional<double> told_positive_rad;    ///< command in the hold; of a step: whichever way it goes
  std::optional<double> told_negative_rad;
  std::optional<double> reached_positive_rad;  ///< encoder in the hold; of a step: where it went
  std::optional<double> reached_negative_rad;
  std::optional<bool> limit_reported;  ///< `limited` was reported while asked beyond, at both ends

  std::optional<double> lag_s;  ///< delay and lag together
  std::optional<double> tracking_error_rad;
  std::optional<double> tracking_rms_rad;    ///< of the same difference, tick by tick
  std::optional<double> from_above_rad;      ///< encoder - command at the centre; of a step: before it
  std::optional<double> from_below_rad;      ///< of a step: after it
  std::optional<double> centring_error_rad;  ///< mean of the two; of a sine: of before and after it
  std::optional<double> backlash_rad;        ///< difference of the two, without sign
  std::optional<double> stands_at_rad;       ///< mean of all readings at rest
  std::optional<double> drift_rad_s;         ///< fastest still seen long after the command stood, without
                                             ///< sign, and without what noise can be of it

  std::optional<double> slew_rad_s;     ///< fastest 10 ms of the widest step
  std::optional<double> slew_way_rad;   ///< command change of that step, without sign
  std::optional<double> step_time_s;    ///< 10 to 90 % of the first step
  std::optional<double> overshoot_rad;  ///< beyond where it came to rest
  std::optional<double> noise_rad;      ///< standard deviation at rest, drift taken off

  std::optional<double> asked_amplitude_rad;   ///< of the sine asked for, within the limit
  std::optional<double> amplitude_rad;         ///< of the command, in a sine
  std::optional<double> wave_difference;       ///< of the command from the sine asked for: SentWave::difference
  std::optional<double> longest_standstill_s;  ///< of the command within the sine
  std::optional<double> amplitude_ratio;       ///< of a sine
  std::optional<double> slowest_ratio;         ///< of a servo that is just quick enough, in the same sine
  std::optional<double> phase_lag_rad;         ///< of a sine, 0 to 2 pi

  std::optional<double> others_moved_rad;   ///< alone only: how far another canard went along at most
  std::optional<std::size_t> other_canard;  ///< which one went farthest

  [[nodiscard]] double dropout_share() const {
    return received_ticks == 0 ? 1.0 : static_cast<double>(dropouts) / static_cast<double>(received_ticks);
  }
};

/// The bus reports 20.47 deg of everything from there on.
[[nodiscard]] bool beyond_bus(double angle_rad);

[[nodiscard]] Figures measure(const link::Recording& recording, const Exercise& exercise, const Turn& turn,
                              std::size_t canard);

/// The amplitude ratio, in this turn of a sine, of a servo that just meets step time and slew rate:
/// Figures::slowest_ratio.
[[nodiscard]] std::optional<double> slowest_ratio(const link::Recording& recording, const Exercise& exercise,
                                                  const Turn& turn, std::size_t canard,
                                                  const sim::CanardTolerances& tolerances);

// The parts of measure(), each for one kind of movement; each fills what it can.

/// Angles reached in the holds at both limits, and where the centre is found again from above and from below.
void add_ends(const CanardTrace& trace, Figures& figures);
void add_centre(const CanardTrace& trace, Figures& figures);

/// The first step, and the speed of the step that begins with part `widest`. Needs `sign`.
void add_steps(const CanardTrace& trace, Part widest, Figures& figures);

/// How the encoder follows a sine.
void add_wave(const CanardTrace& trace, double frequency_hz, Figures& figures);
/// How far the command was the sine that was asked for.
void add_sent_wave(const CanardTrace& trace, const Exercise& exercise, std::size_t canard, Figures& figures);

/// Level, noise and drift whenever the canard should have stood still.
void add_rest(const CanardTrace& trace, Figures& figures);

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
