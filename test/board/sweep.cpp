// SPDX-License-Identifier: MIT
// What the pins of the flashed image do through every kind of reset in flight, at instants spread over a frame of the
// servos: a table, and 1 where a row is not as it must be.
//
//   board_sweep IMAGE INSTANTS [CYCLES_PER_INSTRUCTION]
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "board_flight.hpp"
#include "input/scenario_file.hpp"
#include "program.hpp"
#include "resets.hpp"

namespace {

using namespace fantail;
using namespace fantail::board;

constexpr double frame_s = 3e-3;
constexpr double first_s = 0.2e-3;
constexpr double time_s = 0.4;
constexpr double centre_us = 1500.0;
// By which a canard of any plan may be off its centre, and what the processor's own oscillator may be off.
constexpr double most_pulse_us = 800.2 * 1.01;

/// Of all instants of one kind.
struct Row {
  int flown = 0, cut = 0, resumed = 0;
  double boot_ms = 0.0, silence_ms = 0.0, astray_deg = 0.0, back_ms = 0.0, pulse_us = 0.0;
  bool came_to_an_end = true;

  void add(const Aftermath& after) {
    came_to_an_end = came_to_an_end && after.is_there;
    flown += 1;
    cut += after.cut_pulses > 0 ? 1 : 0;
    resumed += after.control_after_ms >= 0.0 ? 1 : 0;
    boot_ms = std::max(boot_ms, after.boot_ms);
    silence_ms = std::max(silence_ms, after.silence_ms);
    astray_deg = std::max(astray_deg, after.most_astray_deg);
    back_ms = std::max(back_ms, after.control_after_ms);
    pulse_us = std::max({pulse_us, std::abs(after.narrowest_us - centre_us), std::abs(after.widest_us - centre_us)});
  }
  [[nodiscard]] bool is_as_it_must_be(bool flies_on) const {
    return came_to_an_end && pulse_us <= most_pulse_us && resumed == (flies_on ? flown : 0);
  }
};

int sweep(const Image& image, int instants, const Pace& pace) {
  const auto scenario = input::load_scenario("tasha3_launch2", {});
  BoardFlight flight{image, scenario, pace};
  if (!flight.fly_to(core::Phase::controlling, 60.0)) {
    fmt::print(stderr, "the flight did not come under control\n");
    return 1;
  }
  flight.fly_for(0.5);
  fmt::print("| after | start ms | silence ms | cut | astray deg | control ms |\n|---|---|---|---|---|---|\n");
  bool as_it_must_be = true;
  for (const ResetCase& each : all_resets(image)) {
    Row row;
    for (int i = 0; i < instants; ++i) {
      row.add(what_if(flight, std::string{each.name}, first_s + frame_s * (i + 0.5) / instants, time_s, each.happens));
    }
    const bool good = row.is_as_it_must_be(each.flies_on);
    as_it_must_be = as_it_must_be && good;
    fmt::print("| {} | {:.1f} | {:.1f} | {} of {} | {:.1f} | {} |{}\n", each.name, row.boot_ms, row.silence_ms, row.cut,
               row.flown, row.astray_deg, row.resumed > 0 ? fmt::format("{:.0f}", row.back_ms) : "none",
               good ? ""
                    : fmt::format(" NOT AS IT MUST BE: {} resumed, pulses to {:.0f} us of the centre", row.resumed,
                                  row.pulse_us));
    std::fflush(stdout);
  }
  return as_it_must_be ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program(argc, argv, 2, 3, "board_sweep IMAGE INSTANTS [CYCLES_PER_INSTRUCTION]", [&] {
    return sweep(Image{argv[1]}, whole_word(argv[2], "INSTANTS", 1), argc > 3 ? pace_word(argv[3]) : Pace{});
  });
}
