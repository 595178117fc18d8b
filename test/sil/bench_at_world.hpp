// SPDX-License-Identifier: MIT
#pragma once

#include "bench/exercise.hpp"
#include "bench/perform.hpp"
#include "bench/sheet.hpp"
#include "hal/sim/can_bus.hpp"
#include "hal/sim/console.hpp"
#include "hal/sim/entropy.hpp"
#include "hal/sim/flash.hpp"
#include "input/scenario_file.hpp"
#include "link/avionics_link.hpp"
#include "link/place.hpp"
#include "link/session.hpp"
#include "sim/flight_computer.hpp"
#include "sim/world.hpp"
#include "test.hpp"

namespace fantail::sil {

inline constexpr hal::Microseconds millisecond{1'000};
inline constexpr hal::Microseconds second{1'000'000};

/// A bench and a rocket on one simulated bus, in one thread: the rocket lives on while the bench waits.
class BenchAtWorld final : public link::Place {
 public:
  explicit BenchAtWorld(sim::Scenario loaded, sim::MakeFlightComputer make = sim::simulated_board)
      : scenario{std::move(loaded)}, make_{std::move(make)} {
    power_cycle();
  }
  explicit BenchAtWorld(const std::string& name, std::uint64_t seed = 1,
                        sim::MakeFlightComputer make = sim::simulated_board)
      : BenchAtWorld{load(name, seed), std::move(make)} {}

  /// The flash stays, everything else begins anew.
  void power_cycle() { world.emplace(scenario, sim::BoardPorts{board_bus, flash, console, entropy}, make_); }

  [[nodiscard]] hal::CanBus& bus() override { return pc_bus; }
  [[nodiscard]] hal::Microseconds now() const override { return now_; }
  void wait(hal::Microseconds at_most) override {
    for (hal::Microseconds waited{}; waited < at_most; waited += millisecond) {
      if (world && !stopped) {
        record = world->tick();
        world->advance();
      }
      now_ += millisecond;
      if (after_tick) {
        after_tick();
      }
    }
  }

  /// The PC is held up, and a node on it with it.
  void suspend(hal::Microseconds time) { now_ += time; }
  void switch_off() { world.reset(); }

  /// When the rocket has been at rest for long enough.
  [[nodiscard]] link::Session open_session(link::AvionicsLink& link) {
    link::await_avionics(*this, link);
    wait(3 * second);
    return {*this, link, 5};
  }

  /// As `fantail bench limits` does it.
  [[nodiscard]] bench::Sheet limits() {
    link::AvionicsLink link{pc_bus};
    link::Session session = open_session(link);
    const bench::Bounds bounds = bench::bounds(link.newest<protocol::LimitReport>()->message, session.trims());
    const bench::Exercise exercise = bench::Exercise::limits(bounds);
    const link::Recording recording = bench::perform(exercise, session, link, [](double) {});
    EXPECT_TRUE(session.close());
    return bench::examine(recording, exercise, scenario.vehicle.canard_tolerances, {});
  }

  sim::Scenario scenario;
  hal::sim::CanWire wire;
  hal::sim::CanBus board_bus{wire};
  hal::sim::CanBus pc_bus{wire};
  hal::sim::Flash flash{{.size = 1U << 18U, .sector_size = 4096, .page_size = 256}};
  hal::sim::Console console;
  hal::sim::Entropy entropy;
  std::optional<sim::World> world;
  core::TickRecord record;
  std::function<void()> after_tick;
  bool stopped = false;  ///< as a node by SIGSTOP: the rocket's time stands still, and the PC's goes on

 private:
  static sim::Scenario load(const std::string& name, std::uint64_t seed) {
    sim::Scenario loaded = input::load_scenario(name, {});
    loaded.seed = seed;
    return loaded;
  }

  sim::MakeFlightComputer make_;
  hal::Microseconds now_{};
};

}  // namespace fantail::sil
