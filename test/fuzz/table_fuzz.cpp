// SPDX-License-Identifier: MIT
// Any bytes as an exported trajectory: motion over time, or refused with a sentence.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "chosen_input.hpp"
#include "input/scenario_file.hpp"
#include "trajectory/trajectory.hpp"

namespace fantail::fuzz {
namespace {

void read(std::uint8_t, std::string bytes) {
  static const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const trajectory::Trajectory read = trajectory::parse_trajectory(std::move(bytes), "x.csv", scenario);
  require(std::ranges::all_of(read.notes, is_sentence));
}

}  // namespace

// The first byte chooses nothing here.
std::vector<std::string> seeds() {
  const std::string rows = "-0.1,0,0\n0,0,0\n0.5,5,20\n1,20,40\n2,55,30\n4,95,10\n5,100,0\n6,95,-10\n";
  return {"_# Time (s),Altitude (m),Vertical velocity (m/s)\n" + rows, "_Time (s), Z (m), Vz (m/s)\n" + rows,
          "_t,altitude,speed\n" + rows};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
