// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "predict/decision.hpp"

namespace fantail::predict {

/// One object; angles in degrees, every figure with its unit in its name; what does not exist is null.
[[nodiscard]] std::string prediction_json(const Prediction& prediction, const Decision& decision,
                                          std::string_view version);

/// For a terminal.
[[nodiscard]] std::string prediction_text(const Prediction& prediction, const Decision& decision);

/// runs.csv: a row for each run.
[[nodiscard]] std::string runs_csv(const Prediction& prediction);

/// band.csv: predicted roll over time.
[[nodiscard]] std::string band_csv(const Prediction& prediction);

/// predict.html: one page that loads nothing.
[[nodiscard]] std::string prediction_html(const Prediction& prediction, const Decision& decision,
                                          std::string_view version);

/// Writes predict.html, predict.json, runs.csv and band.csv into a folder, all or none, and over nothing of
/// `made_from`. Throws text::OutputError.
void write_prediction(const Prediction& prediction, const Decision& decision, std::string_view version,
                      const std::filesystem::path& folder, const std::vector<std::filesystem::path>& made_from);

}  // namespace fantail::predict
