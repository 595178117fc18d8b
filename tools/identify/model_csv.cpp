// SPDX-License-Identifier: MIT
#include "identify/model_csv.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "identify/node_times.hpp"
#include "report/numbers.hpp"

namespace fantail::identify {

std::string model_csv(const Record& record, const Model& model, const Simulation& simulation) {
  using report::degrees;
  fmt::memory_buffer out;
  out.reserve((record.size() + 2) * 90);
  fmt::format_to(std::back_inserter(out),
                 "time_s,roll_angle_deg,model_roll_angle_deg,roll_rate_deg_s,model_roll_rate_deg_s,canard_deg,"
                 "disturbance_deg\n");
  const auto cell = [&](double value, char behind) {
    fmt::format_to(std::back_inserter(out), "{:.6f}{}", std::abs(value) < 0.5e-6 ? 0.0 : value, behind);
  };
  for (std::size_t i = 0; i < record.size(); ++i) {
    const NodeShare share = node_share(model.node_time_s, record.time_s[i]);
    const double disturbance_rad =
        (1.0 - share.right_share) * model.node_rad[share.left] + share.right_share * model.node_rad[share.right];
    cell(record.window_begin_s + record.time_s[i], ',');
    cell(degrees(record.roll_angle_rad[i]), ',');
    cell(degrees(simulation.roll_angle_rad[i]), ',');
    cell(degrees(record.roll_rate_rad_s[i]), ',');
    cell(degrees(simulation.roll_rate_rad_s[i]), ',');
    cell(degrees(simulation.canard_rad[i]), ',');
    cell(degrees(disturbance_rad), '\n');
  }
  return fmt::to_string(out);
}

}  // namespace fantail::identify
