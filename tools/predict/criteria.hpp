// SPDX-License-Identifier: MIT
#pragma once

#include "predict/decision.hpp"

namespace fantail::predict {

// The requirements of every launch; decision.hpp has those of some.

/// Enough of the runs for their value, and too few to be sure.
[[nodiscard]] bool too_few_runs(const Share& share, double threshold);

[[nodiscard]] Criterion authority(const Prediction& prediction, double threshold);
[[nodiscard]] Criterion held(const Prediction& prediction, double threshold);
[[nodiscard]] Criterion phase_margin(const Prediction& prediction, double threshold_rad);

/// A share of the runs that must be at least `threshold`; without its clause.
[[nodiscard]] Criterion share_asked(std::string key, std::string label, const Share& share, double threshold);
[[nodiscard]] std::string more_runs(const Share& share, double threshold);

/// The clauses as sentences behind a colon: all but the first with a capital letter, and no full stop at the end.
[[nodiscard]] std::string as_sentences(const std::vector<std::string>& clauses);

}  // namespace fantail::predict
