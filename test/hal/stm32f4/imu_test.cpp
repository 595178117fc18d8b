// SPDX-License-Identifier: MIT
#include "hal/stm32f4/imu.hpp"

#include "hal/stm32f4/icm42688.hpp"
#include "imu_rig.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

class ImuTest : public test::ImuRig {};

TEST_F(ImuTest, IsLeftAloneForAMillisecondFromTheEndOfTheCommandThatResetsIt) {
  for (int late_us = 0; late_us < 30; ++late_us) {
    device.reset();
    clock.time += 3 * tick;
    Imu imu = make();
    imu.start(SensorStart::in_flight);
    read_while_time_passes(imu, 10, Microseconds{late_us});
    EXPECT_EQ(device.reg(0, 0x4E), 0x0F) << late_us;  // both in low-noise mode
  }
}

TEST_F(ImuTest, MeasuresInTheUnitsOfItsConfiguration) {
  be_free_of_noise();
  // Half of each range, DS-000347 sections 3.1 and 3.2.
  device.rate_deg_s = {1000.0, -500.0, 0.0};
  device.force_g = {8.0, 0.0, -4.0};
  Imu imu = running();
  const ImuSample sample = next(imu);
  EXPECT_EQ(sample.rate, (Counts{16384, -8192, 0}));
  EXPECT_EQ(sample.specific_force, (Counts{16384, 0, -8192}));
  EXPECT_FLOAT_EQ(imu.scale().rate_rad_s * 16384.0F, 1000.0F * 3.14159265F / 180.0F);
  EXPECT_FLOAT_EQ(imu.scale().specific_force_m_s2 * 16384.0F, 8.0F * 9.80665F);
  EXPECT_TRUE(imu.faults().none());
}

TEST_F(ImuTest, IsSetUpAsTheHeaderSays) {
  const Imu imu = running();
  EXPECT_EQ(device.reg(0, 0x4E), 0x0F);  // both in low-noise mode
  EXPECT_EQ(device.reg(0, 0x4F), 0x06);  // 2000 deg/s, 1 kHz
  EXPECT_EQ(device.reg(0, 0x50), 0x06);  // 16 g, 1 kHz
  EXPECT_EQ(device.reg(0, 0x52), 0x00);
  EXPECT_EQ(device.reg(0, 0x14), 0x03);  // INT1: a pulse, push-pull, active high
  EXPECT_EQ(device.reg(0, 0x64), 0x00);
  EXPECT_EQ(device.reg(0, 0x65), 0x08);  // data-ready
  // 258 Hz in the table of section 5.3: 6, 36, 10.
  EXPECT_EQ(device.reg(1, 0x0C), 6);
  EXPECT_EQ(device.reg(1, 0x0D), 36);
  EXPECT_EQ(device.reg(1, 0x0E), 0xA0);
  EXPECT_EQ(device.reg(2, 0x03), 12);
  EXPECT_EQ(device.reg(2, 0x04), 36);
  EXPECT_EQ(device.reg(2, 0x05), 0xA0);
  EXPECT_EQ(spi.clock_hz(), 21'000'000U);
}

TEST_F(ImuTest, ARateThatPassesAHundredDegreesASecondIsNotHeldBack) {
  be_free_of_noise();
  Imu imu = running();
  for (const double rate_deg_s : {90.0, 110.0, 300.0, -120.0, -80.0}) {
    device.rate_deg_s = {0.0, rate_deg_s, 0.0};
    EXPECT_NEAR(next(imu).rate[1], rate_deg_s * 32768.0 / 2000.0, 0.5);
  }
}

TEST_F(ImuTest, BothEndsOfTheRangeAreTheEndsThatTheContractNames) {
  be_free_of_noise();
  // The device itself never says less than -32766.
  device.rate_deg_s = {-3000.0, 3000.0, 0.0};
  Imu imu = running();
  EXPECT_EQ(next(imu).rate, (Counts{-32768, 32767, 0}));
}

TEST_F(ImuTest, ASampleSeenBeforeComesAgainWithItsOldTime) {
  Imu imu = running();
  const ImuSample first = next(imu);
  EXPECT_EQ(first.time, clock.time - Imu::age_when_found);
  device.rate_deg_s = {100.0, 0.0, 0.0};  // and no time for a new sample
  clock.time += Microseconds{10};
  const ImuSample again = imu.read();
  EXPECT_EQ(again.time, first.time);
  EXPECT_EQ(again.rate, first.rate);
  EXPECT_EQ(again.status, Status::ok);
  EXPECT_GT(next(imu).time, first.time);
}

TEST_F(ImuTest, ASampleThatComesBetweenDataAndFlagIsNotLost) {
  be_free_of_noise();
  Imu imu = running();
  device.before_status = [this] {
    clock.time += tick;
    device.rate_deg_s = {1000.0, 0.0, 0.0};
  };
  static_cast<void>(next(imu));
  clock.time += Microseconds{10};  // no further sample, and its flag is gone
  EXPECT_EQ(imu.read().rate, (Counts{16384, 0, 0}));
}

TEST_F(ImuTest, SaysNoReadingUntilItsFirstSample) {
  Imu imu = make();
  imu.start(SensorStart::power_up);
  EXPECT_EQ(imu.read().status, Status::no_reading);
  const int ticks = ticks_to_sample(imu, 2000);
  // 60 + 200 + 200 + 200 + 25 + 200 + 25 + 200 ms of self-test, and 45 ms of start-up.
  EXPECT_GE(ticks, 1155);
  EXPECT_LE(ticks, 1200);
  EXPECT_TRUE(imu.faults().none());
}

TEST_F(ImuTest, AfterAResetInFlightADeviceThatStillRunsIsTakenAsItIs) {
  {
    const Imu before = running();
  }
  const int resets = device.resets;
  // The processor was reset while another bank was selected.
  SpiRegisters{SpiDevice{bus, Pin{port.block(), 4}, icm42688::spi}}.write(icm42688::bank_select, 2);
  device.writes = 0;
  Imu after = make();
  after.start(SensorStart::in_flight);
  EXPECT_LE(ticks_to_sample(after, 100), 3);
  EXPECT_EQ(device.resets, resets);
}

TEST_F(ImuTest, AfterAResetInFlightADeviceThatWasResetTooSamplesWithin60Milliseconds) {
  Imu imu = make();
  imu.start(SensorStart::in_flight);
  EXPECT_LE(ticks_to_sample(imu, 100), 60);
}

TEST_F(ImuTest, ADeviceThatResetsItselfIsSetUpAgainInTheBackground) {
  Imu imu = running();
  device.reset();
  clock.time += tick;
  EXPECT_EQ(next(imu).status, Status::no_reading);
  EXPECT_LE(ticks_to_sample(imu, 100), 60);
  EXPECT_EQ(device.reg(1, 0x0C), 6);
  EXPECT_TRUE(imu.faults().none());
}

TEST_F(ImuTest, ADeviceThatStopsAnsweringIsSilentAndComesBack) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    Imu imu = running();
    device.stuck_at = level;
    EXPECT_EQ(next(imu).status, Status::no_reading);
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(next(imu).status, Status::no_reading);
    }
    EXPECT_TRUE(imu.faults().has(BoardFault::imu_silent));
    device.stuck_at.reset();
    EXPECT_LE(ticks_to_sample(imu, 200), 90);
    EXPECT_TRUE(imu.faults().none());
  }
}

TEST_F(ImuTest, OneSpoiltAnswerCostsOneTickAndNoReset) {
  Imu imu = running();
  const int resets = device.resets;
  device.stuck_at = 0xFF;
  EXPECT_EQ(next(imu).status, Status::no_reading);
  device.stuck_at.reset();
  EXPECT_EQ(next(imu).status, Status::ok);
  EXPECT_EQ(device.resets, resets);
  EXPECT_TRUE(imu.faults().none());
}

TEST_F(ImuTest, ACountThatADisturbanceHasChangedIsNotTaken) {
  Imu imu = running();
  for (std::uint8_t address = icm42688::accelerometer_data; address < icm42688::gyro_data + 6; ++address) {
    for (const int when : {0, 1}) {  // each is read twice
      const ImuSample before = next(imu);
      int reads = 0;
      device.disturbance = [&](std::uint8_t at, std::uint8_t answer) {
        const bool hit = at == address && reads++ == when;
        return static_cast<std::uint8_t>(hit ? answer ^ 0x40U : answer);
      };
      const ImuSample during = next(imu);
      EXPECT_EQ(during.time, before.time);
      EXPECT_EQ(during.rate, before.rate);
      EXPECT_EQ(during.specific_force, before.specific_force);
      device.disturbance = {};
      EXPECT_GT(next(imu).time, before.time);
    }
  }
  EXPECT_TRUE(imu.faults().none());
}

TEST_F(ImuTest, AFlagThatADisturbanceHasSetIsNoReset) {
  Imu imu = running();
  const int resets = device.resets;
  device.disturbance = [](std::uint8_t at, std::uint8_t answer) {
    return static_cast<std::uint8_t>(at == icm42688::interrupt_status ? answer | icm42688::reset_done : answer);
  };
  EXPECT_EQ(next(imu).status, Status::ok);
  EXPECT_EQ(device.resets, resets);
}

TEST_F(ImuTest, ADeviceThatIsNotTheRightOneIsNamed) {
  device.id = 0x4E;
  Imu imu = make();
  imu.start(SensorStart::power_up);
  EXPECT_EQ(ticks_to_sample(imu, 200), 201);
  EXPECT_TRUE(imu.faults().has(BoardFault::imu_wrong_id));
  EXPECT_FALSE(imu.faults().has(BoardFault::imu_silent));
}

TEST_F(ImuTest, ADeviceThatChangesItsIdIsAnError) {
  Imu imu = running();
  device.id = 0x12;
  EXPECT_EQ(next(imu).status, Status::error);
  EXPECT_TRUE(imu.faults().has(BoardFault::imu_wrong_id));
  device.id = 0x47;
  EXPECT_LE(ticks_to_sample(imu, 100), 60);
}

TEST_F(ImuTest, ADeviceWithoutNewSamplesIsSetUpAgainAfterTenMilliseconds) {
  Imu imu = running();
  const int resets = device.resets;
  const Microseconds last = next(imu).time;
  device.frozen = true;
  for (int i = 0; i < 10; ++i) {
    const ImuSample sample = next(imu);
    EXPECT_EQ(sample.time, last);
    EXPECT_EQ(sample.status, Status::ok);
  }
  EXPECT_EQ(next(imu).status, Status::no_reading);
  device.frozen = false;
  EXPECT_LE(ticks_to_sample(imu, 100), 60);
  EXPECT_EQ(device.resets, resets + 1);
}

TEST_F(ImuTest, NoTickTakesLongHoweverTheDeviceBehaves) {
  Imu imu = make();
  imu.start(SensorStart::power_up);
  double longest_us = 0.0;
  for (int i = 0; i < 3000; ++i) {
    device.stuck_at = i % 700 > 650 ? std::optional<std::uint8_t>{0xFF} : std::nullopt;
    spi.forget_traffic();
    static_cast<void>(next(imu));
    longest_us = std::max(longest_us, spi.wire_us());
  }
  // The tick that sets everything up and reads it back: 2 * (17 + 3) registers and some, two bytes each, at 21 MHz.
  EXPECT_LE(longest_us, 88 * 8 / 21.0);
}

TEST_F(ImuTest, ABusThatStopsIsADeviceThatIsSilent) {
  Imu imu = running();
  spi.stop();
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(next(imu).status, Status::no_reading);
  }
  EXPECT_TRUE(imu.faults().has(BoardFault::imu_silent));
  spi.violations.clear();
  spi.go_on();
  EXPECT_LE(ticks_to_sample(imu, 100), 60);
}

// ---- self-test ----

TEST_F(ImuTest, AnAxisThatMovesTooLittleOrTooMuchFailsTheSelfTest) {
  for (const double actuation : {0.4, 1.6}) {
    for (const bool gyro : {true, false}) {
      device.gyro_actuation = gyro ? actuation : 1.0;
      device.accelerometer_actuation = gyro ? 1.0 : actuation;
      Imu imu = make();
      imu.start(SensorStart::power_up);
      EXPECT_LE(ticks_to_sample(imu, 5000), 3600);  // three tries; it measures all the same
      EXPECT_TRUE(imu.faults().has(BoardFault::imu_self_test_failed)) << actuation << gyro;
    }
  }
}

TEST_F(ImuTest, ARocketThatIsCarriedAboutAtPowerUpIsTestedAgain) {
  Imu imu = make();
  imu.start(SensorStart::power_up);
  device.rate_deg_s = {30.0, 0.0, 0.0};
  for (int i = 0; i < 1130; ++i) {
    static_cast<void>(next(imu));
  }
  EXPECT_TRUE(imu.faults().has(BoardFault::imu_self_test_failed));
  device.rate_deg_s = {};
  EXPECT_LE(ticks_to_sample(imu, 2000), 1200);
  EXPECT_TRUE(imu.faults().none());
}

}  // namespace
}  // namespace fantail::hal::stm32f4
