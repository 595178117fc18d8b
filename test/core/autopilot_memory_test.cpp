// SPDX-License-Identifier: MIT
#include <array>
#include <cstring>

#include <gtest/gtest.h>

#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"

namespace fantail::core {
namespace {

// What is watched of a law in flight (avionics/memory_watch.hpp) goes up to what the pad taught, the zero of the gyro
// and the direction of gravity with the flag that they are known, and no further: behind it lies what changes on the
// pad only.
TEST(AutopilotMemory, OfAFlightEndsWithTheAverageOfThePad) {
  Autopilot law{default_plan()};
  Inputs inputs;
  const std::array<float, 6> pad{0x1p-7F, -0x1p-8F, 0x1p-9F, 9.75F, 0.5F, -0.25F};
  for (int i = 0; i < 4'000; ++i) {
    inputs.time += Microseconds{1'000};
    inputs.gyro = {.time = inputs.time, .rate_rad_s = {pad[0], pad[1], pad[2]}, .quality = SampleQuality::valid};
    inputs.accelerometers.fill(
        {.time = inputs.time, .specific_force_m_s2 = {pad[3], pad[4], pad[5]}, .quality = SampleQuality::valid});
    law.step(inputs);
  }
  const std::span<const std::byte> memory = law.flight_memory();
  constexpr std::size_t average_size = sizeof pad + 4;  // with the flag, in a word
  ASSERT_GT(memory.size(), average_size);
  ASSERT_LT(memory.size(), sizeof law);
  std::array<float, 6> last{};
  std::memcpy(last.data(), memory.last(average_size).data(), sizeof last);
  EXPECT_EQ(last, pad);
}

}  // namespace
}  // namespace fantail::core
