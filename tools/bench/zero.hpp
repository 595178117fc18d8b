// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/sheet.hpp"
#include "core/flight_plan.hpp"
#include "result/answer.hpp"

namespace fantail::bench {

// The shaft angle at rest for a command: encoder = centre + scale * command. Both are measured at three
// places, the trim and both limits, each approached from either side or corrected by the play.

/// One canard in one run of the `limits` exercise alone.
struct ZeroRun {
  double centre_rad = 0.0;  ///< encoder at command zero
  double scale = 1.0;       ///< of the encoder per command
  double play_rad = 0.0;
};

struct ZeroReading {
  std::optional<ZeroRun> run{};
  std::string refusal{};  ///< why there is none, a sentence
};
[[nodiscard]] ZeroReading zero_reading(const Sheet& sheet, std::size_t canard);

/// A mean, and half of its 95 % interval.
struct Measured {
  double value = 0.0;
  double plus_minus = 0.0;
};

struct CanardZero {
  Measured centre_rad{};
  Measured scale{};
  double play_rad = 0.0;  ///< the widest; within it the canard can stand anywhere
};
/// Of two runs or more. The interval is Student's, and half a step of the bus is added.
[[nodiscard]] CanardZero combined(std::span<const ZeroRun> runs);

/// Which of the two is right at the centre. The encoder cannot show it. The scale is always the servo's, because
/// that of an encoder is fixed by its full turn.
enum class Trusted : std::uint8_t { encoder, servo };

/// Fields of the plan, in the units of its file.
struct ZeroFields {
  Measured pulse_centre_us{};
  Measured pulse_per_degree_us{};
  Measured encoder_zero_deg{};
};
[[nodiscard]] ZeroFields present_fields(const core::CanardPlan& canard);
/// With these the encoder reads the commanded angle.
[[nodiscard]] ZeroFields measured_fields(const core::CanardPlan& canard, const CanardZero& zero, Trusted trusted);

/// For a terminal.
[[nodiscard]] std::string zero_text(std::span<const CanardZero> zeros, const core::CanardsPlan& plan, Trusted trusted);
/// The limits of an encoder, in two sentences.
[[nodiscard]] std::string what_an_encoder_cannot_show();
/// One object; every figure with its unit in its name.
[[nodiscard]] std::string zero_json(std::span<const CanardZero> zeros, const core::CanardsPlan& plan, Trusted trusted,
                                    const result::Made& made = {});

}  // namespace fantail::bench
