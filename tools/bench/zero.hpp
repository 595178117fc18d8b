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

// Where the shaft stands for what is commanded: encoder = centre + scale * command, at rest. Both are measured at three
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

/// Which of the two stands right at the centre. The encoder cannot say; the scale is the servo's in any case, because
/// an encoder counts whole turns.
enum class Trusted : std::uint8_t { encoder, servo };

/// Fields of the plan, in the units of its file.
struct ZeroFields {
  Measured pulse_centre_us{};
  Measured pulse_per_degree_us{};
  Measured encoder_zero_deg{};
};
[[nodiscard]] ZeroFields present_fields(const core::CanardPlan& canard);
/// With these the encoder reads what is commanded.
[[nodiscard]] ZeroFields measured_fields(const core::CanardPlan& canard, const CanardZero& zero, Trusted trusted);

/// For a terminal.
[[nodiscard]] std::string zero_text(std::span<const CanardZero> zeros, const core::CanardsPlan& plan, Trusted trusted);
/// What no encoder can show, in one sentence.
[[nodiscard]] std::string what_an_encoder_cannot_show();
/// One object; every figure with its unit in its name.
[[nodiscard]] std::string zero_json(std::span<const CanardZero> zeros, const core::CanardsPlan& plan, Trusted trusted,
                                    const result::Made& made = {});

}  // namespace fantail::bench
