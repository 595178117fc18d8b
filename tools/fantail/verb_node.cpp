// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "fantail/interrupt.hpp"
#include "fantail/pad_commands.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/verbs.hpp"
#include "hal/linux/can_bus.hpp"
#include "hal/linux/console.hpp"
#include "hal/linux/entropy.hpp"
#include "hal/linux/file_flash.hpp"
#include "sim/scenario.hpp"
#include "sim/world.hpp"

namespace fantail::tool {
namespace {

using SteadyClock = std::chrono::steady_clock;
using std::chrono::milliseconds;

struct NodeOptions {
  ScenarioOptions scenario;
  std::string interface;
  std::string flash;
  std::optional<double> seconds;
};

// What a PC has missed is caught up, but not more than this: the avionics counts its own ticks, and a bench that stood
// still on the same PC would look silent to it.
constexpr milliseconds most_debt{30};
constexpr milliseconds worth_saying{1'000};
constexpr int ticks_between_looks = 20;

// Identifiers 0 to 0xFF: what is said to the avionics, and not what others of its kind report.
const std::vector<hal::on_linux::CanFilter> to_the_avionics{{.id = 0, .mask = 0x700}};

std::filesystem::path flash_file(const NodeOptions& options, const sim::Scenario& scenario) {
  std::filesystem::path file = options.flash.empty() ? std::filesystem::path{"out"} / scenario.name / "flash.bin"
                                                     : std::filesystem::path{options.flash};
  if (file.has_parent_path()) {
    std::error_code ignored;  // the file itself says what is wrong
    std::filesystem::create_directories(file.parent_path(), ignored);
  }
  return file;
}

/// The avionics in real time, with a simulated rocket behind it.
class Node {
 public:
  Node(const sim::Scenario& scenario, const sim::BoardPorts& ports) : world_{scenario, ports} {}

  void run(const std::optional<double>& seconds) {
    const auto begin = SteadyClock::now();
    auto due = begin;
    for (std::int64_t tick = 0;; ++tick) {
      if (tick % ticks_between_looks == 0 && (!obey_hands() || take_interrupt())) {
        break;
      }
      if (seconds && SteadyClock::now() - begin >= std::chrono::duration<double>{*seconds}) {
        break;
      }
      std::this_thread::sleep_until(due);
      late_ += SteadyClock::now() > due + milliseconds{1} ? 1 : 0;
      (void)world_.tick();
      world_.advance();
      ticks_ += 1;
      due += milliseconds{1};
      if (const auto debt = SteadyClock::now() - due; debt > most_debt) {
        if (debt > worth_saying) {
          say("this PC has slept; the rocket's time goes on from here\n");
        }
        due += debt;
      }
    }
  }

  [[nodiscard]] std::int64_t ticks() const { return ticks_; }
  [[nodiscard]] std::int64_t late() const { return late_; }

 private:
  // False: the person has had enough.
  bool obey_hands() {
    while (const auto command = hands_.next()) {
      switch (*command) {
        case PadCommand::close_switch: world_.set_arm_switch(true); break;
        case PadCommand::open_switch: world_.set_arm_switch(false); break;
        case PadCommand::ignite: world_.ignite(); break;
        case PadCommand::help: say(PadCommands::help()); break;
        case PadCommand::quit: return false;
      }
    }
    return true;
  }

  sim::World world_;
  PadCommands hands_;
  std::int64_t ticks_ = 0;
  std::int64_t late_ = 0;
};

void run_node(const NodeOptions& options) {
  const sim::Scenario scenario = load(options.scenario);
  hal::on_linux::CanBus bus{options.interface, to_the_avionics};
  hal::on_linux::FileFlash flash{flash_file(options, scenario)};
  hal::on_linux::Console console;
  hal::on_linux::Entropy entropy;
  Node node{scenario, {.can_bus = bus, .flash = flash, .console = console, .entropy = entropy}};
  fmt::print("{} ({}) on {}; type help for what the hands at the pad can do, Ctrl-C ends\n", scenario.name,
             scenario.vehicle.name, options.interface);
  std::fflush(stdout);
  node.run(options.seconds);
  const hal::CanCounters counters = bus.counters();
  fmt::print(
      "ended after {:.1f} s of the rocket's time; {} of {} ticks came more than a millisecond late; frames: {} sent, "
      "{} received, {} found no room\n",
      1e-3 * static_cast<double>(node.ticks()), node.late(), node.ticks(), counters.sent, counters.received,
      counters.unsent);
}

}  // namespace

void add_node(CLI::App& program) {
  auto* verb = program.add_subcommand(
      "node", "Run the avionics on this PC in real time: a simulated rocket behind it, a real CAN bus in front");
  auto options = std::make_shared<NodeOptions>();
  add_scenario_options(*verb, options->scenario);
  verb->add_option("--can", options->interface, "CAN interface, for example vcan0 or can0")
      ->required()
      ->type_name("IF");
  verb->add_option("--flash", options->flash,
                   "What the board keeps when it is switched off: its plan and the count of its power-ups "
                   "[out/SCENARIO/flash.bin]")
      ->type_name("FILE");
  verb->add_option("--for", options->seconds, "End after so many seconds; without it, by Ctrl-C")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("SECONDS");
  verb->footer(
      "Examples:\n"
      "  fantail node bench_healthy --can vcan0             a rocket on the bench, for fantail bench\n"
      "  fantail node bench_canard3_reversed --can vcan0    the same with a fault for the bench to find\n"
      "  fantail node tasha3_launch2 --can can0 --for 60    with a real adapter: rehearse arming, type switch close "
      "and ignite");
  verb->callback([options] { run_node(*options); });
}

}  // namespace fantail::tool
