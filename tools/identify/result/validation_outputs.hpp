// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/result/validation_findings.hpp"
#include "result/answer.hpp"

namespace fantail::identify::result {

/// "The model holds in window control: ...": what was found, in full.
[[nodiscard]] std::string verdict(const Validation& validation, const ValidatedWindow& window);

[[nodiscard]] std::string as_text(const Validation& validation);
/// report.html, measured roll beside the model's.
[[nodiscard]] std::string as_html(const Validation& validation);
/// One object; its list "windows" has one for each window.
/// Does the model hold in all windows? Undecided where some window cannot tell.
[[nodiscard]] fantail::result::Answer answer(const Validation& validation);
[[nodiscard]] std::string as_json(const Validation& validation, const fantail::result::Made& made = {});

/// Of model.csv, model_2.csv, ...: as those of a study.
[[nodiscard]] std::vector<std::string> model_csv_names(const Validation& validation);

/// Writes report.html, validation.json and the CSVs, all or none. Throws text::OutputError.
void write_validation(const Validation& validation, const std::filesystem::path& folder,
                      const fantail::result::Made& made = {});

}  // namespace fantail::identify::result
