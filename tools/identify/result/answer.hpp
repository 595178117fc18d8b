// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identify/result/agreement.hpp"
#include "result/document.hpp"

namespace fantail::identify::result {

/// What was found in each window, all methods beside each other: how well each number is known, in plain words too, and
/// the pictures behind it. In JSON one object; with several windows or methods {"results": [...]} of such objects, in
/// the order of the windows. Yes: the windows determine damping and torque. Undecided where one does not, or where the
/// model does not fit one well.
[[nodiscard]] fantail::result::Document answer(const Study& study, const fantail::result::Made& made = {});
/// What several windows say together: alpha and beta with their intervals, and a list "windows". Yes: it is one roll
/// model, and determined; else undecided.
[[nodiscard]] fantail::result::Document answer(const JointFindings& findings, const fantail::result::Made& made = {});
/// Yes: the model holds in all windows. Undecided where some window cannot tell.
[[nodiscard]] fantail::result::Document answer(const Validation& validation, const fantail::result::Made& made = {});

/// The figures of all three.
[[nodiscard]] std::vector<fantail::result::Listed> listed_fields();

/// "The model holds: ...": what was found in a window, in full.
[[nodiscard]] std::string verdict(const Validation& validation, const ValidatedWindow& window);

/// model.csv, or model_1.csv, model_2.csv, ...: those that an earlier result left in the folder and this one does not
/// replace. A file with such a name but another header is not one of them.
[[nodiscard]] std::vector<std::string> stale_models(const std::filesystem::path& folder,
                                                    const fantail::result::Document& document);

}  // namespace fantail::identify::result
