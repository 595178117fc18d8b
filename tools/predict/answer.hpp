// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "page/chart.hpp"
#include "predict/decision.hpp"
#include "result/document.hpp"

namespace fantail::predict {

/// Yes: go; undecided: nothing speaks against it, but not everything could be judged. Spreadsheets: a row for each run,
/// and the predicted roll over time.
[[nodiscard]] result::Document answer(const Prediction& prediction, const Decision& decision, const result::Made& made);

/// Every figure in its files, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

// Pictures of predict.html that no table has.

/// The reference of the run that is controlled longest, over the times of the band.
[[nodiscard]] page::Series reference(const Prediction& prediction);
/// How many of the runs have an offset of at most this size, with the canard limit.
[[nodiscard]] page::Chart offset_chart(const Prediction& prediction);
/// What the fin offset needs and the canards give over the air speed of the climb. Empty for a rocket that stays on the
/// pad.
[[nodiscard]] std::optional<page::Chart> authority_chart(const Prediction& prediction);
/// The canard angle that a cant of all fins needs, by the shape of the fins and the canard torque of the runs, with
/// the fin offset of the runs on it.
/// Empty without fins and canards in the vehicle file.
[[nodiscard]] std::optional<page::Chart> cant_chart(const Prediction& prediction);
/// Damping and torque of the airframes drawn, and of the tunnel's steps.
[[nodiscard]] page::Chart airframe_chart(const Prediction& prediction);
/// Steady roll rates over the air speed, without control and with the canards at their limit, and where roll resonance
/// is. Only with a resonance.
[[nodiscard]] page::Chart resonance_chart(const Prediction& prediction);

}  // namespace fantail::predict
