// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <span>

#include <fmt/core.h>

#include "faults/campaign.hpp"
#include "input/fault_file.hpp"
#include "runs/folder.hpp"

namespace fantail::faults {
namespace {

/// The words of a file for it, with every number that such a fault has.
std::string text_of(const Recipe& recipe) {
  const input::FaultWords& words = input::words_of(recipe.fault);
  std::string text =
      fmt::format("{} {} {} {} {}", words.kind, words.behaviour, recipe.lasts_s, recipe.times, recipe.all_canards);
  for (const auto& [field, belongs_to] : input::fault_fields()) {
    if (belongs_to(words) && field.place.get != nullptr) {
      text += fmt::format(" {} {}", field.key, field.place.get(recipe.fault, 0));
    }
  }
  return text + '\n';
}

std::string text_of(const Findings& findings) {
  return fmt::format("{} {} {} {} {} {} {} {} {}\n", findings.armed, findings.controlled, findings.lasted,
                     findings.apart_deg, findings.apart_settled_deg, findings.trim_after_s, findings.stands_after_s,
                     findings.breach, findings.breach_s);
}

}  // namespace

std::string fingerprint(const Twins& twins) {
  // One that the law must notice, one that only the shafts show, and one that goes through the board's watchdog.
  constexpr std::array recipes{broken(sim::Device::imu, sim::Behaviour::dead), hardover,
                               reset(hal::ResetCause::watchdog, 0.06)};
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
  for (const Recipe& recipe : recipes) {
    const auto row = std::ranges::find(fault_table(), recipe, &FaultRow::recipe);
    const Cell cell = twins.cell(*row, twins.stay_at_trim ? Phase::launched : Phase::controlling);
    all += text_of(fly_run(twins, cell, Grid{twins, cell.phase, step_ms, every}[0], 0));
  }
  return runs::short_digest(all);
}

}  // namespace fantail::faults
