// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "core/flight_plan_table.hpp"
#include "fantail/plan_check.hpp"

namespace fantail::tool {

std::vector<std::string> unmet_clauses(const core::FlightPlan& plan) {
  if (plan.run.start != core::Start::launch || plan.run.canard_fault == core::CanardFaultPolicy::end_control) {
    return {};
  }
  const std::string_view policy = core::plan_table::fault_policy_names[static_cast<std::size_t>(plan.run.canard_fault)];
  return {
      fmt::format("run.canard_fault = \"{}\": control goes on with a failed canard, and EuRoC asks for neutral "
                  "canards in any abnormal condition (DES.22); \"end_control\" ends it at trim",
                  policy)};
}

}  // namespace fantail::tool
