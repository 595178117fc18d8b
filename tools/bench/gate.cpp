// SPDX-License-Identifier: MIT
#include "bench/gate.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "text/number.hpp"

namespace fantail::bench {

std::string gate(const core::FlightPlan& plan) {
  if (plan.run.start == core::Start::tunnel) {
    return "the start command in the tunnel";
  }
  using enum core::DormantUntil;
  const core::DormancyPlan& dormancy = plan.dormancy;
  const auto waits_for = [&](core::DormantUntil alone, core::DormantUntil with_height) {
    return dormancy.until == alone || dormancy.until == with_height;
  };
  std::vector<std::string> all;
  if (waits_for(burn_out, burn_out_and_height)) {
    const float clock_s = dormancy.burn_clock_factor * core::seconds(dormancy.burn_time);
    all.push_back(
        fmt::format("burn-out, at least {} s after first thrust", text::fixed(static_cast<double>(clock_s), 2)));
  }
  if (waits_for(max_dynamic_pressure, max_dynamic_pressure_and_height)) {
    all.emplace_back("past the largest dynamic pressure");
  }
  if (waits_for(height, burn_out_and_height) || dormancy.until == max_dynamic_pressure_and_height) {
    all.push_back(fmt::format("{} m above the launch site", text::brief(static_cast<double>(dormancy.height_m), 6)));
  }
  return all.empty() ? "clear of the guide" : fmt::format("{}", fmt::join(all, ", and "));
}

}  // namespace fantail::bench
