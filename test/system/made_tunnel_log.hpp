// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include "json/value.hpp"
#include "sim/roll_plant.hpp"
#include "sim/units.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {

inline constexpr double degrees = 1.0 / sim::radians_per_degree;
inline const Words tasha{"--vehicle", "tasha3_launch2"};

inline Words identify(const std::string& data, const Words& more = {}) {
  Words words{"identify", data};
  words.insert(words.end(), tasha.begin(), tasha.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

struct Row {
  double time_s;
  double angle_deg;
  double rate_deg_s;
  double canard_deg;
};

inline std::string cells(const Row& r) {
  return std::to_string(r.time_s) + "," + std::to_string(r.angle_deg) + "," + std::to_string(r.rate_deg_s) + "," +
         std::to_string(r.canard_deg) + ",22\n";
}

inline const std::string head = "time_s,roll_angle_deg,roll_rate_deg_s,canard_deg,speed_m_s\n";

// Five seconds in a tunnel at 100 Hz: alpha 20, beta 9, offset -5 degrees.
inline std::vector<Row> tunnel_rows(const std::function<double(double)>& canard_deg) {
  const sim::RollPlant plant{
      .inertia_kg_m2 = 0.00393, .reference_area_m2 = 5.0265e-5, .damping_m2 = 20.0, .torque_m = 9.0};
  sim::RollState state{};
  std::vector<Row> rows;
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i;
    rows.push_back({t, degrees * state.angle_rad, degrees * state.rate_rad_s, canard_deg(t)});
    constexpr int steps = 20;  // the canards move between samples, too
    for (int k = 0; k < steps; ++k) {
      const double between = t + 0.01 * (k + 0.5) / steps;
      state = plant.step(state, 1.2, 22.0, (canard_deg(between) - 5.0) / degrees, 0.01 / steps);
    }
  }
  return rows;
}

inline double shaken(double t) { return 5.0 + 4.0 * std::sin(6.0 * t) + std::sin(17.0 * t); }

inline std::string text(const std::vector<Row>& rows) {
  std::string all = head;
  for (const Row& row : rows) {
    all += cells(row);
  }
  return all;
}

inline json::Value identified(const Folder& folder, const Words& words) {
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return json::parse(outcome.out);
}

}  // namespace fantail::test
