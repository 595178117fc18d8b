// SPDX-License-Identifier: MIT
#include "hal/stm32f4/second_imu.hpp"

#include <cstdlib>

#include "fake_ism330dhcx.hpp"
#include "hal/stm32f4/ism330dhcx.hpp"
#include "sensor_rig.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeIsm330dhcx;

class SecondImuTest : public test::SensorTest<FakeIsm330dhcx, 42'000'000> {
 protected:
  SecondImu make(SensorStart how) {
    SecondImu imu{place(ism330dhcx::spi), clock};
    imu.start(how);
    return imu;
  }
  /// The start without a self-test.
  SecondImu running() {
    SecondImu imu = make(SensorStart::in_flight);
    EXPECT_LE(ticks_to_sample(imu, 200), 120);
    return imu;
  }
  void expect_silent_for(SecondImu& imu, int ticks, Status status) {
    for (int i = 0; i < ticks; ++i) {
      ASSERT_EQ(next(imu).status, status) << i;
    }
  }
};

TEST_F(SecondImuTest, MeasuresInTheUnitsOfItsConfiguration) {
  device.noise_counts = 0.0;
  device.rate_deg_s = {1400.0, -700.0, 0.0};
  device.force_g = {4.88, 0.0, -2.44};
  SecondImu imu = running();
  const ImuSample sample = next(imu);
  // ST's driver: 140 mdeg/s and 0.488 mg a count.
  EXPECT_EQ(sample.rate, (Counts{10'000, -5'000, 0}));
  EXPECT_EQ(sample.specific_force, (Counts{10'000, 0, -5'000}));
  EXPECT_FLOAT_EQ(imu.scale().rate_rad_s * 10'000.0F, 1400.0F * 3.14159265F / 180.0F);
  EXPECT_FLOAT_EQ(imu.scale().specific_force_m_s2 * 10'000.0F, 4.88F * 9.80665F);
}

TEST_F(SecondImuTest, IsSetUpAsTheHeaderSays) {
  const SecondImu imu = running();
  EXPECT_EQ(device.reg(0x10), 0x96);  // 3.3 kHz, 16 g, second filter
  EXPECT_EQ(device.reg(0x11), 0x91);  // 3.3 kHz, 4000 deg/s
  EXPECT_EQ(device.reg(0x12), 0x44);  // whole samples, addresses that go on
  EXPECT_EQ(device.reg(0x13), 0x06);  // the gyro's filter, no I2C
  EXPECT_EQ(device.reg(0x15), 0x00);  // 292 Hz
  EXPECT_EQ(device.reg(0x18), 0xE2);
  EXPECT_EQ(spi.clock_hz(), 5'250'000U);
}

TEST_F(SecondImuTest, BothEndsOfItsRangeAreTheEndsThatTheContractNames) {
  // Its counts go on to 4587 deg/s, its range to 4000.
  device.noise_counts = 0.0;
  device.rate_deg_s = {-4'000.0, 4'100.0, 3'990.0};
  SecondImu imu = running();
  EXPECT_EQ(next(imu).rate, (Counts{-32768, 32767, 28'500}));
}

TEST_F(SecondImuTest, EachTickHasANewSample) {
  SecondImu imu = running();
  for (int i = 0; i < 1'000; ++i) {
    const ImuSample sample = next(imu);
    ASSERT_EQ(sample.time, clock.time - SecondImu::age_when_found);
  }
}

TEST_F(SecondImuTest, SaysNoReadingUntilItIsTestedAndSteady) {
  SecondImu imu = make(SensorStart::power_up);
  EXPECT_EQ(imu.read().status, Status::no_reading);
  const int ticks = ticks_to_sample(imu, 1'000);
  // 10 + 100 + 100 ms and five samples twice, then 10 + 100 ms.
  EXPECT_GE(ticks, 320);
  EXPECT_LE(ticks, 350);
  EXPECT_LT(std::abs(next(imu).rate[0]), 3) << "it swings as it starts";
  EXPECT_EQ(device.reg(0x14), 0x00) << "no self-test goes on";
}

TEST_F(SecondImuTest, OneWhoseSelfTestFailsIsAnErrorUntilItPasses) {
  for (const double actuation_deg_s : {0.0, 120.0, 800.0}) {
    device.actuation_deg_s = actuation_deg_s;
    SecondImu imu = make(SensorStart::power_up);
    EXPECT_EQ(ticks_to_sample(imu, 1'000), 1'001) << actuation_deg_s;
    EXPECT_EQ(next(imu).status, Status::error);
    device.actuation_deg_s = 160.0;
    EXPECT_LE(ticks_to_sample(imu, 1'000), 600);
  }
}

TEST_F(SecondImuTest, WhereNoneIsFittedNothingIsReadForEver) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    device.stuck_at = level;
    SecondImu imu = make(SensorStart::power_up);
    expect_silent_for(imu, 2'000, Status::no_reading);
  }
}

TEST_F(SecondImuTest, AnotherDeviceIsAnError) {
  device.id = 0x6C;  // an LSM6DSO
  SecondImu imu = make(SensorStart::power_up);
  EXPECT_EQ(ticks_to_sample(imu, 200), 201);
  EXPECT_EQ(next(imu).status, Status::error);
}

TEST_F(SecondImuTest, OneThatDoesNotShowThatItIsConfiguredIsBelievedByItsRates) {
  device.shows_device_conf = false;
  running();
}

TEST_F(SecondImuTest, OneThatNeverEndsItsResetIsTriedAgain) {
  device.never_ends_reset = true;
  SecondImu imu = make(SensorStart::in_flight);
  expect_silent_for(imu, 500, Status::no_reading);
  device.never_ends_reset = false;
  EXPECT_LE(ticks_to_sample(imu, 200), 150);
}

TEST_F(SecondImuTest, AfterAResetInFlightADeviceThatStillRunsIsTakenAsItIs) {
  {
    const SecondImu before = running();
  }
  const int resets = device.resets;
  SpiRegisters{place(ism330dhcx::spi)}.write(0x01, 0x80);  // other registers were shown
  SecondImu after = make(SensorStart::in_flight);
  EXPECT_LE(ticks_to_sample(after, 100), 2);
  EXPECT_EQ(device.resets, resets);
}

TEST_F(SecondImuTest, OneThatStopsAnsweringIsSilentAtOnceAndComesBack) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    for (const int ticks : {50, 2'000}) {
      SecondImu imu = running();
      device.stuck_at = level;
      expect_silent_for(imu, ticks, Status::no_reading);
      device.stuck_at.reset();
      EXPECT_LE(ticks_to_sample(imu, 200), 150);
    }
  }
}

TEST_F(SecondImuTest, OneSpoiltAnswerCostsOneTickAndNoReset) {
  SecondImu imu = running();
  const int resets = device.resets;
  device.stuck_at = 0xFF;
  EXPECT_EQ(next(imu).status, Status::no_reading);
  device.stuck_at.reset();
  EXPECT_EQ(next(imu).status, Status::ok);
  EXPECT_EQ(device.resets, resets);
}

TEST_F(SecondImuTest, OneThatResetsItselfRepeatsItsOldTimeAndIsSetUpAgain) {
  SecondImu imu = running();
  const Microseconds last = next(imu).time;
  device.reset();
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(next(imu).time, last) << i;
  }
  EXPECT_EQ(next(imu).status, Status::no_reading);
  EXPECT_LE(ticks_to_sample(imu, 200), 120);
}

TEST_F(SecondImuTest, OneThatSaysTheSameForFiftyMillisecondsIsAnError) {
  SecondImu imu = running();
  device.frozen = true;
  int ticks = 0;
  while (ticks < 200 && next(imu).status == Status::ok) {
    ticks += 1;
  }
  EXPECT_EQ(ticks, 50);
  device.frozen = false;
  EXPECT_LE(ticks_to_sample(imu, 200), 120);
}

TEST_F(SecondImuTest, NoTickTakesLongHoweverTheDeviceBehaves) {
  SecondImu imu = make(SensorStart::power_up);
  double longest_us = 0.0;
  for (int i = 0; i < 3'000; ++i) {
    device.stuck_at = i % 700 > 500 ? std::optional<std::uint8_t>{0x00} : std::nullopt;
    spi.forget_traffic();
    (void)next(imu);
    longest_us = std::max(longest_us, spi.wire_us());
  }
  // Set up and read back: a command and a register each, for eight and seven of them, and the two before.
  EXPECT_LE(longest_us, 17 * 2 * 8 / 5.25 + 1e-9);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
