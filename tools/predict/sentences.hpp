// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "predict/decision.hpp"

namespace fantail::predict {

/// "95 %" for 0.95. One digit after the point where less than one per cent would look like none, or 99.6 like all.
[[nodiscard]] std::string percent(double share);

/// The same for what is at least so: 94.9 is not "95 %".
[[nodiscard]] std::string percent_at_least(double share);

/// "1 run", "200 runs".
[[nodiscard]] std::string runs(std::size_t count);

/// Why the roll of this run was not judged, or not controlled: the first sentence of its flight report, as a clause.
[[nodiscard]] std::string cause(const Run& run);

/// "95 % of the runs", "all runs", "none of the runs".
[[nodiscard]] std::string of_the_runs(double share);

/// What the runs cannot show because there is no spread in them, a sentence; empty where there is one.
[[nodiscard]] std::string missing_spread(const Prediction& prediction);

[[nodiscard]] std::string_view name(Judgement judgement);   ///< for files: "not_met"
[[nodiscard]] std::string_view label(Judgement judgement);  ///< for readers: "not met"

/// "Changed on the command line: controller.canard_limit_deg=9, seed=7."; empty where nothing was.
[[nodiscard]] std::string changes_sentence(const Prediction& prediction);

/// What the roll may do to the pitch, a sentence or more; empty where nothing speaks for it.
[[nodiscard]] std::string resonance_warning(const Prediction& prediction);

/// In how many runs, a clause for the verdict; empty where nothing speaks for it.
[[nodiscard]] std::string resonance_caution(const Prediction& prediction);
/// Of what the scenario spreads and a prediction does not; empty: nothing.
[[nodiscard]] std::string spread_not_drawn(const Prediction& prediction);

/// What the runs or the model show and neither go nor no go counts, with what to do about it: roll resonance, in short,
/// unless it is a caution, and the notes of the flights that are not a figure alone. A sentence or two each.
[[nodiscard]] std::vector<std::string> not_in_verdict(const Prediction& prediction, const Decision& decision);

/// The command that flies a run alone and writes its flight report.
[[nodiscard]] std::string repeat_command(const Prediction& prediction, std::string_view run);

/// How the wind of the runs was chosen; empty where there is none.
[[nodiscard]] std::string wind_sentence(const sim::Scenario& scenario);

/// A clause on a wind that blows alike in all runs, with what varies it; empty: it varies, or there is none.
[[nodiscard]] std::string wind_caution(const sim::Scenario& scenario);

/// How the runs were made: the airframes, the swirl, the servo, what was left out. A sentence each.
[[nodiscard]] std::vector<std::string> basis(const Prediction& prediction);

}  // namespace fantail::predict
