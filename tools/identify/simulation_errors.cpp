// SPDX-License-Identifier: MIT
#include "identify/simulation_errors.hpp"

#include <cmath>

namespace fantail::identify {

void add_errors(Simulation& simulation, const Record& record) {
  const auto samples = static_cast<double>(record.size());
  double angle_sum = 0.0;
  double rate_sum = 0.0;
  double square_sum = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double angle_error = record.roll_angle_rad[i] - simulation.roll_angle_rad[i];
    angle_sum += std::abs(angle_error);
    square_sum += angle_error * angle_error;
    rate_sum += std::abs(record.roll_rate_rad_s[i] - simulation.roll_rate_rad_s[i]);
  }
  simulation.mean_abs_angle_error_rad = angle_sum / samples;
  simulation.mean_abs_rate_error_rad_s = rate_sum / samples;
  simulation.rms_angle_error_rad = std::sqrt(square_sum / samples);
}

}  // namespace fantail::identify
