// SPDX-License-Identifier: MIT
#include "hal/stm32f4/reset_cause.hpp"

#include <gtest/gtest.h>

#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

/// The flags of RM0090 section 7.3.21 add up until RMVF clears them.
struct FakeResets {
  registers::Rcc rcc{};
  std::uint32_t flags = 0;
  explicit FakeResets(RegisterWorld& world) {
    world.on_read(rcc.csr, [this] { return flags | 3U; });  // and the slow oscillator, on and ready
    world.on_write(rcc.csr, [this](std::uint32_t value) { flags = (value >> 24U & 1U) != 0 ? 0 : flags; });
  }
};

struct TakeResetCause : testing::Test {
  RegisterWorld world{};
  FakeResets resets{world};
  ResetCause after(std::uint32_t flags) {
    resets.flags |= flags;
    return take_reset_cause(resets.rcc);
  }
};

constexpr std::uint32_t brown_out = 1U << 25U;
constexpr std::uint32_t pin = 1U << 26U;
constexpr std::uint32_t power_on = 1U << 27U;
constexpr std::uint32_t software = 1U << 28U;
constexpr std::uint32_t watchdog = 1U << 29U;

TEST_F(TakeResetCause, EachIsToldFromTheFlagsThatComeWithIt) {
  EXPECT_EQ(after(power_on | brown_out | pin), ResetCause::power_on);
  EXPECT_EQ(after(brown_out | pin), ResetCause::brown_out);
  EXPECT_EQ(after(watchdog | pin), ResetCause::watchdog);
  EXPECT_EQ(after(1U << 30U | pin), ResetCause::watchdog);
  EXPECT_EQ(after(software | pin), ResetCause::software);
  EXPECT_EQ(after(pin), ResetCause::pin);
}

TEST_F(TakeResetCause, IsForgottenOnceItWasTaken) {
  EXPECT_EQ(after(power_on | brown_out | pin), ResetCause::power_on);
  EXPECT_EQ(resets.flags, 0U);
  EXPECT_EQ(after(watchdog | pin), ResetCause::watchdog);
}

TEST_F(TakeResetCause, APowerOnBehindAnyOtherResetIsAPowerOn) {
  resets.flags = power_on | brown_out | pin;
  EXPECT_EQ(after(watchdog | software | pin), ResetCause::power_on);
}

TEST_F(TakeResetCause, WithoutAnyFlagItCountsAsAPowerOnWhichNothingSurvives) {
  EXPECT_EQ(after(0), ResetCause::power_on);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
