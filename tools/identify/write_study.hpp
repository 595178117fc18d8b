// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/study.hpp"

namespace fantail::identify {

/// Names of the CSVs, in the order of windows and methods: model.csv, or model_1.csv, model_2.csv, ...
[[nodiscard]] std::vector<std::string> model_csv_names(const Study& study);

/// Writes report.html, identification.json and the CSVs, all or none. Throws report::OutputError.
void write_study(const Study& study, const std::filesystem::path& folder);

}  // namespace fantail::identify
