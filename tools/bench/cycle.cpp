// SPDX-License-Identifier: MIT
#include "bench/cycle.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "bench/perform.hpp"
#include "bench/trace.hpp"

namespace fantail::bench {
namespace {

std::size_t void_laps(const Cycle& cycle) {
  return static_cast<std::size_t>(std::ranges::count_if(cycle.laps, [](const Lap& lap) { return !lap.measured(); }));
}

std::size_t failing_laps_at_end(const Cycle& cycle) {
  const auto well =
      std::find_if(cycle.laps.rbegin(), cycle.laps.rend(), [](const Lap& lap) { return lap.measured() && lap.passed; });
  return static_cast<std::size_t>(
      std::count_if(cycle.laps.rbegin(), well, [](const Lap& lap) { return lap.measured(); }));
}

void note_battery(std::optional<double>& lowest_v, const link::AvionicsLink& link) {
  const auto& board = link.newest<protocol::BoardReport>();
  if (board && board->message.battery_mv) {
    const double now_v = 1e-3 * static_cast<double>(*board->message.battery_mv);
    lowest_v = std::min(lowest_v.value_or(now_v), now_v);
  }
}

}  // namespace

Lap lap_of(const Sheet& sheet) {
  Lap lap{.passed = sheet.judgement() == Judgement::pass};
  if (sheet.judgement() == Judgement::none) {
    lap.doubt = sheet.doubts.front();
  }
  for (const CanardResult& result : sheet.canards) {
    const Figures& f = result.together->figures;
    lap.canards[result.canard] = {.lag_s = f.lag_s,
                                  .tracking_rms_rad = f.tracking_rms_rad,
                                  .tracking_error_rad = f.tracking_error_rad,
                                  .passed = result.passed()};
  }
  if (!lap.passed) {
    lap.conclusions = conclusions(sheet);
  }
  return lap;
}

void perform_laps(Cycle& cycle, const Exercise& lap, link::Session& session, link::AvionicsLink& link,
                  const std::function<void(double)>& progress) {
  cycle.lap_s = lap.duration_s();
  std::optional<std::int64_t> first_tick;
  while (cycle.laps.size() < cycle.planned_laps) {
    const double done_s = static_cast<double>(cycle.laps.size()) * cycle.lap_s;
    std::optional<double> battery_v;
    Lap measured;
    double begin_s = cycle.laps.empty() ? 0.0 : cycle.laps.back().begin_s + cycle.lap_s;
    try {
      const link::Recording recording = perform(lap, session, link, [&](double in_lap_s) {
        note_battery(battery_v, link);
        progress(done_s + in_lap_s);
      });
      if (!recording.ticks().empty()) {
        const std::int64_t tick = recording.ticks().front().number;
        first_tick = first_tick.value_or(tick);
        begin_s = tick_s * static_cast<double>(tick - *first_tick);
      }
      session.wait();  // the examination takes some 10 ms: a heartbeat before it and one after it
      cycle.heading.board = link.board();
      measured = lap_of(examine(recording, lap, cycle.tolerances, cycle.heading));
      session.wait();
    } catch (const Unmeasured& unmeasured) {
      measured.doubt = unmeasured.what();
    }
    measured.begin_s = begin_s;
    measured.battery_v = battery_v;
    cycle.laps.push_back(measured);
    if (static_cast<double>(void_laps(cycle)) > most_void_share * static_cast<double>(cycle.planned_laps)) {
      throw Unmeasured{
          fmt::format("the canards are not judged: {} of {} laps could not be measured. Reason for the last one: {}",
                      void_laps(cycle), cycle.laps.size(), measured.doubt)};
    }
    if (failing_laps_at_end(cycle) >= most_failing_laps && cycle.laps.size() < cycle.planned_laps) {
      cycle.ended_because = fmt::format("{} laps in a row failed", most_failing_laps);
      return;
    }
  }
}

}  // namespace fantail::bench
