// SPDX-License-Identifier: MIT
#include "hal/stm32f4/imu_self_test.hpp"

#include <gtest/gtest.h>

namespace fantail::hal::stm32f4 {
namespace {

TEST(ImuSelfTest, WithoutFactoryCodesAbsoluteLimitsHold) {
  // 60 deg/s at 131 counts each; 50 to 1200 mg at 16384 counts per g.
  const ImuSelfTest::Axes off{10, -10, 0};
  EXPECT_TRUE(ImuSelfTest::gyro_passes(off, {10 + 7870, -10 - 7870, 7870}, {90, 0, 90}));
  EXPECT_FALSE(ImuSelfTest::gyro_passes(off, {10 + 7850, -10 - 7870, 7870}, {90, 0, 90}));
  EXPECT_TRUE(ImuSelfTest::accelerometer_passes(off, {10 + 820, -10 - 820, 19660}, {}));
  EXPECT_FALSE(ImuSelfTest::accelerometer_passes(off, {10 + 820, -10 - 820, 19670}, {}));
  EXPECT_FALSE(ImuSelfTest::accelerometer_passes(off, {10 + 818, -10 - 820, 820}, {}));
}

TEST(ImuSelfTest, AResponseIsComparedWithWhatTheFactoryNoted) {
  // A code of 1 is 2620 counts, 71 is 2620 * 1.01^70 = 5258.
  const ImuSelfTest::Axes off{};
  EXPECT_TRUE(ImuSelfTest::gyro_passes(off, {1320, -3920, 5258}, {1, 1, 71}));
  EXPECT_FALSE(ImuSelfTest::gyro_passes(off, {1300, 2620, 5258}, {1, 1, 71}));
  EXPECT_FALSE(ImuSelfTest::gyro_passes(off, {2620, 2620, 2620}, {1, 1, 71}));
  EXPECT_FALSE(ImuSelfTest::accelerometer_passes(off, {3940, 2620, 5258}, {1, 1, 71}));
}

}  // namespace
}  // namespace fantail::hal::stm32f4
