// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "avionics/flash_access.hpp"
#include "avionics/flight_region.hpp"
#include "avionics/log_tick_of.hpp"
#include "avionics/recorder.hpp"
#include "benchmark/logged_flight.hpp"
#include "flight/write_csv.hpp"
#include "flight_log/to_report.hpp"
#include "hal/sim/can_bus.hpp"
#include "hal/sim/flash.hpp"
#include "protocol/log_frame.hpp"

namespace fantail::benchmark {
namespace {

using ::benchmark::Counter;

Counter rate(double count) { return {count, Counter::kIsIterationInvariantRate}; }

// Finding every frame and checking its CRC-32C, and nothing else.
void log_check(::benchmark::State& state) {
  const LoggedFlight& logged = logged_flight();
  for ([[maybe_unused]] auto _ : state) {
    protocol::LogFrameReader reader{logged.bytes};
    std::size_t frames = 0;
    while (reader.next()) {
      frames += 1;
    }
    ::benchmark::DoNotOptimize(frames);
  }
  state.counters["bytes_per_s"] = rate(static_cast<double>(logged.bytes.size()));
}

void log_read(::benchmark::State& state) {
  const LoggedFlight& logged = logged_flight();
  for ([[maybe_unused]] auto _ : state) {
    ::benchmark::DoNotOptimize(flight_log::parse_log(logged.bytes, "benchmark"));
  }
  state.counters["bytes_per_s"] = rate(static_cast<double>(logged.bytes.size()));
  state.counters["ticks_per_s"] = rate(static_cast<double>(logged.flight.ticks.size()));
}

void log_replay(::benchmark::State& state) {
  const LoggedFlight& logged = logged_flight();
  for ([[maybe_unused]] auto _ : state) {
    if (flight_log::regenerate(logged.flight, *logged.flight.plan).differing > 0) {
      state.SkipWithError("the replay differs from the flight");
    }
  }
  state.counters["ticks_per_s"] = rate(static_cast<double>(logged.flight.ticks.size()));
}

// From the bytes of the log to the bytes of the table, replay included.
void log_to_csv(::benchmark::State& state) {
  const LoggedFlight& logged = logged_flight();
  for ([[maybe_unused]] auto _ : state) {
    const flight_log::LogFile file = flight_log::parse_log(logged.bytes, "benchmark");
    const flight_log::Flight& flight = file.flights[0];
    ::benchmark::DoNotOptimize(
        flight::csv(flight_log::to_report(flight, flight_log::regenerate(flight, *flight.plan))));
  }
  state.counters["time_per_flight"] = {1.0, Counter::kIsIterationInvariantRate | Counter::kInvert};
}

// The flight's own ticks, recorded again: packed, queued, framed and put into a flash that takes them at once.
void log_write(::benchmark::State& state) {
  const LoggedFlight& logged = logged_flight();
  const flight_log::Flight& flight = logged.flight;
  const core::FlightPlan& plan = *flight.plan;
  const avionics::SampleScales scales{
      .imu = {.rate_rad_s = flight.rate_scale_rad_s, .specific_force_m_s2 = flight.specific_force_scale_m_s2},
      .accelerometer_m_s2 = flight.accelerometer_scale_m_s2};
  hal::sim::CanWire wire;
  hal::sim::CanBus bus{wire};
  core::Autopilot law{plan};
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    hal::sim::Flash flash{{.size = 1U << 23U, .sector_size = 4096, .page_size = 256}};
    avionics::FlashAccess access{flash};
    avionics::FlightRegion region{access};
    while (!region.finished()) {
      region.update({});
    }
    avionics::Recorder recorder{region};
    recorder.take_plan(plan);
    state.ResumeTiming();
    for (std::size_t i = 0; i < flight.ticks.size(); ++i) {
      const protocol::LogTick& tick = flight.ticks[i].tick;
      const avionics::RawSamples raw = avionics::raw_samples_of(tick);
      const core::Inputs inputs = avionics::inputs_of(tick, scales, plan.canards);
      recorder.note({.raw = raw,
                     .scales = scales,
                     .inputs = inputs,
                     .record = *logged.regeneration.records[i],
                     .duration_before = tick.duration_before,
                     .bus = bus},
                    law);
      if (recorder.busy()) {
        recorder.update(tick.time);
      }
    }
    if (recorder.ticks_dropped() > 0 || flash.begun() < flight.ticks.size() / 4) {
      state.SkipWithError("not everything was recorded");
    }
  }
  state.counters["time_per_tick"] = {static_cast<double>(flight.ticks.size()),
                                     Counter::kIsIterationInvariantRate | Counter::kInvert};
}

}  // namespace
}  // namespace fantail::benchmark

BENCHMARK(fantail::benchmark::log_check)->Name("log_check");
BENCHMARK(fantail::benchmark::log_read)->Name("log_read");
BENCHMARK(fantail::benchmark::log_replay)->Name("log_replay");
BENCHMARK(fantail::benchmark::log_to_csv)->Name("log_to_csv");
BENCHMARK(fantail::benchmark::log_write)->Name("log_write");
