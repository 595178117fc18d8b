// SPDX-License-Identifier: MIT
#include <algorithm>
#include <tuple>

#include <fmt/core.h>

#include "campaign/flown_run.hpp"
#include "campaign/setup.hpp"
#include "faults/campaign.hpp"

namespace fantail::faults {
namespace {

constexpr std::size_t most = 5;

int rank(Colour colour) { return colour == Colour::red ? 0 : colour == Colour::known_limit ? 1 : 2; }

bool is_worse(const CellResult& a, const CellResult& b) {
  const auto key = [](const CellResult& cell) {
    const Run& run = *cell.worst;
    const bool was_controlled =
        run.outcome != Outcome::over && run.outcome != Outcome::no_control && run.outcome != Outcome::not_armed;
    return std::tuple{rank(cell.colour), was_controlled ? -run.apart_deg : 0.0, -run.stands_after_s};
  };
  return key(a) < key(b);
}

}  // namespace

std::vector<std::size_t> worst_cells(const Result& result) {
  std::vector<std::size_t> worst;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const CellResult& cell = result.cells[i];
    if (!cell.worst) {
      continue;
    }
    const auto same =
        std::ranges::find(worst, cell.cell.row, [&](std::size_t other) { return result.cells[other].cell.row; });
    if (same == worst.end()) {
      worst.push_back(i);
    } else if (is_worse(cell, result.cells[*same])) {
      *same = i;
    }
  }
  std::ranges::stable_sort(worst,
                           [&](std::size_t a, std::size_t b) { return is_worse(result.cells[a], result.cells[b]); });
  worst.resize(std::min(worst.size(), most));
  return worst;
}

std::string run_folder(const std::string& cell, std::uint64_t number) {
  std::string name = fmt::format("{}_run_{}", cell, number);
  std::ranges::replace(name, '/', '.');
  return name;
}

void write_run(const Campaign& campaign, const std::string& cell, std::uint64_t number, const Alone& alone,
               const std::filesystem::path& folder) {
  std::vector<std::string> changes;
  changes.reserve(campaign.changes.size());
  for (const input::Override& change : campaign.changes) {
    changes.push_back(campaign::lines_of({change}));
  }
  campaign::write_flight(
      alone.scenario, std::move(changes),
      fmt::format("Run {} of {} of a fault campaign. Safe outcome: {}.", number, cell, cell_of(cell).safe()), folder);
}

void write_worst(Result& result, const Prepared& prepared, const std::filesystem::path& folder,
                 const std::function<void()>& look) {
  for (const std::size_t i : worst_cells(result)) {
    look();
    CellResult& cell = result.cells[i];
    const std::string name = cell.cell.name();
    cell.report = run_folder(name, cell.worst->number);
    write_run(result.campaign, name, cell.worst->number, fly_alone(prepared, name, cell.worst->number),
              folder / cell.report);
  }
}

}  // namespace fantail::faults
