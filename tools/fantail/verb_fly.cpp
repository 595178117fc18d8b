// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign/setup.hpp"
#include "fantail/board_replay.hpp"
#include "fantail/deliver.hpp"
#include "fantail/flight_computer_option.hpp"
#include "fantail/fly_page.hpp"
#include "fantail/lcm_output.hpp"
#include "fantail/offers.hpp"
#include "fantail/page_output.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/terminal.hpp"
#include "fantail/wall_clock.hpp"
#include "flight/fly_command.hpp"
#include "fly/fly_scenario.hpp"
#include "hil/wire.hpp"
#include "input/fault_file.hpp"
#include "report/results.hpp"
#include "text/quoting.hpp"
#include "trajectory/trajectory.hpp"

namespace fantail::tool {
namespace {

struct FlyOptions {
  ScenarioOptions scenario{.scenario = "tasha3_launch2", .seed = {}, .changes = {}};
  std::string trajectory;
  std::string campaign;
  std::optional<std::size_t> run;
  std::string out;
  std::string lcm;
  FlightComputerOptions computer;
  PageOptions page;
  bool realtime = false;
  bool json = false;
};

flight::Flight fly_and_show(const sim::Scenario& scenario, FlightComputerOption& computer, LcmOutput& lcm,
                            PageOutput& page, bool realtime) {
  Progress progress{"flying " + scenario.name,
                    {.unit = "s", .rate = " x real time", .total = fly::expected_length_s(scenario)}};
  const auto look = [&progress](double simulated_s) {
    give_up_if_interrupted();
    progress.show(simulated_s);
  };
  if (!lcm.is_on() && !realtime) {
    return fly::fly_scenario(scenario, look, {}, fly::Log::kept, computer.maker());
  }
  WallClock wall_clock;
  const telemetry::Surroundings surroundings{.limits_rad = telemetry::limits_of(scenario.plan)};
  const auto observe = [&](const core::TickRecord& record) {
    if (realtime) {
      wall_clock.wait_for(record.time);
    }
    lcm.report(record, surroundings);
    page.report(record, surroundings);
  };
  return fly::fly_scenario(scenario, look, observe, fly::Log::kept, computer.maker());
}

std::vector<flight::FreeRollPoint> roll_without_control(const sim::Scenario& scenario, const flight::Flight& flight) {
  Progress progress{"flying " + scenario.name + " without control",
                    {.unit = "s", .rate = " x real time", .total = fly::expected_length_s(scenario)}};
  return fly::roll_without_control(scenario, flight, [&progress](double simulated_s) {
    give_up_if_interrupted();
    progress.show(simulated_s);
  });
}

void check_faults(const FlyOptions& options, const sim::Scenario& scenario) {
  const std::string& on = options.computer.on;
  if (on == "host") {
    return;
  }
  const auto refuse = [&](const std::string& fault, const std::string& why) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format("{}: {} cannot be flown with --on {}{}; allowed: --on host", scenario.name, fault, on, why)};
  };
  using sim::Device;
  for (const sim::Fault& fault : scenario.faults) {
    if (std::holds_alternative<sim::Reset>(fault.how)) {
      refuse("faults.kind = \"reset\"", "");
    }
    const std::string device = fmt::format("faults.device = \"{}\"", input::name(fault.device));
    if (fault.device == Device::memory) {
      refuse(device, "");
    }
    if (on != "board") {
      continue;
    }
    for (const Device own : {Device::flash, Device::supply, Device::processor, Device::barometer}) {
      if (fault.device == own) {
        refuse(device, ", which has its own");
      }
    }
    if (fault.device != Device::servo && std::holds_alternative<sim::Delayed>(fault.how)) {
      refuse(device + " with faults.behaviour = \"delayed\"", ", where a sensor answers when it is asked");
    }
    if (fault.device == Device::encoder && sim::is(fault, sim::Behaviour::nan)) {
      refuse(device + " with faults.behaviour = \"nan\"", ", whose encoders send no reading beyond a turn");
    }
  }
}

/// What is flown, with what the report is to say of it, and where that goes.
struct Task {
  sim::Scenario scenario{};
  std::vector<std::string> changes{};
  std::vector<std::string> notes{};
  std::filesystem::path folder{};
  std::vector<std::filesystem::path> made_from{};  ///< files that no result may replace
};

/// Puts the trajectory, where there is one, into the scenario; returns what is to be said of it.
std::vector<std::string> take_trajectory(const FlyOptions& options, Task& task) {
  if (options.trajectory.empty()) {
    return {};
  }
  trajectory::Trajectory trajectory = trajectory::load_trajectory(options.trajectory, task.scenario);
  task.scenario.path = std::move(trajectory.path);
  task.scenario.changed_values = task.changes.size();
  return std::move(trajectory.notes);
}

Task task_of(const FlyOptions& options) {
  Task task{.scenario = load(options.scenario), .changes = changes_of(options.scenario)};
  task.notes = take_trajectory(options, task);
  task.made_from = files_of(options.scenario);
  task.made_from.emplace_back(options.trajectory);
  task.folder = std::filesystem::path{"out"} / variant_name(task.scenario.name, task.changes);
  return task;
}

/// A run of a campaign: the folder of its campaign.json says all about it.
Task campaign_task(const FlyOptions& options) {
  if (!changes_of(options.scenario).empty()) {
    throw UsageError{"--campaign repeats a run unchanged and cannot be combined with --set, --seed or --trajectory"};
  }
  std::filesystem::path folder = options.campaign;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(folder, ignored)) {
    folder = folder.parent_path();  // of which a file was named
  }
  const campaign::Campaign campaign = campaign::campaign_in(folder, FANTAIL_VERSION);
  const std::string& named = options.scenario.scenario;
  if (named != FlyOptions{}.scenario.scenario && named != campaign.scenario) {
    throw UsageError{
        fmt::format("SCENARIO {} cannot be combined with --campaign, which flies {}", named, campaign.scenario)};
  }
  campaign::RepeatedRun repeated = campaign::repeat_run(campaign, *options.run);
  return {.scenario = std::move(repeated.scenario),
          .changes = std::move(repeated.changes),
          .notes = {std::move(repeated.note)},
          .folder = folder / fmt::format("run_{}", *options.run),
          .made_from = {folder}};
}

void fly_and_report(const FlyOptions& options) {
  if (options.page.wanted() && !options.realtime) {
    throw UsageError{"--page shows a flight while it is flown in real time: add --realtime"};
  }
  auto [scenario, changes, notes, usual_folder, made_from] = options.run ? campaign_task(options) : task_of(options);
  check_faults(options, scenario);
  LcmOutput lcm{options.lcm};
  const std::string command =
      options.run ? fmt::format("fantail fly --campaign {} --run {}", text::shell_word(options.campaign), *options.run)
                  : flight::fly_command(options.scenario.scenario, changes);
  PageOutput page{
      options.page,
      {.name = scenario.name + ", simulated", .settles_off_rad = settles_off_rad(scenario), .what_ends = "The flight"},
      command + " --realtime " + options.page.words()};
  FlightComputerOption computer{options.computer};
  page.wait_for_viewer();
  flight::Flight flight = fly_and_show(scenario, computer, lcm, page, options.realtime);
  computer.end();
  flight.without_control = roll_without_control(scenario, flight);
  flight.command = options.computer.on == "host" ? command : fmt::format("{} --on {}", command, options.computer.on);
  flight.changes = std::move(changes);
  flight.notes.insert(flight.notes.begin(), notes.begin(), notes.end());
  std::ranges::copy(computer.notes(), std::back_inserter(flight.notes));
  BoardReplay replayed;
  if (options.computer.on == "board") {
    replayed = board_replay(flight.log);
    flight.notes.push_back(replayed.note);
  }
  Chapters chapters{"report", 1, "computing the figures and writing files and page"};
  const report::Results results = report::results(flight, made_with(made_from, flight.seed, flight.changes));
  const std::filesystem::path folder = options.out.empty() ? usual_folder : std::filesystem::path{options.out};
  give_up_if_interrupted();
  const std::vector<std::string> written = report::write_results(flight, results, folder, made_from);
  chapters.end();
  const std::string where = text::printable(folder.string());
  std::string lines = fmt::format("  report   {}/report.html\n", where);
  for (const std::string& name : written) {
    lines += name.ends_with(".csv") ? fmt::format("  data     {}/{}\n", where, name) : "";
  }
  if (!flight.log.empty()) {
    lines += fmt::format("  log      {}/flight.ftl\n", where);
  }
  for (const std::string& name : computer.keep_diary(folder)) {
    lines += fmt::format("  board    {}/{}\n", where, name);
  }
  if (const std::string sent = lcm.finish(); !sent.empty()) {
    lines += fmt::format("  lcm      {}\n", sent);
  }
  if (const std::string shown = page.finish(); !shown.empty()) {
    lines += fmt::format("  page     {}\n", shown);
  }
  lines.pop_back();
  deliver(results.document, {.json = options.json, .last_line = lines});
  if (!computer.complaint().empty()) {
    throw hil::TargetError{fmt::format("not all was well on the board: {}; all of it is in {}/board_complaints.txt",
                                       computer.complaint(), where)};
  }
  if (options.computer.on == "board" && !flight.outages.empty() && !flight.outages.back().to_s) {
    throw hil::TargetError{"the processor of the board stopped, and nothing reset it"};
  }
  if (replayed.differs) {
    throw hil::TargetError{replayed.note};
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<FlyOptions>();
  add_scenario_options(verb, options->scenario);
  verb.option("--trajectory", options->trajectory,
              "A CSV file exported by RocketPy or OpenRocket: the rocket follows that path, and only the roll and the "
              "avionics are simulated")
      .offers(files)
      .value_name("FILE")
      .changes_result();
  verb.section("A flight of a campaign");
  auto campaign = verb.option("--campaign", options->campaign,
                              "Repeat a run of the campaign in this folder unchanged. SCENARIO is that of the campaign")
                      .offers(folders);
  auto run = verb.option("--run", options->run, "Number of the run in runs.csv, counted from 0").value_name("NUMBER");
  campaign.value_name("FOLDER").needs(run);
  run.range(0.0, 1e8 - 1.0).needs(campaign);
  verb.section("Where the avionics run");
  add_flight_computer_options(verb, options->computer);
  verb.section("Live");
  add_lcm_option(verb, options->lcm, "Publish the flight as LCM messages");
  add_page_options(verb, options->page);
  verb.flag("--realtime", options->realtime, "Fly no faster than real time; the files are the same");
  verb.section("Results");
  verb.option(
          "--out", options->out,
          "Folder for report.html, summary.json, flight.csv and flight.ftl, the record of the avionics. Some flights "
          "add tunnel.csv, trajectory.csv, turning.csv or without_control.csv. [out/SCENARIO; with --set or --seed, "
          "out/SCENARIO+CHANGES; for a run of a campaign, run_NUMBER in its folder]")
      .offers(folders);
  verb.flag("--json", options->json, "Print summary.json instead of the text");
  verb.examples(
      "Exit code 0: flown, whether or not the roll was held. For scripts, `outcome` in summary.json is one of held, "
      "off_command, outside_model, not_held, oscillates, cut_short, not_judged, no_control or ascent_failed.\n"
      "Examples:\n"
      "  fantail fly                                         the second launch, into out/tasha3_launch2\n"
      "  fantail fly tasha3_launch1 --set reference.kind=hold --set controller.canard_limit_deg=9\n"
      "                                                      would a wider canard limit have held the first launch?\n"
      "  fantail fly my_rocket.toml --seed 7 --out /tmp/try --json\n"
      "                                                      your own scenario, for a script\n"
      "  fantail fly tasha3_launch2 --set flight.motion=six_dof --set wind.speed_m_s=5 --set wind.from_deg=270\n"
      "                                                      in six degrees of freedom, with wind from the west\n"
      "  fantail fly my_rocket.toml --trajectory openrocket.csv\n"
      "                                                      on the path that another program has simulated\n"
      "  fantail fly --campaign out/campaign/tasha3_launch2 --run 17\n"
      "                                                      one run of a campaign again, with its report\n"
      "  fantail fly tasha3_launch2 --on emulator            on the emulated processor of the board: the same bytes\n"
      "  fantail fly --realtime --lcm udpm://239.255.76.67:7667\n"
      "                                                      in real time, for fantail watch in another terminal\n"
      "  fantail fly --realtime --page                       in real time, on a page for browsers");
  verb.action([options] { fly_and_report(*options); });
}

const VerbCode code{"fly", fill};

}  // namespace
}  // namespace fantail::tool
