// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "input/scenario_file.hpp"
#include "sim/world.hpp"

namespace fantail::benchmark {
namespace {

// A whole flight from power-up on the pad to a second after apogee: sensors, avionics, servos, air and rocket. Nothing
// is written anywhere, and the scenario is loaded beforehand.
void whole_flight(::benchmark::State& state, sim::FlightMotion motion) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.motion = motion;
  if (motion == sim::FlightMotion::six_dof) {
    scenario.wind = {.speed_m_s = 5.0, .exponent = 0.14, .turbulence = 0.1};
  }
  double milliseconds = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    sim::World world{scenario};
    while (!world.over()) {
      const core::TickRecord* record = &world.tick();
      ::benchmark::DoNotOptimize(record);
      world.advance();
    }
    milliseconds = 1e-3 * static_cast<double>(world.now().count());
  }
  using ::benchmark::Counter;
  state.counters["time_per_world_ms"] = Counter(milliseconds, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["times_real_time"] = Counter(1e-3 * milliseconds, Counter::kIsIterationInvariantRate);
  state.counters["flights_per_s"] = Counter(1.0, Counter::kIsIterationInvariantRate);
}

void straight_flight(::benchmark::State& state) { whole_flight(state, sim::FlightMotion::straight); }
void six_dof_flight(::benchmark::State& state) { whole_flight(state, sim::FlightMotion::six_dof); }

}  // namespace
}  // namespace fantail::benchmark

BENCHMARK(fantail::benchmark::straight_flight)->Name("whole_flight");
BENCHMARK(fantail::benchmark::six_dof_flight)->Name("whole_flight_six_dof");
