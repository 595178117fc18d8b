// SPDX-License-Identifier: MIT
#pragma once

#include "predict/decision.hpp"
#include "result/document.hpp"

namespace fantail::predict {

/// Yes: go; undecided: nothing speaks against it, but not everything could be judged. Spreadsheets: a row for each run,
/// and the predicted roll over time.
[[nodiscard]] result::Document answer(const Prediction& prediction, const Decision& decision, const result::Made& made);

/// Every figure in its files, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

}  // namespace fantail::predict
