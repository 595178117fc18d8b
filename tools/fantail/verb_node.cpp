// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "fantail/lcm_output.hpp"
#include "fantail/offers.hpp"
#include "fantail/pad_script.hpp"
#include "fantail/page_output.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "fly/pace.hpp"
#include "hal/linux/can_bus.hpp"
#include "hal/linux/console.hpp"
#include "hal/linux/entropy.hpp"
#include "hal/linux/file_flash.hpp"
#include "input/fault_file.hpp"
#include "sim/scenario.hpp"
#include "sim/world.hpp"
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

using SteadyClock = std::chrono::steady_clock;

struct NodeOptions {
  ScenarioOptions scenario;
  std::string interface;
  std::string flash;
  std::string lcm;
  PageOptions page;
  std::optional<double> seconds;
};

constexpr int ticks_between_looks = 20;
// Identifiers 0 to 0xFF: what is said to the avionics, and not what others of its kind report.
const std::vector<hal::on_linux::CanFilter> to_the_avionics{{.id = 0, .mask = 0x700}};

std::filesystem::path flash_file(const NodeOptions& options, const sim::Scenario& scenario) {
  return options.flash.empty() ? std::filesystem::path{"out"} / scenario.name / "flash.bin"
                               : std::filesystem::path{options.flash};
}

/// The avionics in real time, with a simulated rocket behind it.
class Node {
 public:
  Node(const sim::Scenario& scenario, const sim::BoardPorts& ports, const PadEar& ear)
      : world_{scenario, ports}, script_{ear} {}

  /// Called after every tick, with the time that it took.
  using Observe = std::function<void(const core::TickRecord& record, SteadyClock::duration took)>;
  void observe(Observe observe) { observe_ = std::move(observe); }

  void run(const std::optional<double>& seconds) {
    const auto begin = SteadyClock::now();
    pace_ = fly::Pace{begin};
    for (auto now = begin;; now = SteadyClock::now()) {
      if (ticks_ % ticks_between_looks == 0 && (!obey_pad_commands() || take_interrupt() ||
                                                (seconds && now - begin >= std::chrono::duration<double>{*seconds}))) {
        break;
      }
      if (const auto due = pace_.next(now); now < due) {
        std::this_thread::sleep_until(due);
      }
      if (const std::string messages = pace_.take_messages(); !messages.empty()) {
        say(messages);
      }
      world_.set_ticks_left_out(pace_.ticks_left_out());
      const auto tick_begin = SteadyClock::now();
      const core::TickRecord& record = world_.tick();
      if (observe_ && !world_.is_down()) {
        observe_(record, SteadyClock::now() - tick_begin);
      }
      world_.advance();
      ticks_ += 1;
    }
  }

  [[nodiscard]] std::int64_t ticks() const { return ticks_; }
  [[nodiscard]] const fly::Pace& pace() const { return pace_; }

 private:
  // False after "quit".
  bool obey_pad_commands() {
    while (const auto command = script_.next()) {
      switch (*command) {
        case PadCommand::close_switch: world_.set_arm_switch(true); break;
        case PadCommand::open_switch: world_.set_arm_switch(false); break;
        case PadCommand::press_abort: world_.press_abort(true); break;
        case PadCommand::release_abort: world_.press_abort(false); break;
        case PadCommand::ignite: world_.ignite(); break;
        case PadCommand::help: say(pad_commands_help()); break;
        case PadCommand::quit: return false;
        case PadCommand::await_session:
        case PadCommand::await_self_test: break;  // done by the script itself
      }
    }
    return true;
  }

  sim::World world_;
  PadScript script_;
  Observe observe_;
  fly::Pace pace_{SteadyClock::now()};
  std::int64_t ticks_ = 0;
};

/// Bus and flash of a node are the PC's, and nothing here can break them.
void check_faults(const sim::Scenario& scenario) {
  for (const sim::Fault& fault : scenario.faults) {
    if (fault.device == sim::Device::bus || fault.device == sim::Device::flash) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        fmt::format("{}: faults.device = \"{}\" cannot be run as a node, which uses the bus and flash "
                                    "of this machine; allowed: the other devices",
                                    scenario.name, input::name(fault.device))};
    }
  }
}

void run_node(const NodeOptions& options) {
  const sim::Scenario scenario = load(options.scenario);
  check_faults(scenario);
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
  Node node{scenario, {.can_bus = ear, .flash = *flash, .console = console, .entropy = entropy}, ear};
  show("{} ({}) on {}; type help for the commands at the pad, Ctrl-C ends\n", scenario.name, scenario.vehicle.name,
       options.interface);
  std::fflush(stdout);
  if (is_told) {
    node.observe([&](const core::TickRecord& record, SteadyClock::duration took) {
      const hal::CanCounters counters = bus.counters();
      const telemetry::Surroundings surroundings{
          .limits_rad = tap.limits_rad(),
          .tick_s = std::chrono::duration<double>{took}.count(),
          .late_ticks = node.pace().late(),
          .bus = telemetry::Health::Bus{
              .state = bus.state(), .unsent = counters.unsent, .overrun = counters.overrun, .errors = counters.errors}};
      lcm.report(record, surroundings);
      page.report(record, surroundings);
    });
  }
  node.run(options.seconds);
  const hal::CanCounters counters = bus.counters();
  show(
      "ended after {:.1f} s of the rocket's time; {} of {} ticks ended more than a millisecond late; {:.1f} s were "
      "left out. Frames: {} sent, {} received, {} dropped\n",
      1e-3 * static_cast<double>(node.ticks()), node.pace().late(), node.ticks(),
      std::chrono::duration<double>{node.pace().left_out()}.count(), counters.sent, counters.received, counters.unsent);
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
