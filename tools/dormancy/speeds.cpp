// SPDX-License-Identifier: MIT
#include "dormancy/speeds.hpp"

#include <algorithm>

#include "dormancy/opening.hpp"
#include "fly/fly_scenario.hpp"

namespace fantail::dormancy {

std::vector<double> speeds_under_control_m_s(const sim::Scenario& scenario) {
  const bool has_gate =
      scenario.plan.run.start == core::Start::launch && scenario.plan.dormancy.until != core::DormantUntil::guide;
  if (!has_gate) {
    return fly::speeds_under_control_m_s(scenario);
  }
  std::vector<double> all;
  (void)fly::fly_without_rows(scenario, [&all](const flight::Row& row, const flight::Flight&) {
    const double speed_m_s = row.truth->speed_m_s;
    if (row.phase == core::Phase::controlling &&
        (all.empty() || speed_m_s >= std::min(all.front(), slowest_held_m_s))) {
      all.push_back(speed_m_s);
    }
  });
  return all;
}

}  // namespace fantail::dormancy
