// SPDX-License-Identifier: MIT
#include "hal/stm32f4/entropy.hpp"

#include "fake_rng.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeRng;
using test::RegisterWorld;

struct TheEntropy : testing::Test {
  RegisterWorld world{};
  FakeRng device{world};
};

TEST_F(TheEntropy, EachDrawIsAFreshNumberOfTheDevice) {
  Entropy entropy{device.registers};
  EXPECT_EQ(entropy.draw(), 1014U) << "the very first is kept for comparison";
  EXPECT_EQ(entropy.draw(), 1021U);
  EXPECT_FALSE(entropy.failed());
}

TEST_F(TheEntropy, AGeneratorThatRepeatsItselfHasFailed) {
  Entropy entropy{device.registers};
  static_cast<void>(entropy.draw());
  EXPECT_FALSE(entropy.failed());
  device.repeats = true;
  static_cast<void>(entropy.draw());
  EXPECT_TRUE(entropy.failed());
  device.repeats = false;
  static_cast<void>(entropy.draw());
  EXPECT_TRUE(entropy.failed()) << "that it repeated itself once is enough";
}

TEST_F(TheEntropy, AnErrorOfTheSeedIsAFailureAndTheNumbersComeBack) {
  Entropy entropy{device.registers};
  const std::uint32_t before = entropy.draw();
  device.lose_noise();
  EXPECT_EQ(entropy.draw(), before);
  EXPECT_TRUE(entropy.failed());
  EXPECT_NE(entropy.draw(), before);
  EXPECT_TRUE(entropy.failed());
}

TEST_F(TheEntropy, ANumberThatStandsReadyBesideAnErrorIsNotUsed) {
  Entropy entropy{device.registers};
  const std::uint32_t before = entropy.draw();
  device.lose_noise_behind_a_number();
  EXPECT_EQ(entropy.draw(), before);
  EXPECT_TRUE(entropy.failed());
}

TEST_F(TheEntropy, WithoutItsClockItFails) {
  device.has_clock = false;
  Entropy entropy{device.registers};
  EXPECT_TRUE(entropy.failed());
  EXPECT_EQ(entropy.draw(), entropy.draw());
}

TEST_F(TheEntropy, ADeviceThatReadsZeroFailsAndNothingHangs) {
  registers::Rng nothing{};
  world.on_write(nothing.cr, [](std::uint32_t) {});
  Entropy entropy{nothing};
  EXPECT_TRUE(entropy.failed());
  EXPECT_EQ(entropy.draw(), 0U);
  EXPECT_LT(world.accesses(), 1'000U);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
