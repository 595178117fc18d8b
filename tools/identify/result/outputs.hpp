// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/result/findings.hpp"
#include "result/answer.hpp"
#include "text/layout.hpp"

namespace fantail::identify::result {

/// For a terminal: one table a window, its methods side by side, and what the numbers are worth in words.
[[nodiscard]] std::string as_text(const Study& study, std::size_t columns = text::any_width);

/// report.html: what was found, how well each number is known in plain words, and the pictures behind it.
[[nodiscard]] std::string as_html(const Study& study);

/// One object with the numbers of the one result; with several windows or methods {"results": [...]} of such objects,
/// in the order of the windows. An open end of an interval is null.
[[nodiscard]] std::string as_json(const Study& study, const fantail::result::Made& made = {});

/// Do the windows determine damping and torque? Undecided where one does not, or where the model does not fit one well.
[[nodiscard]] fantail::result::Verdict verdict_of(const Study& study);

/// A row a sample, on the log's clock: time_s, roll_angle_deg, model_roll_angle_deg, roll_rate_deg_s,
/// model_roll_rate_deg_s, canard_deg, disturbance_deg.
[[nodiscard]] std::string as_csv(const model::Record& record, const model::RollModel& model,
                                 const model::Simulation& simulation);

/// Names of the CSVs, in the order of windows and methods: model.csv, or model_1.csv, model_2.csv, ...
[[nodiscard]] std::vector<std::string> model_csv_names(const Study& study);

/// The CSVs that an earlier result left in the folder and a new one with `names` does not replace. A file with such a
/// name but another header is not one of them.
[[nodiscard]] std::vector<std::string> stale_models(const std::filesystem::path& folder,
                                                    const std::vector<std::string>& names);

/// Writes report.html, identification.json and the CSVs, all or none; stale_models() are gone. Throws
/// text::OutputError.
void write_study(const Study& study, const std::filesystem::path& folder, const fantail::result::Made& made = {});

}  // namespace fantail::identify::result
