// SPDX-License-Identifier: MIT
#include "faults/tasks.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "text/error.hpp"

namespace fantail::faults {
namespace {

/// No row of the table has them: says which there are of the name that is wrong, or of the device.
[[noreturn]] void refuse_names(const Campaign& campaign) {
  const std::vector<std::string_view> devices = device_names();
  if (!campaign.device.empty() && std::ranges::find(devices, campaign.device) == devices.end()) {
    throw text::Error{text::ErrorKind::usage,
                      fmt::format("there is no device \"{}\"; allowed: {}", campaign.device, fmt::join(devices, ", "))};
  }
  std::vector<std::string_view> names;
  for (const FaultRow& row : fault_table()) {
    if ((campaign.device.empty() || campaign.device == row.device) &&
        std::ranges::find(names, row.fault) == names.end()) {
      names.push_back(row.fault);
    }
  }
  throw text::Error{
      text::ErrorKind::usage,
      fmt::format("there is no fault \"{}\"{}; allowed: {}", campaign.fault,
                  campaign.device.empty() ? std::string{} : " of device " + campaign.device, fmt::join(names, ", "))};
}

}  // namespace

std::vector<Task> tasks_of(const Campaign& campaign, const Twins& twins) {
  std::array<std::shared_ptr<const Grid>, phases> grids;
  for (std::size_t i = 0; i < phases; ++i) {
    grids[i] = std::make_shared<Grid>(twins, static_cast<Phase>(i), campaign.step_ms, campaign.every);
  }
  std::vector<Task> tasks;
  for (const FaultRow& row : fault_table()) {
    for (std::size_t i = 0; i < phases; ++i) {
      const auto phase = static_cast<Phase>(i);
      const bool wanted = (campaign.device.empty() || campaign.device == row.device) &&
                          (campaign.fault.empty() || campaign.fault == row.fault) &&
                          (campaign.phase.empty() || campaign.phase == name(phase));
      if (!wanted) {
        continue;
      }
      Task task{.cell = twins.cell(row, phase), .grid = {}};
      if (task.cell.expected().applies() && why_not(row, twins.scenario).empty()) {
        task.is_not_reached = grids[i]->size() == 0;
        task.grid = task.is_not_reached ? nullptr : grids[i];
      }
      tasks.push_back(std::move(task));
    }
  }
  if (tasks.empty()) {
    refuse_names(campaign);
  }
  return tasks;
}

Extent extent_of(const Campaign& campaign, const Twins& twins) {
  const std::vector<Task> tasks = tasks_of(campaign, twins);
  Extent extent;
  for (const Task& task : tasks) {
    extent.cells += task.grid ? 1 : 0;
    extent.flights += task.grid ? task.grid->size() : 0;
  }
  if (extent.flights == 0) {  // and would be green
    const std::string why = why_not(*tasks.front().cell.row, twins.scenario);
    throw text::Error{text::ErrorKind::bad_configuration,
                      why.empty() ? fmt::format("{}: has no time in the phase {}", twins.scenario.name, campaign.phase)
                                  : fmt::format("{}: {}", tasks.front().cell.row->device, why)};
  }
  return extent;
}

}  // namespace fantail::faults
