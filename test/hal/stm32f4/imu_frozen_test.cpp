// SPDX-License-Identifier: MIT

#include "hal/stm32f4/imu.hpp"
#include "hal/stm32f4/imu_self_test.hpp"
#include "imu_rig.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

// An IMU whose new samples repeat old values: see FrozenCounts.

constexpr Counts nothing{-32768, -32768, -32768};

class ImuFrozen : public test::ImuRig {
 protected:
  /// Ticks until the gyro's counts are not to be used, at most so many.
  int ticks_to_nothing(Imu& imu, int most, Counts ImuSample::* what = &ImuSample::rate) {
    for (int i = 1; i <= most; ++i) {
      const ImuSample sample = next(imu);
      if (sample.status != Status::ok || sample.*what == nothing) {
        return i;
      }
    }
    return most + 1;
  }
};

TEST_F(ImuFrozen, ADeviceThatRepeatsAllSixAxesIsNotUsedAfterTwelveMilliseconds) {
  Imu imu = running();
  read_for(imu, 100);
  device.gyro_repeats.fill(true);
  device.accelerometer_repeats.fill(true);
  EXPECT_EQ(ticks_to_nothing(imu, 100), 12);
  EXPECT_TRUE(imu.faults().has(BoardFault::gyro_frozen));
  EXPECT_TRUE(imu.faults().has(BoardFault::imu_accelerometer_frozen));
}

TEST_F(ImuFrozen, AGyroThatRepeatsIsNotUsedAndTheAccelerometerIs) {
  Imu imu = running();
  read_for(imu, 100);
  device.gyro_repeats.fill(true);
  EXPECT_LE(ticks_to_nothing(imu, 100), 64);
  EXPECT_TRUE(imu.faults().has(BoardFault::gyro_frozen));
  EXPECT_FALSE(imu.faults().has(BoardFault::imu_accelerometer_frozen));
  // It is set up again, for what that is worth, and then only the gyro has nothing to say.
  EXPECT_LE(ticks_to_sample(imu, 100), 60);
  for (int i = 0; i < 50; ++i) {
    const ImuSample sample = next(imu);
    EXPECT_EQ(sample.status, Status::ok);
    EXPECT_EQ(sample.rate, nothing);
    EXPECT_NEAR(sample.specific_force[2], 2048, 20);
  }
}

TEST_F(ImuFrozen, OneAxisOfTheGyroIsEnoughAtAnyRate) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double rate_deg_s : {0.0, 300.0}) {
      device.gyro_repeats = {};
      Imu imu = running();
      device.rate_deg_s[axis] = rate_deg_s;
      read_for(imu, 100);
      device.gyro_repeats[axis] = true;
      EXPECT_LE(ticks_to_nothing(imu, 300), 200);
      EXPECT_TRUE(imu.faults().has(BoardFault::gyro_frozen));
    }
  }
}

TEST_F(ImuFrozen, AnAccelerometerThatRepeatsDoesNotCostTheGyro) {
  Imu imu = running();
  read_for(imu, 100);
  const int resets = device.resets;
  device.accelerometer_repeats[0] = true;
  EXPECT_LE(ticks_to_nothing(imu, 100, &ImuSample::specific_force), 64);
  EXPECT_TRUE(imu.faults().has(BoardFault::imu_accelerometer_frozen));
  EXPECT_FALSE(imu.faults().has(BoardFault::gyro_frozen));
  for (int i = 0; i < 500; ++i) {
    const ImuSample sample = next(imu);
    EXPECT_EQ(sample.status, Status::ok);
    EXPECT_EQ(sample.specific_force, nothing);
    EXPECT_NE(sample.rate, nothing);
  }
  EXPECT_EQ(device.resets, resets);
}

TEST_F(ImuFrozen, AfterARestartThatDoesNotHelpItIsStillNotUsed) {
  Imu imu = running();
  read_for(imu, 100);
  device.gyro_repeats.fill(true);
  EXPECT_LE(ticks_to_nothing(imu, 100), 64);
  const int resets = device.resets;
  for (int i = 0; i < 2'000; ++i) {
    const ImuSample sample = next(imu);
    EXPECT_TRUE(sample.status != Status::ok || sample.rate == nothing) << i;
    EXPECT_TRUE(imu.faults().has(BoardFault::gyro_frozen));
  }
  EXPECT_GE(device.resets, resets + 3) << "though it is tried";
}

TEST_F(ImuFrozen, AGyroThatMeasuresAgainIsUsedAfterItsRestartAndSomeTenMoves) {
  Imu imu = running();
  read_for(imu, 100);
  device.gyro_repeats.fill(true);
  EXPECT_LE(ticks_to_nothing(imu, 100), 64);
  device.gyro_repeats = {};
  int ticks = 0;
  while (imu.faults().has(BoardFault::gyro_frozen) && ticks < 500) {
    static_cast<void>(next(imu));
    ++ticks;
  }
  EXPECT_LE(ticks, 60 + 50);
  EXPECT_EQ(imu.read().status, Status::ok);
  EXPECT_NE(imu.read().rate, nothing);
}

TEST_F(ImuFrozen, AMinuteOnThePadIsNoFreeze) {
  Imu imu = running();
  for (int i = 0; i < 60'000; ++i) {
    ASSERT_EQ(next(imu).status, Status::ok);
    ASSERT_TRUE(imu.faults().none());
  }
}

TEST_F(ImuFrozen, ARocketThatTurnsBeyondTheRangeIsNoFreeze) {
  Imu imu = running();
  device.rate_deg_s[0] = 2'500.0;
  for (int i = 0; i < 2'000; ++i) {
    EXPECT_EQ(next(imu).rate[0], 32767);
  }
  EXPECT_TRUE(imu.faults().none());
}

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
