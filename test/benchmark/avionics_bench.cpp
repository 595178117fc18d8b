// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "avionics/avionics.hpp"
#include "benchmark/recorded_flight.hpp"
#include "hal/sim/accelerometer.hpp"
#include "hal/sim/arm_switch.hpp"
#include "hal/sim/clock.hpp"
#include "hal/sim/encoder.hpp"
#include "hal/sim/imu.hpp"
#include "hal/sim/servo.hpp"

namespace fantail::benchmark {
namespace {

/// The avionics on simulated hardware that shows a recorded flight.
class Replay {
 public:
  explicit Replay(const core::FlightPlan& plan)
      : avionics_{{.clock = clock_,
                   .imu = imu_,
                   .accelerometer = accelerometer_,
                   .servo = servo_,
                   .encoder = encoder_,
                   .arm_switch = arm_switch_},
                  plan} {}

  const core::TickRecord& tick(const RecordedTick& recorded) {
    side_ = recorded.hardware;
    if (recorded.inputs.arm_command) {
      avionics_.command_arm();
    }
    return avionics_.tick();
  }

 private:
  hal::sim::WorldSide side_;
  hal::sim::Clock clock_{side_};
  hal::sim::Imu imu_{side_};
  hal::sim::Accelerometer accelerometer_{side_};
  hal::sim::Servo servo_{side_};
  hal::sim::Encoder encoder_{side_};
  hal::sim::ArmSwitch arm_switch_{side_};
  avionics::Avionics avionics_;
};

// Every tick of the recorded flight, from power-up to a second after apogee. The copy of the recorded hardware into the
// simulated one is timed with it, as some driver has to put samples there in every world.
void avionics_tick(::benchmark::State& state) {
  const RecordedFlight& flight = recorded_flight();
  for ([[maybe_unused]] auto _ : state) {
    Replay replay{flight.scenario.plan};
    core::Phase phase = core::Phase::safe;
    for (const RecordedTick& recorded : flight.ticks) {
      const core::TickRecord* record = &replay.tick(recorded);
      ::benchmark::DoNotOptimize(record);
      phase = record->phase;
    }
    if (phase != flight.ticks.back().phase) {
      state.SkipWithError("the replay differs from the flight");
    }
  }
  const auto ticks = static_cast<double>(flight.ticks.size());
  state.counters["time_per_tick"] =
      ::benchmark::Counter(ticks, ::benchmark::Counter::kIsIterationInvariantRate | ::benchmark::Counter::kInvert);
}

}  // namespace
}  // namespace fantail::benchmark

BENCHMARK(fantail::benchmark::avionics_tick)->Name("avionics_tick");
