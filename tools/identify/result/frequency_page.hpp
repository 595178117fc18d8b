// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "identify/result/frequency_response.hpp"

namespace fantail::identify::result {

/// A section of the report: gain, phase and coherence over the frequency, and what they can tell.
[[nodiscard]] std::string frequency_section(const FrequencyResponse& response);

/// The same in one or two sentences.
[[nodiscard]] std::string frequency_sentence(const FrequencyResponse& response);

/// What the estimate was taken with, and where it is biased.
[[nodiscard]] std::string instrument_sentence(const FrequencyResponse& response);

/// "excitation"
[[nodiscard]] std::string_view name(Instrument instrument);

}  // namespace fantail::identify::result
