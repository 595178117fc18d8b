// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "identify/estimate.hpp"
#include "identify/record.hpp"

namespace fantail::identify {

/// A row a sample, on the log's clock: time_s, roll_angle_deg, model_roll_angle_deg, roll_rate_deg_s,
/// model_roll_rate_deg_s, canard_deg, disturbance_deg.
[[nodiscard]] std::string model_csv(const Record& record, const Model& model, const Simulation& simulation);

}  // namespace fantail::identify
