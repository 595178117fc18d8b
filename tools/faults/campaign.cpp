// SPDX-License-Identifier: MIT
#include "faults/campaign.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "campaign/setup.hpp"
#include "faults/stop_rule.hpp"
#include "faults/tasks.hpp"
#include "flight/model_end.hpp"
#include "fly/describe.hpp"
#include "fly/fly_scenario.hpp"
#include "runs/runner.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

constexpr std::uint64_t runs_of_a_part = 128;

[[noreturn]] void refuse(const std::string& complaint, text::ErrorKind kind = text::ErrorKind::bad_configuration) {
  throw text::Error{kind, complaint};
}

campaign::Campaign words_of(const Campaign& campaign) {
  campaign::Campaign words;
  words.scenario = campaign.scenario;
  words.changes = campaign.changes;
  words.seed = campaign.seed;
  return words;
}

sim::Scenario scenario_of(const Campaign& campaign) {
  sim::Scenario scenario = campaign::files_of(words_of(campaign)).read();
  if (scenario.surroundings != sim::Surroundings::flight) {
    refuse(scenario.name + ": is not a launch; allowed: a scenario that flies");
  }
  scenario.seed = campaign.seed;
  scenario.changed_values = campaign.changes.size();
  return scenario;
}

void check(const Campaign& campaign) {
  if (campaign.step_ms < 1 || campaign.every < 1 || campaign.seeds < 1) {
    refuse("step, every or seeds is below 1; allowed: 1 or more");
  }
}

double apart_deg_of(const Findings& findings, std::optional<Outcome> outcome) {
  return outcome == Outcome::ended      ? findings.apart_meanwhile_deg
         : outcome == Outcome::anything ? findings.apart_with_turns_deg
                                        : findings.apart_deg;
}

Run run_of(const Twins& twins, const Cell& cell, const Grid::Run& at, std::uint64_t number, const Findings& findings) {
  const auto outcome = findings.outcome(cell.expected());
  return {.number = number,
          .seed = twins.seeds[at.seed],
          .begin_ms = at.begin_ms,
          .outcome = outcome,
          .is_breach = !findings.breach.empty(),
          .came_back = !outcome && findings.came_back(cell.expected()),
          .apart_deg = 1e-3 * std::round(1e3 * apart_deg_of(findings, outcome)),
          .trim_after_s = findings.trim_after_s,
          .stands_after_s = findings.stands_after_s,
          .what = outcome ? std::string{} : findings.what_it_was()};
}

Run flown(const Twins& twins, const Task& task, std::uint64_t number) {
  const Grid::Run at = (*task.grid)[number];
  return run_of(twins, task.cell, at, number, fly_run(twins, task.cell, at, number));
}

CellLimit limit_of(const Cell& cell, const Twins& twins) {
  CellLimit of_cell{.limit = known_limit(*cell.row, cell.phase, twins.scenario)};
  if (of_cell.limit != nullptr && of_cell.limit->last_ms > 0) {
    of_cell.from_ms = end_of(cell.phase, twins) - of_cell.limit->last_ms;
  }
  return of_cell;
}

/// Of the flight without a fault: that a fault throws a rocket about is what is looked for.
std::string beyond_model(const Twins& twins) {
  return flight::how_far_beyond(fly::fly_without_rows(twins.scenario, [](const auto&, const auto&) {}).extremes);
}

/// Of the faults that the scenario has of its own, by the longest of the flights without another.
std::string never_happened(const Twins& twins) {
  const std::size_t moments =
      std::ranges::max(twins.twins, {}, [](const Twin& twin) { return twin.phases.size(); }).phases.size();
  return fly::never_happened(twins.scenario, 1e-3 * static_cast<double>(moments) - twins.scenario.pad_time_s);
}

runs::Identity identity_of(const Campaign& campaign, const std::string& program, const Twins& twins) {
  const campaign::Campaign words = words_of(campaign);
  runs::Identity identity = campaign::identity_of(words, campaign::files_of(words), {}, program);
  std::erase_if(identity, [](const auto& entry) {
    return entry.first == "runs" || entry.first == "sampling" || entry.first == "stop" || entry.first == "tables" ||
           entry.first == "shard";
  });
  identity.insert(identity.begin(), {"kind", "campaign faults"});
  const auto all_or = [](const std::string& word) { return word.empty() ? "all" : word; };
  identity.emplace_back("device", all_or(campaign.device));
  identity.emplace_back("fault", all_or(campaign.fault));
  identity.emplace_back("phase", all_or(campaign.phase));
  identity.emplace_back("step_ms", fmt::format("{}", campaign.step_ms));
  identity.emplace_back("every", fmt::format("{}", campaign.every));
  identity.emplace_back("seeds", fmt::format("{}", campaign.seeds));
  identity.emplace_back("flights", fingerprint(twins));
  return identity;
}

}  // namespace

Prepared prepare(const Campaign& campaign, unsigned threads, const std::function<void(std::size_t)>& look) {
  check(campaign);
  const sim::Scenario scenario = scenario_of(campaign);
  // By the first seed, before the others are flown.
  const std::uint64_t of_one = extent_of(campaign, fly_twins(scenario, 1)).flights;
  if (of_one > most_flights / campaign.seeds) {
    refuse(fmt::format(
        "this campaign has about {} flights; allowed: {}; take fewer seeds, a larger --every or --step-ms, or one "
        "device, fault or phase",
        of_one * campaign.seeds, most_flights));
  }
  Twins twins = fly_twins(scenario, campaign.seeds, threads, look);
  const Extent extent = extent_of(campaign, twins);
  return {.campaign = campaign, .twins = std::move(twins), .extent = extent};
}

Result fly_campaign(const Prepared& prepared, const std::filesystem::path& folder, const std::string& program,
                    unsigned threads, const std::function<void(std::uint64_t)>& look) {
  const Campaign& campaign = prepared.campaign;
  const Twins& twins = prepared.twins;
  const std::vector<Task> tasks = tasks_of(campaign, twins);
  const runs::Folder store{
      {.folder = folder, .identity = identity_of(campaign, program, twins), .not_beside = "campaign.json"}};
  std::vector<runs::Part> parts;
  std::vector<std::size_t> task_of;  // a part
  std::vector<CellLimit> limits;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    limits.push_back(limit_of(tasks[i].cell, twins));
    std::string name = tasks[i].cell.name() + '.';
    std::ranges::replace(name, '/', '.');
    const runs::Stretch all{.first = 0, .count = tasks[i].grid ? tasks[i].grid->size() : 0};
    std::ranges::move(runs::parts_of(all, runs_of_a_part, name), std::back_inserter(parts));
    task_of.resize(parts.size(), i);
  }
  std::vector<CellSum> sums(parts.size());
  const runs::Flights flights = runs::rows_of<Run>(
      parts, [&](std::size_t i, std::uint64_t number) { return flown(twins, tasks[task_of[i]], number); },
      [&](std::size_t i, std::vector<Run>& rows) {
        for (const Run& run : rows) {
          sums[i].add(run, limits[task_of[i]]);
        }
      });
  const runs::Summary summary = runs::run(flights, &store, threads, look);
  Result result{.campaign = campaign,
                .scenario = twins.scenario.name,
                .vehicle = twins.scenario.vehicle.name,
                .plan = twins.scenario.plan_name,
                .cells = {},
                .flights = summary.flights,
                .damaged = summary.damaged,
                .never_happened = never_happened(twins),
                .beyond_model = beyond_model(twins)};
  std::vector<CellSum> cells(tasks.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    cells[task_of[i]].add(sums[i]);
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    result.cells.push_back(conclude(tasks[i].cell, cells[i], limits[i].limit));
    result.cells.back().is_reached = !tasks[i].is_not_reached;
    result.cells.back().of_rocket = about_stop(result.cells.back(), twins);
  }
  return result;
}

Alone fly_alone(const Prepared& prepared, const std::string& cell_name, std::uint64_t number) {
  const Twins& twins = prepared.twins;
  const Cell named = cell_of(cell_name);
  const Cell cell = twins.cell(*named.row, named.phase);
  if (const std::string why = why_not(*cell.row, twins.scenario); !why.empty()) {
    refuse(cell_name + ": " + why);
  }
  const Grid grid{twins, cell.phase, prepared.campaign.step_ms, prepared.campaign.every};
  if (grid.size() == 0) {
    refuse(fmt::format("{}: {} has no time in this phase", cell_name, twins.scenario.name));
  }
  if (number >= grid.size()) {
    refuse(fmt::format("{}: run {}; allowed: 0 to {}", cell_name, number, grid.size() - 1), text::ErrorKind::usage);
  }
  const Grid::Run at = grid[number];
  Alone alone{.scenario = faults::scenario_of(twins, cell, at, number),
              .expected = cell.expected(),
              .findings = fly_run(twins, cell, at, number),
              .run = {},
              .judged = {},
              .beyond_model = beyond_model(twins)};
  alone.run = run_of(twins, cell, at, number, alone.findings);
  const CellLimit limit = limit_of(cell, twins);
  alone.judged = concluded(cell, std::vector{alone.run}, limit);
  alone.judged.of_rocket = about_stop(alone.judged, twins);
  if (alone.judged.colour == Colour::limit_without_need) {
    alone.judged.colour = Colour::green;  // one run does not say that the cell has no need of it
  }
  return alone;
}

Campaign only(Campaign campaign, const std::string& cell_name) {
  const Cell cell = cell_of(cell_name);
  campaign.device = cell.row->device;
  campaign.fault = cell.row->fault;
  campaign.phase = name(cell.phase);
  return campaign;
}

}  // namespace fantail::faults
