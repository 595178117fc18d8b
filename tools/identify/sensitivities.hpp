// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "identify/estimate.hpp"
#include "identify/identification.hpp"
#include "identify/record.hpp"

namespace fantail::identify {

/// How much the modelled roll angle of every sample moves when one number of the model does. A row a sample.
struct Sensitivities {
  Eigen::MatrixXd numbers;      ///< columns: alpha, beta, nodes
  Eigen::MatrixXd start_angle;  ///< a column a segment
  Eigen::MatrixXd start_rate;   ///< likewise
};

/// Of the open loop. Exact but for alpha, which takes a central difference good to about 1e-8.
[[nodiscard]] Sensitivities open_loop_sensitivities(const Record& record, const Airframe& airframe, const Model& model);

}  // namespace fantail::identify
