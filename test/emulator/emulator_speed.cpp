// SPDX-License-Identifier: MIT
// Usage: emulator_speed [SCENARIO]
// How fast the emulated flight computer flies, by its own millisecond and without it, and whether each tick is the
// host's.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "emulator/images.hpp"
#include "input/scenario_file.hpp"
#include "protocol/tick_digest.hpp"
#include "sim/world.hpp"

namespace fantail::test {
namespace {

struct Flight {
  std::vector<std::uint32_t> digests;
  double seconds = 0.0;
};

Flight fly(const sim::Scenario& scenario, const sim::MakeFlightComputer& make) {
  Flight flight;
  sim::World world{scenario, sim::World::large_flash, make};
  const auto begin = std::chrono::steady_clock::now();
  while (!world.over()) {
    flight.digests.push_back(protocol::tick_digest(world.tick()));
    world.advance();
  }
  flight.seconds = std::chrono::duration<double>{std::chrono::steady_clock::now() - begin}.count();
  return flight;
}

void print(const char* what, const Flight& flown, const Flight& host) {
  std::size_t different = flown.digests.size() == host.digests.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(flown.digests.size(), host.digests.size()); ++i) {
    different += flown.digests[i] != host.digests[i] ? 1 : 0;
  }
  const double simulated_s = 1e-3 * static_cast<double>(flown.digests.size());
  std::printf("%-30s %6.2f s for %.1f s: %6.1f times real time, %zu ticks differ\n", what, flown.seconds, simulated_s,
              simulated_s / flown.seconds, different);
}

int run(int argc, char** argv) {
  if (const std::string objection = objection_to_images(); !objection.empty()) {
    std::printf("%s\n", objection.c_str());
    return 77;
  }
  const sim::Scenario scenario = input::load_scenario(argc > 1 ? argv[1] : "tasha3_launch2", {});
  const Flight host = fly(scenario, sim::simulated_board);
  print("on the host", host, host);
  for (int round = 0; round < 3; ++round) {
    {
      hil::Target target{std::make_unique<hil::Emulator>(hil::EmulatorOptions{.image = image("fantail-emulator.elf")})};
      print("emulated, 1 kHz by its SysTick", fly(scenario, target.maker()), host);
    }
    hil::Target target{std::make_unique<hil::Emulator>(hil::EmulatorOptions{.image = image("fantail-count.elf")})};
    print("emulated, as it is asked", fly(scenario, target.maker()), host);
  }
  return 0;
}

}  // namespace
}  // namespace fantail::test

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // an emulator that dies is told of in words
  try {
    return fantail::test::run(argc, argv);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
