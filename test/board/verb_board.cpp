// SPDX-License-Identifier: MIT
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "fantail/offers.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "fantail/world_in_real_time.hpp"
#include "hal/linux/can_bus.hpp"
#include "hal/linux/entropy.hpp"
#include "hal/sim/flash.hpp"
#include "hil/emulator.hpp"
#include "image_identity.hpp"
#include "switched_board.hpp"

namespace fantail::tool {
namespace {

using namespace std::chrono_literals;

struct BoardOptions {
  ScenarioOptions scenario{.scenario = "bench_healthy", .seed = {}, .changes = {}};
  std::string interface;
  std::string image;
  bool empty_flash = false;
  std::optional<double> seconds;
};

/// What the board says at its serial port, as it comes.
class ShownConsole final : public hal::Console {
 public:
  void write(std::string_view text) override { (void)show_live(std::string{text}); }
};

/// Tells every ten seconds at most that the board falls behind the clock on the wall.
class Lag {
 public:
  explicit Lag(const fly::Pace& pace) : pace_{pace} {}

  void tell() {
    const auto now = WorldInRealTime::Clock::now();
    if (pace_.left_out() > told_ && now - told_at_ >= 10s) {
      say(fmt::format("this PC is too slow or too busy: the board stood still for {} ms more, {:.2f} s in all\n",
                      (pace_.left_out() - told_) / 1ms, std::chrono::duration<double>{pace_.left_out()}.count()));
      told_ = pace_.left_out();
      told_at_ = now;
    }
  }

 private:
  const fly::Pace& pace_;
  fly::Pace::Duration told_{};
  WorldInRealTime::Clock::time_point told_at_{};
};

std::string status_of(board::SwitchedBoard& board, const core::TickRecord& record) {
  if (board.board() == nullptr) {
    return "off\n";
  }
  const hal::sim::WorldSide& hardware = board.hardware();
  std::string text = fmt::format(
      "on for {:.1f} s, {}; arm switch {}, abort contact {}; crystal {}; pulses", board.board()->now_s(),
      core::name(record.phase), hardware.arm_switch_closed ? "closed" : "open",
      hardware.abort_contact_closed ? "closed" : "open", board.board()->chip.crystal_runs ? "runs" : "stopped");
  for (const auto& pulse : hardware.pulses) {
    text += pulse ? fmt::format(" {:.1f}", 1e-3 * static_cast<double>(pulse->count())) : " none";
  }
  return text + " us\n";
}

void run_board(const BoardOptions& options) {
  const sim::Scenario scenario = load(options.scenario);
  using sim::Device;
  refuse_faults(scenario, {Device::bus, Device::flash, Device::supply, Device::memory, Device::processor},
                "on a virtual board, which has its own bus, flash, supply, memory and processor");
  const board::Image image{options.image.empty() ? hil::built_image("fantail-stm32f405.elf")
                                                 : std::filesystem::path{options.image}};
  const board::ImageIdentity identity = board::identity_of(image, {});
  hal::on_linux::CanBus bus{options.interface};
  PadEar ear{bus};
  hal::sim::Flash of_the_world{sim::World::small_flash};
  ShownConsole console;
  hal::on_linux::Entropy entropy;
  board::SwitchedBoard* board = nullptr;
  core::TickRecord record{};
  const auto when_on = [&](const auto& act) {
    if (board->board() != nullptr) {
      act(*board->board());
    } else {
      say("the board is off: power on comes first\n");
    }
  };
  WorldInRealTime rocket{
      scenario,
      {.can_bus = ear, .flash = of_the_world, .console = console, .entropy = entropy},
      ear,
      [&](const core::FlightPlan& plan, const sim::BoardPorts& ports, const avionics::Identity& /*world*/) {
        auto made = std::make_unique<board::SwitchedBoard>(
            image, options.empty_flash ? board::new_flash() : board::flash_with(plan), ports);
        board = made.get();
        return made;
      },
      {{"power off", "switch the board off: it keeps its flash", [&] { board->switch_off(); }},
       {"power on", "switch the board on", [&] { board->switch_on(); }},
       {"reset", "press the reset button", [&] { when_on([](board::Board& it) { it.reset(board::ResetKind::pin); }); }},
       {"crystal stop", "stop the crystal until power off",
        [&] { when_on([](board::Board& it) { it.set_crystal(false); }); }},
       {"status", "tell how the board is", [&] {
          show_text(status_of(*board, record));
          std::fflush(stdout);
        }}}};
  show("fantail-stm32f405 {}, git {}, on a virtual board in {} ({}) on {}; type help for the commands, Ctrl-C ends\n",
       identity.version, identity.git_hash, scenario.name, scenario.vehicle.name, options.interface);
  std::fflush(stdout);
  board->switch_on();
  Lag lag{rocket.pace()};
  rocket.run(options.seconds, [&](const core::TickRecord& newest, WorldInRealTime::Clock::duration /*took*/) {
    record = newest;
    lag.tell();
  });
  show_text(rocket.summary(bus.counters()));
}

void fill(const Verb& verb) {
  auto options = std::make_shared<BoardOptions>();
  add_scenario_options(verb, options->scenario);
  add_can_option(verb, options->interface);
  verb.option("--image", options->image, "The image [build/arm/fantail-stm32f405.elf of the sources]")
      .offers(files)
      .value_name("FILE");
  verb.flag("--empty-flash", options->empty_flash,
            "As a new board [its flash holds the plan of the scenario]. What is written is lost when the program ends");
  add_end_option(verb, options->seconds);
  verb.examples(
      "Standard output shows the console of the board. Commands are read from standard input: help lists them.\n"
      "Examples:\n"
      "  fantail board --can vcan0 --empty-flash      a new board, just flashed\n"
      "  fantail board tasha3_launch2 --can vcan0     rehearse arming, type switch close and ignite");
  verb.action([options] { run_board(*options); });
}

const VerbCode code{"board", fill};

}  // namespace
}  // namespace fantail::tool
