// SPDX-License-Identifier: MIT
#pragma once

#include "sil/bench_at_world.hpp"

namespace fantail::sil {

/// Another rocket on the bus of the first, on for as long as it was ticked. It hears and obeys whatever the first
/// hears.
class SecondRocket {
 public:
  explicit SecondRocket(hal::sim::CanWire& wire, const std::string& scenario = "bench_healthy")
      : scenario_{input::load_scenario(scenario, {})},
        bus_{wire},
        world_{scenario_, {bus_, flash_, console_, entropy_}} {}

  void live(int milliseconds = 1) {
    for (int i = 0; i < milliseconds; ++i) {
      record = world_.tick();
      world_.advance();
    }
  }

  core::TickRecord record;

 private:
  sim::Scenario scenario_;
  hal::sim::CanBus bus_;
  hal::sim::Flash flash_{{.size = 1U << 18U, .sector_size = 4096, .page_size = 256}};
  hal::sim::Console console_;
  hal::sim::Entropy entropy_;
  sim::World world_;
};

}  // namespace fantail::sil
