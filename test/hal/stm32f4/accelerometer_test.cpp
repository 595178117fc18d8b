// SPDX-License-Identifier: MIT
#include "hal/stm32f4/accelerometer.hpp"

#include "fake_kx134.hpp"
#include "hal/stm32f4/kx134.hpp"
#include "sensor_rig.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeKx134;

class AccelerometerTest : public test::SensorTest<FakeKx134, 42'000'000> {
 protected:
  Accelerometer make() { return Accelerometer{place(kx134::spi), clock}; }
  Accelerometer running() {
    Accelerometer accelerometer = make();
    EXPECT_LE(ticks_to_sample(accelerometer, 100), 20);
    return accelerometer;
  }
};

TEST_F(AccelerometerTest, MeasuresInTheUnitsOfItsConfiguration) {
  device.noisy = false;
  device.force_g = {16.0, 0.5, -1.0};
  Accelerometer accelerometer = running();
  // 1024 counts per g: 32 g are 32768.
  EXPECT_EQ(next(accelerometer).specific_force, (Counts{16384, 512, -1024}));
  EXPECT_FLOAT_EQ(accelerometer.scale() * 1024.0F, 9.80665F);
  EXPECT_TRUE(accelerometer.faults().none());
  EXPECT_EQ(spi.clock_hz(), 5'250'000U);
  EXPECT_EQ(device.reg(0x1B) & 0x18U, 0x10U);  // 32 g
  EXPECT_EQ(device.reg(0x21), 0x0B);           // 1600 Hz
}

TEST_F(AccelerometerTest, IsLeftAloneForTwoMillisecondsFromTheEndOfTheCommandThatResetsIt) {
  for (int late_us = 0; late_us < 30; ++late_us) {
    device.reset();
    clock.time += 3 * tick;
    Accelerometer accelerometer = make();
    EXPECT_GT(read_while_time_passes(accelerometer, 20, Microseconds{late_us}), 5) << late_us;
  }
}

TEST_F(AccelerometerTest, ShowsTheEndsOfItsRange) {
  device.noisy = false;
  device.force_g = {-40.0, 1.0, 50.0};
  Accelerometer accelerometer = running();
  EXPECT_EQ(next(accelerometer).specific_force, (Counts{-32768, 1024, 32767}));
}

TEST_F(AccelerometerTest, ASampleSeenBeforeComesAgainWithItsOldTime) {
  Accelerometer accelerometer = running();
  const AccelerometerSample first = next(accelerometer);
  EXPECT_EQ(first.time, clock.time - Accelerometer::age_when_found);
  clock.time += Microseconds{10};
  EXPECT_EQ(accelerometer.read().time, first.time);
  EXPECT_EQ(accelerometer.read().status, Status::ok);
  EXPECT_GT(next(accelerometer).time, first.time);
}

TEST_F(AccelerometerTest, EachTickFindsANewSample) {
  Accelerometer accelerometer = running();
  Microseconds last = next(accelerometer).time;
  for (int i = 0; i < 1000; ++i) {
    const Microseconds time = next(accelerometer).time;
    ASSERT_EQ(time, last + tick);
    last = time;
  }
}

TEST_F(AccelerometerTest, AfterAResetInFlightADeviceThatStillRunsIsTakenAsItIs) {
  {
    const Accelerometer before = running();
  }
  const int resets = device.resets;
  Accelerometer after = make();
  after.start(SensorStart::in_flight);
  EXPECT_LE(ticks_to_sample(after, 100), 2);
  EXPECT_EQ(device.resets, resets);
}

TEST_F(AccelerometerTest, ADeviceThatResetsItselfIsSetUpAgain) {
  Accelerometer accelerometer = running();
  device.reset();
  clock.time += 2 * tick;
  int without = 0;
  while (next(accelerometer).status == Status::ok && without < 100) {
    ++without;
  }
  EXPECT_LE(without, 10);
  EXPECT_LE(ticks_to_sample(accelerometer, 100), 20);
  EXPECT_EQ(device.reg(0x1B), 0xF0);
}

TEST_F(AccelerometerTest, ADeviceThatStopsAnsweringIsSilentAndComesBack) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    Accelerometer accelerometer = running();
    device.stuck_at = level;
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(next(accelerometer).status, Status::no_reading);
    }
    EXPECT_TRUE(accelerometer.faults().has(BoardFault::accelerometer_silent));
    device.stuck_at.reset();
    EXPECT_LE(ticks_to_sample(accelerometer, 100), 20);
    EXPECT_TRUE(accelerometer.faults().none());
  }
}

TEST_F(AccelerometerTest, ADeviceThatTakesItsTimeAtPowerUpIsNoFault) {
  device.stuck_at = 0xFF;
  Accelerometer accelerometer = make();
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(next(accelerometer).status, Status::no_reading);
    EXPECT_TRUE(accelerometer.faults().none());
  }
  device.stuck_at.reset();
  EXPECT_LE(ticks_to_sample(accelerometer, 100), 10);
  EXPECT_TRUE(accelerometer.faults().none());
}

TEST_F(AccelerometerTest, OneSpoiltAnswerCostsOneTickAndNoReset) {
  Accelerometer accelerometer = running();
  const int resets = device.resets;
  device.stuck_at = 0x00;
  EXPECT_EQ(next(accelerometer).status, Status::no_reading);
  device.stuck_at.reset();
  EXPECT_EQ(next(accelerometer).status, Status::ok);
  EXPECT_EQ(device.resets, resets);
}

TEST_F(AccelerometerTest, ADeviceThatIsNotTheRightOneIsNamed) {
  device.id = 0x3D;  // a KX132: the same registers, a quarter of the range
  Accelerometer accelerometer = make();
  EXPECT_EQ(ticks_to_sample(accelerometer, 100), 101);
  EXPECT_TRUE(accelerometer.faults().has(BoardFault::accelerometer_wrong_id));
  EXPECT_FALSE(accelerometer.faults().has(BoardFault::accelerometer_silent));
}

TEST_F(AccelerometerTest, ADeviceThatChangesItsIdIsAnError) {
  Accelerometer accelerometer = running();
  device.id = 0x12;
  EXPECT_EQ(next(accelerometer).status, Status::error);
  EXPECT_TRUE(accelerometer.faults().has(BoardFault::accelerometer_wrong_id));
}

TEST_F(AccelerometerTest, ADeviceWhoseLogicDidNotComeUpIsNotUsed) {
  device.test_response = 0x00;
  Accelerometer accelerometer = make();
  EXPECT_EQ(ticks_to_sample(accelerometer, 100), 101);
  EXPECT_TRUE(accelerometer.faults().has(BoardFault::accelerometer_silent));
}

TEST_F(AccelerometerTest, ADeviceThatSaysTheSameForeverIsAnError) {
  Accelerometer accelerometer = running();
  const int resets = device.resets;
  device.noisy = false;
  int good = 0;
  while (next(accelerometer).status == Status::ok && good < 1000) {
    ++good;
  }
  EXPECT_GE(good, 108);
  EXPECT_LE(good, 111);
  EXPECT_TRUE(accelerometer.faults().has(BoardFault::accelerometer_frozen));
  for (int i = 0; i < 500; ++i) {
    EXPECT_NE(next(accelerometer).status, Status::ok) << "and a reset does not make it better";
  }
  EXPECT_GE(device.resets, resets + 3);  // though it is tried
  device.noisy = true;
  EXPECT_LE(ticks_to_sample(accelerometer, 100), 20);
}

TEST_F(AccelerometerTest, WithoutNewSamplesItIsSetUpAgain) {
  Accelerometer accelerometer = running();
  const int resets = device.resets;
  device.frozen = true;
  for (int i = 0; i < 15; ++i) {
    static_cast<void>(next(accelerometer));
  }
  EXPECT_EQ(accelerometer.read().status, Status::no_reading);
  EXPECT_EQ(device.resets, resets + 1);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
