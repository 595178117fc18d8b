// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "brief/brief.hpp"
#include "hal/board.hpp"

namespace fantail::brief {

inline constexpr std::string_view never_flown =
    "Fantail has never flown or run on hardware; every figure here is simulated.";

// Sentences for page, terminal and JSON.
/// What makes the figures doubtful, with a space behind each; empty: nothing.
[[nodiscard]] std::string doubts(const Brief& brief);
[[nodiscard]] std::string headline(const Brief& brief);
[[nodiscard]] std::vector<std::string> landing_sentences(const Brief& brief);
[[nodiscard]] std::vector<std::string> wind_sentences(const Brief& brief);
/// When canards may move, and when that is in the nominal flight.
[[nodiscard]] std::vector<std::string> gate_sentences(const Brief& brief);
/// What ends control.
[[nodiscard]] std::vector<std::string> end_sentences(const Brief& of);
[[nodiscard]] std::string abort_sentence(core::AbortInput input);
[[nodiscard]] std::vector<std::string> disarm_sentences(core::AbortInput input);

/// "vertical", "leans 5 deg towards 090 deg"
[[nodiscard]] std::string lean(const Brief& brief);
/// "3 m/s from 270 deg"
[[nodiscard]] std::string wind_flown(const Brief& brief);

/// What a person is to make of light and buzzer.
struct SignalMeaning {
  hal::Signal signal;
  std::string_view phase;
  std::string_view meaning;
};
[[nodiscard]] const std::array<SignalMeaning, 7>& signal_meanings();

}  // namespace fantail::brief
