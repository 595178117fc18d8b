// SPDX-License-Identifier: MIT
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign/setup.hpp"
#include "fantail/deliver.hpp"
#include "fantail/many_flights.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "faults/results.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

struct FaultsOptions {
  ScenarioOptions scenario{.scenario = "tasha3_launch2", .seed = {}, .changes = {}};
  std::string device;
  std::string fault;
  std::string phase;
  int step_ms = faults::Campaign{}.step_ms;
  int every = faults::Campaign{}.every;
  bool whole = false;
  std::size_t seeds = 1;
  std::string cell;
  std::size_t run = 0;
  unsigned threads = 0;
  std::string out;
  bool json = false;
  bool list = false;
};

faults::Campaign asked_for(const FaultsOptions& options) {
  faults::Campaign campaign{.scenario = options.scenario.scenario,
                            .changes = input::parse_overrides(options.scenario.changes),
                            .seed = options.scenario.seed.empty() ? campaign::seed_of(options.scenario.scenario)
                                                                  : *text::whole_number(options.scenario.seed),
                            .device = options.device,
                            .fault = options.fault,
                            .phase = options.phase,
                            .step_ms = options.step_ms,
                            .every = options.every,
                            .seeds = options.seeds};
  return campaign;
}

fs::path folder_of(const FaultsOptions& options) {
  const std::string name = input::name_of_file(options.scenario.scenario);
  return results_folder(options.out, "faults", name, changes_of(options.scenario));
}

/// The flights without a fault, of every seed.
faults::Prepared prepare_shown(const faults::Campaign& campaign, unsigned threads) {
  Progress progress{"flying " + input::name_of_file(campaign.scenario) + " without faults",
                    {.unit = "seeds", .rate = " a second", .total = static_cast<double>(campaign.seeds)}};
  return faults::prepare(campaign, threads, [&](std::size_t done) {
    give_up_if_interrupted();
    progress.show(static_cast<double>(done));
  });
}

void fly_one(const FaultsOptions& options) {
  const faults::Campaign campaign = asked_for(options);
  const faults::Prepared prepared = prepare_shown(faults::only(campaign, options.cell), options.threads);
  const faults::Alone alone = faults::fly_alone(prepared, options.cell, options.run);
  const fs::path folder = folder_of(options) / faults::run_folder(options.cell, options.run);
  faults::write_run(campaign, options.cell, options.run, alone, folder);
  const std::string report = (folder / "report.html").string();
  const result::Made made = made_with(files_of(options.scenario), alone.run.seed, changes_of(options.scenario));
  deliver(faults::answer(campaign, alone, report, made), {.json = options.json});
  if (alone.judged.colour == faults::Colour::red) {
    throw RequirementNotMet{""};
  }
}

void list_names() {
  for (const faults::FaultRow& row : faults::fault_table()) {
    show("{:13} {:18} {}\n", row.device, row.fault, row.meaning);
  }
}

void fly_all(const FaultsOptions& options) {
  const faults::Campaign campaign = asked_for(options);
  const fs::path folder = folder_of(options);
  const faults::Prepared prepared = prepare_shown(campaign, options.threads);
  const std::vector<fs::path> inputs = files_of(options.scenario);
  const result::Made made = made_with(inputs, {}, changes_of(options.scenario));
  const faults::Extent& extent = prepared.extent;
  say(fmt::format("{} in {}\n", text::counted(extent.flights, "flight"), text::counted(extent.cells, "cell")));
  faults::Result result;
  {
    Progress progress{"flying " + input::name_of_file(campaign.scenario) + " with faults",
                      {.unit = "runs", .rate = " a second", .total = static_cast<double>(extent.flights)}};
    result = faults::fly_campaign(prepared, folder, program_that_flies(), options.threads, [&](std::uint64_t done) {
      leave_if_interrupted(folder);
      progress.show(static_cast<double>(done));
    });
  }
  if (result.damaged > 0) {
    say(fmt::format("fantail: {} stored parts in {} were damaged, and have been flown again\n", result.damaged,
                    folder.string()));
  }
  Chapters chapters{"faults", 1, "flying the worst flights again and writing the page"};
  faults::write_worst(result, prepared, folder, [&folder] { leave_if_interrupted(folder); });
  chapters.end();
  deliver(faults::answer(result, made),
          {.folder = folder, .name = "summary", .page = "faults", .inputs = inputs, .json = options.json});
  if (faults::has_red(result)) {
    throw RequirementNotMet{""};
  }
}

}  // namespace

void fill_faults(const Verb& verb) {
  auto options = std::make_shared<FaultsOptions>();
  add_scenario_options(verb, options->scenario);
  verb.section("Which faults");
  auto device =
      verb.option("--device", options->device, "Only the faults of this device; --list shows the names [all]");
  device.value_name("NAME").changes_result();
  auto fault = verb.option("--fault", options->fault, "Only this fault; --list shows the names [all]");
  fault.value_name("NAME").changes_result();
  auto phase = verb.option("--phase", options->phase, "Only faults that begin in this phase [all]");
  phase.one_of({"pad", "armed", "launched", "controlling", "after_control"}).changes_result();
  verb.section("Onsets and runs");
  verb.option("--step-ms", options->step_ms, "Milliseconds between two onsets")
      .range(1, 10000)
      .show_default()
      .changes_result();
  auto every = verb.option("--every", options->every,
                           "Use only one onset in this many, but at least three in each phase, or all if it has fewer");
  every.range(1, 100000).show_default().changes_result();
  verb.flag("--whole", options->whole, "Every onset: --every 1").excludes(every);
  verb.option("--seeds", options->seeds, "Number of seeds with which each onset is flown")
      .range(1, 10000)
      .show_default()
      .changes_result();
  auto cell = verb.option("--cell", options->cell, "Fly one run of this cell again: DEVICE/FAULT/PHASE");
  cell.value_name("CELL").excludes(device).excludes(fault).excludes(phase);
  verb.option("--run", options->run, "Number of that run, as the page shows it").range(0, 1e9).needs(cell);
  add_threads_option(verb, options->threads);
  verb.section("Results");
  verb.option(
          "--out", options->out,
          "Folder for faults.html, summary.json, the parts and the worst flights [out/faults/SCENARIO, with what was "
          "changed in the name]")
      .offers(folders);
  auto json =
      verb.flag("--json", options->json, "Print summary.json instead of the text; with --cell, the result of the run");
  auto list = verb.flag("--list", options->list, "List devices and faults, and fly nothing");
  list.excludes(json).excludes(device).excludes(fault).excludes(phase).excludes(cell);
  verb.examples(
      "To continue an interrupted campaign, repeat the command.\n"
      "Exit code 1: a cell, or the run of --cell, is red and no known limit explains it; else 0.\n"
      "Examples:\n"
      "  fantail campaign faults tasha3_launch2              each device, fault and phase, some onsets of each\n"
      "  fantail campaign faults tasha3_launch2 --device imu --phase controlling --whole\n"
      "                                                      every IMU fault at every 10 ms of control\n"
      "  fantail campaign faults tasha3_launch2 --cell imu/dead/controlling --run 7\n"
      "                                                      one of its runs again, with a flight report");
  verb.action([options] {
    options->every = options->whole ? 1 : options->every;
    if (options->list) {
      list_names();
    } else if (options->cell.empty()) {
      fly_all(*options);
    } else {
      fly_one(*options);
    }
  });
}

}  // namespace fantail::tool
