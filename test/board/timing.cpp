// SPDX-License-Identifier: MIT
// How long the ticks of the flashed image take in a flight, and how long it takes from a motion to the pulses that
// answer it, by the cycles that an instruction takes: a table, and 1 where a tick is lost at the pace that is believed.
//
//   board_timing IMAGE [CYCLES_PER_INSTRUCTION ...]
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "board_flight.hpp"
#include "in_fork.hpp"
#include "input/scenario_file.hpp"
#include "program.hpp"
#include "tick_meter.hpp"

namespace {

using namespace fantail;
using namespace fantail::board;

constexpr int motions = 200;
constexpr double between_motions_s = 13.31e-3;  ///< so that they fall on every instant of a tick and of a frame
constexpr double watched_s = 15e-3;
constexpr double jump_deg_s = 60.0;
constexpr double least_us = 3.0;  ///< by which a pulse that answers is another: five times the noise of the gyro
constexpr unsigned most_seconds = 600;
/// The clock of an IMU is another than that of the board: its samples drift through the ticks.
constexpr double imu_period_us = 1'002.3;

using Pulses = std::array<HeardPulse, 16>;

/// On the first line, from now on; with a roll that is faster from `motion_s` on.
Pulses flown_on(BoardFlight& flight, std::optional<double> motion_s) {
  Board& board = flight.board();
  std::size_t seen = board.chip.pulses().size();
  board.imu.before_sample = [&board, motion_s](core::Microseconds time) {
    if (motion_s && 1e-6 * static_cast<double>(time.count()) >= *motion_s) {
      board.imu.rate_deg_s[0] += jump_deg_s;
    }
  };
  for (double flown_s = 0.0; flown_s < watched_s; flown_s += 1e-3) {
    flight.step();
  }
  Pulses heard{};
  std::size_t count = 0;
  for (; seen < board.chip.pulses().size() && count < heard.size(); ++seen) {
    if (board.chip.pulses()[seen].line == 0) {
      heard[count++] = board.chip.pulses()[seen];
    }
  }
  return heard;
}

/// From a motion in the next tick, or soon after, to the beginning of the first pulse that answers it.
std::optional<double> answered_after_s(BoardFlight& flight, const Pulses& plain, double motion_s) {
  const auto moved = in_fork<Pulses>(most_seconds, [&] { return flown_on(flight, motion_s); });
  for (std::size_t i = 0; moved && i < plain.size(); ++i) {
    if (std::abs((*moved)[i].width_us - plain[i].width_us) > least_us) {
      return (*moved)[i].begin_s - motion_s;
    }
  }
  return std::nullopt;
}

struct Row {
  double longest_tick_us = 0.0;
  double written_us = 0.0;
  int lost = 0;
  int answered = 0;
  double least_s = 1e9, sum_s = 0.0, most_s = 0.0;
};

Row fly(const Image& image, const sim::Scenario& scenario, const Pace& pace) {
  std::optional<TickMeter> meter;
  BoardFlight flight{image, scenario, pace};
  meter.emplace(image, flight.board());
  flight.step();
  meter->forget();  // the one that had begun before
  flight.board().imu.period_us = imu_period_us;
  Row row;
  if (flight.fly_to(core::Phase::controlling, 60.0)) {
    flight.fly_for(0.5);
    for (int i = 0; i < motions; ++i) {
      flight.fly_for(between_motions_s);
      const double motion_s = flight.board().now_s() + 1e-3 + std::fmod(i * between_motions_s, 3e-3);
      const auto plain = in_fork<Pulses>(most_seconds, [&] { return flown_on(flight, {}); });
      if (const auto after_s = answered_after_s(flight, plain.value_or(Pulses{}), motion_s)) {
        row.answered += 1;
        row.sum_s += *after_s;
        row.least_s = std::min(row.least_s, *after_s);
        row.most_s = std::max(row.most_s, *after_s);
      }
    }
    (void)flight.fly_to(core::Phase::finished, 60.0);
  }
  row.longest_tick_us = 1e6 * meter->longest_s();
  row.written_us = 1e6 * meter->last_written_s();
  row.lost = static_cast<int>(flight.record().overruns);
  return row;
}

int measure(const Image& image, std::vector<Pace> paces) {
  const double believed = Pace{}.cycles_per_instruction;
  if (paces.empty()) {
    for (const double cycles : {1.0, believed, 2.5, 3.0, 3.5, 4.0}) {
      paces.push_back({.cycles_per_instruction = cycles});
    }
  }
  const auto scenario = input::load_scenario("tasha3_launch2", {});
  fmt::print(
      "| cycles an instruction | longest tick, us | pulses written by, us | ticks lost | motion to pulse, ms | mean | "
      "answered |\n"
      "|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const Pace& pace : paces) {
    const double cycles = pace.cycles_per_instruction;
    const auto row = in_fork<Row>(most_seconds, [&] { return fly(image, scenario, pace); });
    if (!row || row->answered == 0) {
      fmt::print("| {} | came to no end, or never under control |\n", cycles);
      good = good && cycles > believed;
      continue;
    }
    fmt::print("| {} | {:.0f} | {:.0f} | {} | {:.2f} to {:.2f} | {:.3f} | {} of {} |\n", cycles, row->longest_tick_us,
               row->written_us, row->lost, 1e3 * row->least_s, 1e3 * row->most_s, 1e3 * row->sum_s / row->answered,
               row->answered, motions);
    std::fflush(stdout);
    good = good && (cycles > believed || (row->lost == 0 && row->answered == motions));
  }
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program(argc, argv, 1, 20, "board_timing IMAGE [CYCLES_PER_INSTRUCTION ...]", [&] {
    std::vector<Pace> paces;
    for (int i = 2; i < argc; ++i) {
      paces.push_back(pace_word(argv[i]));
    }
    return measure(Image{argv[1]}, paces);
  });
}
