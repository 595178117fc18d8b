// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/result/joint_findings.hpp"
#include "result/answer.hpp"
#include "text/layout.hpp"

namespace fantail::identify::result {

/// "out/a, control": a window where there are several logs.
[[nodiscard]] std::string name(const JointWindow& window);

/// What the windows say together, as far as they agree: a heading for it, and sentences.
[[nodiscard]] std::string heading_of(const JointFindings& findings);
[[nodiscard]] std::vector<std::string> conclusions(const JointFindings& findings);

/// For a terminal: a row a window, what it says by itself, and all of them together.
[[nodiscard]] std::string as_text(const JointFindings& findings, std::size_t columns = text::any_width);
/// report.html, with alpha and beta of each window beside those of all.
[[nodiscard]] std::string as_html(const JointFindings& findings);
/// One object: alpha and beta with sd, correlation and interval, the chi-square, and a list "windows".
/// Is it one roll model, and determined? Else undecided.
[[nodiscard]] fantail::result::Answer answer(const JointFindings& findings);
[[nodiscard]] std::string as_json(const JointFindings& findings, const fantail::result::Made& made = {});

/// model_1.csv, model_2.csv, ... in the order of the windows.
[[nodiscard]] std::vector<std::string> model_csv_names(const JointFindings& findings);

/// Writes report.html, identification.json and the CSVs, all or none. Throws text::OutputError.
void write_joint(const JointFindings& findings, const std::filesystem::path& folder,
                 const fantail::result::Made& made = {});

}  // namespace fantail::identify::result
