// SPDX-License-Identifier: MIT
#include "faults/fingerprint.hpp"

#include <array>
#include <span>

#include <fmt/core.h>

#include "campaign/stored_parts.hpp"

namespace fantail::faults {
namespace {

std::string text_of(const Recipe& recipe) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", static_cast<int>(recipe.kind),
                     static_cast<int>(recipe.device), static_cast<int>(recipe.behaviour), recipe.lasts_s, recipe.on_s,
                     recipe.off_s, recipe.delay_s, recipe.offset_deg_s, recipe.angle_deg, recipe.times,
                     recipe.all_canards, recipe.reset.gap_s, static_cast<int>(recipe.reset.cause),
                     static_cast<int>(recipe.reset.memory), recipe.reset.clock_error_s);
}

std::string text_of(const Findings& findings) {
  return fmt::format("{} {} {} {} {} {} {} {} {}\n", findings.armed, findings.controlled, findings.lasted,
                     findings.apart_deg, findings.apart_settled_deg, findings.trim_after_s, findings.stands_after_s,
                     findings.breach, findings.breach_s);
}

}  // namespace

std::string fingerprint(const Twins& twins) {
  // One that the law must notice, one that only the shafts show, and one that goes through the board's watchdog.
  constexpr std::array cells{"imu/dead/controlling", "servo/hardover/controlling", "processor/watchdog/controlling"};
  constexpr int step_ms = 10;
  constexpr int every = 50;
  const Twin& twin = twins.twins.front();
  const auto roll = std::as_bytes(std::span{twin.true_roll_rad});
  std::string all{reinterpret_cast<const char*>(roll.data()), roll.size()};
  for (const core::Phase phase : twin.phases) {
    all += static_cast<char>(phase);
  }
  for (const FaultRow& row : fault_table()) {
    all += fmt::format("{} {} {} ", row.device, row.fault, static_cast<int>(row.shaft)) + text_of(row.recipe);
    for (const Expected& expected : row.expected) {
      all += sentence(expected) + '\n';
    }
  }
  for (const char* const name : cells) {
    const Cell cell = cell_of(name);
    all += text_of(fly_run(twins, cell, Grid{twins, cell.phase, step_ms, every}[0], 0));
  }
  return campaign::short_digest(all);
}

}  // namespace fantail::faults
