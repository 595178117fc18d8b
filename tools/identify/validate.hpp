// SPDX-License-Identifier: MIT
#pragma once

#include "identify/model/roll_model.hpp"
#include "identify/result/agreement.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify {

/// Holds a known alpha and beta against each window of a study: only the disturbance, and starts that are to be fitted,
/// are found anew, at the nodes of the window's own fit. Constants for another reference area are converted. Takes
/// studies of the open loop with one continuous result and its uncertainty a window.
[[nodiscard]] result::Validation validate(const result::KnownModel& model, const result::Study& study,
                                          model::Start start);

}  // namespace fantail::identify
