// SPDX-License-Identifier: MIT
#include "device_fault.hpp"

#include <utility>

namespace fantail::board {
namespace {

using fantail::devices::Answers;

using Which = std::function<devices::SpiSlave&(Board& board)>;

struct OnBus {
  const char* name;
  Which which;
  bool is_named = true;
  bool needs_all_sensors = false;
};

const std::vector<OnBus>& on_bus() {
  static const std::vector<OnBus> all{
      {"IMU", [](Board& board) -> devices::SpiSlave& { return board.imu; }},
      {"second IMU", [](Board& board) -> devices::SpiSlave& { return board.second_imu; }, true, true},
      {"accelerometer", [](Board& board) -> devices::SpiSlave& { return board.accelerometer; }},
      {"barometer", [](Board& board) -> devices::SpiSlave& { return board.barometer; }, true, true},
      {"flash", [](Board& board) -> devices::SpiSlave& { return board.flash; }},
      {"encoder 1", [](Board& board) -> devices::SpiSlave& { return board.encoders[0]; }},
      {"encoder 2", [](Board& board) -> devices::SpiSlave& { return board.encoders[1]; }},
      {"encoder 3", [](Board& board) -> devices::SpiSlave& { return board.encoders[2]; }},
      {"encoder 4", [](Board& board) -> devices::SpiSlave& { return board.encoders[3]; }},
  };
  return all;
}

// Noise of one bit in a thousand is what drivers and gates are made to live with: it need not be told.
struct Way {
  const char* name;
  Answers answers;
  bool is_named = true;
};
constexpr Way ways[] = {
    {"dead, line low", Answers::none}, {"dead, line high", Answers::high},      {"late by a byte", Answers::late},
    {"frozen", Answers::repeated},     {"flips bits", Answers::flipped, false}, {"garbage", Answers::garbage},
};

devices::CanModel& can(Board& board) { return board.chip.domain->can; }

// Nearly all of a bus of 1 Mbit/s: a place in eight is left for the others.
void flood(Board& board) {
  static std::uint32_t id = 0;
  for (int i = 0; i < 7 && !board.bus_is_full(); ++i) {
    board.send({.id = id++ % 0x800U, .length = 8, .data = {0xFF, 0x5A, 0, 0xFF, 0xA5, 1, 2, 3}});
  }
}

// One that runs goes on: nothing but a start finds out.
void reset_without_pll(Board& board) {
  const auto at = [&board](double delay_s, std::function<void()> what) {
    board.timeline.schedule(board.timeline.add(std::move(what)), board.now_s() + delay_s);
  };
  at(100e-6, [&board] { board.reset(ResetKind::watchdog); });
  at(200e-6, [&board] { board.chip.pll_locks = false; });
}

void add_chips(std::vector<DeviceFault>& all) {
  // The bus cannot tell of itself. In flight nobody needs it, nor the voltage of the battery.
  const auto add = [&all](const char* device, const char* how, std::function<void(Board&)> every_ms) {
    all.push_back({.device = device,
                   .how = how,
                   .is_named = false,
                   .begin = [every_ms](Board& board, BoardWires&) { every_ms(board); },
                   .go_on = every_ms});
  };
  add("CAN", "controller dead", [](Board& board) { can(board).dead = true; });
  add("CAN", "unheard", [](Board& board) { can(board).heard = false; });
  add("CAN", "line dominant", [](Board& board) { can(board).stuck_bus = true; });
  add("CAN", "bus off", [](Board& board) { can(board).go_bus_off(); });
  add("CAN", "flooded", flood);
  add("battery", "7 V", [](Board& board) { board.battery_v = 7.0; });
  add("battery", "unconnected", [](Board& board) { board.battery_v = 0.0; });
  add("converter", "does not end", [](Board& board) { board.chip.domain->converter.ends = false; });
}

}  // namespace

std::vector<DeviceFault> device_faults() {
  std::vector<DeviceFault> all;
  for (const OnBus& device : on_bus()) {
    for (const Way& way : ways) {
      all.push_back({.device = device.name,
                     .how = way.name,
                     .is_named = device.is_named && way.is_named,
                     .needs_all_sensors = device.needs_all_sensors,
                     .begin = [which = device.which, answers = way.answers](Board& board, BoardWires& wires) {
                       wires.of(which(board)).answers = answers;
                     }});
    }
  }
  add_chips(all);
  all.push_back({.device = "crystal", .how = "does not run", .begin = [](Board& board, BoardWires&) {
                   board.chip.crystal_runs = false;
                 }});
  all.push_back({.device = "PLL",
                 .how = "does not lock",
                 .begin = [](Board& board, BoardWires&) { board.chip.pll_locks = false; },
                 .in_flight = reset_without_pll});
  all.push_back({.device = "none", .how = "", .is_named = false, .begin = [](Board&, BoardWires&) {}});
  return all;
}

}  // namespace fantail::board
