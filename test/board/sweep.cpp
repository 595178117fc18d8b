// SPDX-License-Identifier: MIT
// What the pins of the flashed image do through every kind of reset in flight, at instants spread over a frame of the
// servos.
//
//   board_sweep IMAGE [INSTANTS [CYCLES_PER_INSTRUCTION]]
#include <cstdio>
#include <cstdlib>
#include <string>

#include "board_flight.hpp"
#include "input/scenario_file.hpp"

namespace {

using namespace fantail::board;

constexpr double frame_s = 3e-3;
constexpr std::uint32_t nowhere = 0x3000'0000;
constexpr std::uint32_t stack_bottom = 0x2000'0000;

struct Kind {
  const char* name;
  void (*event)(Board& board);
};

// `b .`: 0xE7FE
std::uint32_t endless_loop(const Image& image) {
  for (std::uint32_t at = 0; at + 1 < image.flash().size(); at += 2) {
    if (image.flash()[at] == std::byte{0xFE} && image.flash()[at + 1] == std::byte{0xE7}) {
      return Image::flash_begin + at;
    }
  }
  return nowhere;
}

std::uint32_t loop = 0;

constexpr Kind kinds[] = {
    {"hang", [](Board& board) { board.processor.jump(loop, false); }},
    {"hang, masked", [](Board& board) { board.processor.jump(loop, true); }},
    {"jump to nowhere", [](Board& board) { board.processor.jump(nowhere, false); }},
    {"stack overflow", [](Board& board) { board.processor.move_stack(stack_bottom + 8); }},
    {"crystal stops", [](Board& board) { board.chip.crystal_runs = false; }},
    {"brown-out", [](Board& board) { board.reset(ResetKind::brown_out); }},
    {"reset button", [](Board& board) { board.reset(ResetKind::pin); }},
};

}  // namespace

int main(int argc, char** argv) {
  const Image image{argv[1]};
  const int instants = argc > 2 ? std::atoi(argv[2]) : 1;
  Pace pace;
  pace.cycles_per_instruction = argc > 3 ? std::atof(argv[3]) : pace.cycles_per_instruction;
  loop = endless_loop(image);
  const auto scenario = fantail::input::load_scenario("tasha3_launch2", {});
  BoardFlight flight{image, scenario, pace};
  if (!flight.fly_to(fantail::core::Phase::controlling, 60.0)) {
    std::fputs("the flight did not come under control\n", stderr);
    return 1;
  }
  flight.fly_for(0.5);
  std::puts("event             at ms  restart  n  boot ms cut silence  widths us      servo  control  phase faults");
  for (const Kind& kind : kinds) {
    for (int i = 0; i < instants; ++i) {
      const Aftermath a = what_if(flight, kind.name, 2e-4 + frame_s * (i + 0.5) / instants, 0.4, kind.event);
      std::printf("%-16s %6.2f %9s %2d %7.2f %3d %7.2f %7.1f %7.1f %5.1f %7.1f %d/%d %s\n", a.event.data(), a.at_ms,
                  a.restart.data(), a.restarts, a.boot_ms, a.cut_pulses, a.silence_ms, a.narrowest_us, a.widest_us,
                  a.most_servo_deg, a.control_after_ms, a.phase, a.command_status, a.named.data());
      std::fflush(stdout);
    }
  }
}
