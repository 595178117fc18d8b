// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "identify/model/roll_model.hpp"

// How the roll rate answers the canards at each frequency: a look at the log that knows nothing of the roll equation.
namespace fantail::identify::result {

/// What the cross spectra are taken with. A signal that comes from outside the control loop leaves out what noise and
/// disturbances do to the canards by way of the controller.
enum class Instrument : std::uint8_t { canards, excitation, reference };

/// Roll rate per canard angle, from the log and from the model under the same canards, by the same estimator.
struct FrequencyEstimate {
  double gain_per_s;
  double phase_rad;    ///< above -270 and up to 90 degrees
  double reach_per_s;  ///< of the gain, to either end of its 95 % interval
  double model_gain_per_s;
  double model_phase_rad;
};

struct FrequencyLine {
  double frequency_hz;
  double coherence;  ///< 0 to 1; of an instrument: with the canards or with the roll rate, the lower one
  std::optional<FrequencyEstimate> estimate;  ///< empty where the coherence is too low to tell
};

struct FrequencyResponse {
  std::string obstacle{};  ///< a sentence when there are no lines
  std::vector<FrequencyLine> lines{};
  Instrument instrument = Instrument::canards;
  bool loop_was_closed = false;  ///< as far as the log says: it has a controller's reference
  std::size_t segments = 0;
  double segment_s = 0.0;
};

inline constexpr double least_coherence = 0.6;

/// Welch's method (1967): half-overlapping segments without their trend under Hann's window, at least six of them.
/// `simulation` is the open loop's, with the measured canards.
[[nodiscard]] FrequencyResponse frequency_response(const model::Record& record, const model::Simulation& simulation);

/// In how many lines the estimate was possible, and in how many of them the model's gain lies inside the 95 % interval.
struct FrequencyCount {
  std::size_t told = 0;
  std::size_t agreed = 0;
  double lowest_hz = 0.0;  ///< of those told
  double highest_hz = 0.0;
};
[[nodiscard]] FrequencyCount count_lines(const FrequencyResponse& response);

}  // namespace fantail::identify::result
