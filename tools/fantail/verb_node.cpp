// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/lcm_output.hpp"
#include "fantail/offers.hpp"
#include "fantail/page_output.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "fantail/world_in_real_time.hpp"
#include "hal/linux/can_bus.hpp"
#include "hal/linux/console.hpp"
#include "hal/linux/entropy.hpp"
#include "hal/linux/file_flash.hpp"
#include "sim/scenario.hpp"
#include "telemetry/tick_reporter.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

// The flash of a board that is simulated on this PC; made, with its folder, when it is not there.
std::unique_ptr<hal::on_linux::FileFlash> open_node_flash(const std::filesystem::path& file) {
  if (file.has_parent_path()) {
    std::error_code ignored;  // the file itself says what is wrong
    std::filesystem::create_directories(file.parent_path(), ignored);
  }
  try {
    return std::make_unique<hal::on_linux::FileFlash>(file);
  } catch (const std::runtime_error& error) {
    throw text::OutputError{error.what()};
  }
}

struct NodeOptions {
  ScenarioOptions scenario;
  std::string interface;
  std::string flash;
  std::string lcm;
  PageOptions page;
  std::optional<double> seconds;
};

// Identifiers 0 to 0xFF: what is said to the avionics, and not what others of its kind report.
const std::vector<hal::on_linux::CanFilter> to_the_avionics{{.id = 0, .mask = 0x700}};

std::filesystem::path flash_file(const NodeOptions& options, const sim::Scenario& scenario) {
  return options.flash.empty() ? std::filesystem::path{"out"} / scenario.name / "flash.bin"
                               : std::filesystem::path{options.flash};
}

void run_node(const NodeOptions& options) {
  const sim::Scenario scenario = load(options.scenario);
  // Nothing here can break what is the PC's.
  refuse_faults(scenario, {sim::Device::bus, sim::Device::flash},
                "as a node, which uses the bus and flash of this machine");
  hal::on_linux::CanBus bus{options.interface, to_the_avionics};
  const auto flash = open_node_flash(flash_file(options, scenario));
  hal::on_linux::Console console;
  hal::on_linux::Entropy entropy;
  LcmOutput lcm{options.lcm};
  PageOutput page{options.page,
                  {.name = scenario.name + " on " + options.interface},
                  fmt::format("fantail node {} --can {} {}", text::shell_word(options.scenario.scenario),
                              text::shell_word(options.interface), options.page.words())};
  const bool is_told = lcm.is_on() || page.is_on();
  telemetry::LimitTap tap{bus};
  PadEar ear{is_told ? static_cast<hal::CanBus&>(tap) : bus};
  WorldInRealTime node{scenario, {.can_bus = ear, .flash = *flash, .console = console, .entropy = entropy}, ear};
  show("{} ({}) on {}; type help for the commands at the pad, Ctrl-C ends\n", scenario.name, scenario.vehicle.name,
       options.interface);
  std::fflush(stdout);
  node.run(options.seconds, [&](const core::TickRecord& record, WorldInRealTime::Clock::duration took) {
    if (const std::string messages = node.pace().take_messages(); !messages.empty()) {
      say(messages);
    }
    if (is_told && !node.world().is_down()) {
      const hal::CanCounters counters = bus.counters();
      const telemetry::Surroundings surroundings{
          .limits_rad = tap.limits_rad(),
          .tick_s = std::chrono::duration<double>{took}.count(),
          .late_ticks = node.pace().late(),
          .bus = telemetry::Health::Bus{
              .state = bus.state(), .unsent = counters.unsent, .overrun = counters.overrun, .errors = counters.errors}};
      lcm.report(record, surroundings);
      page.report(record, surroundings);
    }
  });
  show_text(node.summary(bus.counters()));
  if (const std::string sent = lcm.finish(); !sent.empty()) {
    show("{}\n", sent);
  }
  if (const std::string shown = page.finish(); !shown.empty()) {
    show("page: {}\n", shown);
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<NodeOptions>();
  add_scenario_options(verb, options->scenario);
  add_can_option(verb, options->interface);
  verb.option(
          "--flash", options->flash,
          "File for the flash of the board, kept between runs: plan, power-up count, flights [out/SCENARIO/flash.bin]")
      .offers(files)
      .value_name("FILE");
  add_lcm_option(verb, options->lcm, "Publish the flight as LCM messages");
  add_page_options(verb, options->page);
  add_end_option(verb, options->seconds);
  verb.examples(
      "Examples:\n"
      "  fantail node bench_healthy --can vcan0             a rocket on the bench, for fantail bench\n"
      "  fantail node bench_canard3_reversed --can vcan0    the same rocket with a fault to find\n"
      "  fantail node tasha3_launch2 --can can0 --for 60    with a real adapter: rehearse arming, type switch close "
      "and ignite");
  verb.action([options] { run_node(*options); });
}

const VerbCode code{"node", fill};

}  // namespace
}  // namespace fantail::tool
