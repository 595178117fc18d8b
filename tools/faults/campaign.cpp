// SPDX-License-Identifier: MIT
#include "faults/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "campaign/parallel_for.hpp"
#include "campaign/setup.hpp"
#include "faults/parts.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

constexpr std::uint64_t runs_of_a_part = 128;

/// A cell that is asked for, with its grid; `grid` is empty where the scenario cannot have the fault.
struct Task {
  Cell cell;
  std::optional<Grid> grid;
};

struct Part {
  std::size_t task = 0;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

[[noreturn]] void refuse(const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_configuration, complaint};
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
    refuse(scenario.name + ": is no launch; allowed: a scenario that flies");
  }
  scenario.seed = campaign.seed;
  scenario.changed_values = campaign.changes.size();
  return scenario;
}

void check(const Campaign& campaign) {
  if (campaign.step_ms < 1 || campaign.every < 1 || campaign.seeds < 1) {
    refuse("step, every and seeds; allowed: 1 or more");
  }
}

std::vector<Task> tasks_of(const Campaign& campaign, const Twins& twins) {
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
      Task task{.cell = {.row = &row, .phase = phase}, .grid = {}};
      if (task.cell.expected().applies() && why_not(row, twins.scenario).empty()) {
        task.grid.emplace(twins, phase, campaign.step_ms, campaign.every);
      }
      tasks.push_back(std::move(task));
    }
  }
  if (tasks.empty()) {
    std::string asked;
    for (const auto& [what, word] : {std::pair{"device", campaign.device}, std::pair{"fault", campaign.fault},
                                     std::pair{"phase", campaign.phase}}) {
      asked += word.empty() ? std::string{} : fmt::format(" {} \"{}\"", what, word);
    }
    refuse(fmt::format("there is no cell of{}; the devices: {}", asked, fmt::join(device_names(), ", ")));
  }
  return tasks;
}

Run flown(const Twins& twins, const Task& task, std::uint64_t number) {
  const Grid::Run& at = (*task.grid)[number];
  const Findings findings = fly_run(twins, task.cell, at, number);
  const auto outcome = findings.outcome(task.cell.expected());
  return {.number = number,
          .seed = twins.seeds[at.seed],
          .begin_ms = at.begin_ms,
          .outcome = outcome,
          .apart_deg = 1e-3 * std::round(1e3 * findings.apart_deg),
          .trim_after_s = findings.trim_after_s,
          .stands_after_s = findings.stands_after_s,
          .what = outcome ? std::string{} : findings.what_it_was()};
}

bool belongs(const std::vector<Run>& runs, const Twins& twins, const Task& task, const Part& part) {
  bool is = runs.size() == part.end - part.begin;
  for (std::uint64_t i = 0; is && i < runs.size(); ++i) {
    const Grid::Run& at = (*task.grid)[part.begin + i];
    is = runs[i].number == part.begin + i && runs[i].seed == twins.seeds[at.seed] && runs[i].begin_ms == at.begin_ms;
  }
  return is;
}

campaign::Identity identity_of(const Campaign& campaign, const std::string& version) {
  const campaign::Campaign words = words_of(campaign);
  campaign::Identity identity = campaign::identity_of(words, campaign::files_of(words), {}, version);
  std::erase_if(identity, [](const auto& entry) {
    return entry.first == "runs" || entry.first == "sampling" || entry.first == "stop" || entry.first == "tables" ||
           entry.first == "shard";
  });
  const auto all_or = [](const std::string& word) { return word.empty() ? "all" : word; };
  identity.emplace_back("device", all_or(campaign.device));
  identity.emplace_back("fault", all_or(campaign.fault));
  identity.emplace_back("phase", all_or(campaign.phase));
  identity.emplace_back("step_ms", fmt::format("{}", campaign.step_ms));
  identity.emplace_back("every", fmt::format("{}", campaign.every));
  identity.emplace_back("seeds", fmt::format("{}", campaign.seeds));
  return identity;
}

}  // namespace

Extent extent_of(const Campaign& campaign) {
  check(campaign);
  Extent extent;
  for (const Task& task : tasks_of(campaign, fly_twins(scenario_of(campaign), campaign.seeds))) {
    extent.cells += task.grid ? 1 : 0;
    extent.flights += task.grid ? task.grid->size() : 0;
  }
  return extent;
}

Result fly_campaign(const Campaign& campaign, const std::filesystem::path& folder, const std::string& version,
                    unsigned threads, const std::function<void(std::uint64_t)>& look) {
  check(campaign);
  const Twins twins = fly_twins(scenario_of(campaign), campaign.seeds);
  const std::vector<Task> tasks = tasks_of(campaign, twins);
  const PartsFolder store{folder, identity_of(campaign, version)};
  std::vector<Part> parts;
  std::vector<std::vector<Run>> runs(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const std::uint64_t size = tasks[i].grid ? tasks[i].grid->size() : 0;
    runs[i].resize(size);
    for (std::uint64_t begin = 0; begin < size; begin += runs_of_a_part) {
      parts.push_back({.task = i, .begin = begin, .end = std::min(begin + runs_of_a_part, size)});
    }
  }
  std::atomic<std::uint64_t> done{0};
  campaign::parallel_for(
      parts.size(), threads,
      [&](std::size_t i) {
        const Part& part = parts[i];
        const Task& task = tasks[part.task];
        const std::string name = fmt::format("{}.{:06}", task.cell.name(), part.begin);
        auto own = store.stored(name);
        if (own && belongs(*own, twins, task, part)) {
          done += own->size();
        } else {
          own.emplace();
          for (std::uint64_t number = part.begin; number < part.end; ++number) {
            own->push_back(flown(twins, task, number));
            ++done;
          }
          store.store(name, *own);
        }
        std::ranges::move(*own, runs[part.task].begin() + static_cast<std::ptrdiff_t>(part.begin));
      },
      [&](std::size_t) { look(done); });
  Result result{.campaign = campaign,
                .scenario = twins.scenario.name,
                .vehicle = twins.scenario.vehicle.name,
                .plan = twins.scenario.plan_name,
                .cells = {},
                .flights = done};
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Cell& cell = tasks[i].cell;
    const KnownLimit* limit = known_limit(*cell.row, cell.phase, twins.scenario.plan);
    const int excused_from_ms = limit != nullptr && limit->last_ms > 0 ? end_of(cell.phase, twins) - limit->last_ms
                                                                       : std::numeric_limits<int>::min();
    result.cells.push_back(concluded(cell, runs[i], limit, excused_from_ms));
  }
  return result;
}

Alone fly_alone(const Campaign& campaign, const std::string& cell_name, std::uint64_t number) {
  check(campaign);
  const Cell cell = cell_of(cell_name);
  const Twins twins = fly_twins(scenario_of(campaign), campaign.seeds);
  if (const std::string why = why_not(*cell.row, twins.scenario); !why.empty()) {
    refuse(cell_name + ": " + why);
  }
  const Grid grid{twins, cell.phase, campaign.step_ms, campaign.every};
  if (number >= grid.size()) {
    refuse(fmt::format("{}: run {}; allowed: 0 to {}", cell_name, number, grid.size() - 1));
  }
  return {.scenario = faults::scenario_of(twins, cell, grid[number], number),
          .expected = cell.expected(),
          .findings = fly_run(twins, cell, grid[number], number)};
}

}  // namespace fantail::faults
