// SPDX-License-Identifier: MIT
// When a sample was measured, of an IMU whose own clock is wrong.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "hal/stm32f4/imu.hpp"
#include "imu_rig.hpp"

namespace fantail::hal::stm32f4 {
namespace {

class ImuTime : public test::ImuRig {
 protected:
  struct Errors {
    double least_us = 1e9;
    double most_us = -1e9;
    int samples = 0;  ///< new ones
    int older = 0;    ///< that went back in time
    [[nodiscard]] double worst_us() const { return std::max(std::abs(least_us), std::abs(most_us)); }
  };

  void SetUp() override {
    ImuRig::SetUp();
    be_free_of_noise();
    // Each sample says in its counts when it was measured, in units of 100 us.
    device.before_sample = [this](Microseconds time) {
      device.rate_deg_s[0] = static_cast<double>(time.count() / 100 % 30'000) * 2000.0 / 32768.0;
      device.force_g[0] = device.force_g[0] > 1.0 ? 0.9 : 1.1;  // it moves, as a real one
      device.force_g[1] = device.force_g[2] = device.force_g[0];
      const int even = device.force_g[0] > 1.0 ? 100 : 0;
      device.rate_deg_s[1] = static_cast<double>(time.count() % 100 + even) * 2000.0 / 32768.0;
      device.rate_deg_s[2] = device.force_g[0];
    };
  }
  void set_period(double period_us) {
    device.period_us = period_us;
    device.reset();
    clock.time += 2 * tick;
  }
  /// The times that the driver gives, against those of the device, over so many ticks.
  Errors errors(Imu& imu, int ticks) {
    Errors errors;
    Microseconds last = imu.read().time;
    for (int i = 0; i < ticks; ++i) {
      const ImuSample sample = next(imu);
      if (sample.status != Status::ok || sample.time == last) {
        continue;
      }
      const std::int64_t turn = 3'000'000;
      const std::int64_t put_there = sample.rate[0] * 100 + sample.rate[1] % 100;
      const std::int64_t said = (sample.time + Imu::filter_delay).count() % turn;
      const auto error = static_cast<double>((said - put_there + turn + turn / 2) % turn - turn / 2);
      errors.least_us = std::min(errors.least_us, error);
      errors.most_us = std::max(errors.most_us, error);
      errors.samples += 1;
      errors.older += sample.time < last ? 1 : 0;
      last = sample.time;
    }
    return errors;
  }
};

TEST_F(ImuTime, IsKnownToTwoMicrosecondsWhateverTheDevicesClockDoes) {
  for (const double period_us : {990.0, 1000.0, 1010.0, 965.0, 1035.0}) {
    set_period(period_us);
    Imu imu = running();
    read_for(imu, 20);
    const Errors with = errors(imu, 2900);
    EXPECT_LE(with.worst_us(), 2.0) << period_us;
    EXPECT_EQ(with.older, 0);
    EXPECT_TRUE(imu.faults().none());
    RecordProperty("period_" + std::to_string(static_cast<int>(period_us)), std::to_string(with.worst_us()));
  }
}

TEST_F(ImuTime, WithoutItsWireASampleIsUpToHalfAMillisecondOffAndTheFaultIsNamed) {
  line = [] { return std::optional<test::LineEdge>{}; };
  for (const double period_us : {990.0, 1010.0}) {
    set_period(period_us);
    Imu imu = running();
    read_for(imu, 20);
    const Errors without = errors(imu, 2900);
    EXPECT_GE(without.most_us, 450.0);
    EXPECT_LE(without.least_us, -450.0);
    EXPECT_LE(without.worst_us(), 520.0);
    EXPECT_TRUE(imu.faults().has(BoardFault::imu_line_lost));
    EXPECT_EQ(imu.read().status, Status::ok) << "and it goes on";
  }
}

TEST_F(ImuTime, NoSampleIsReadTwiceAndOneThatASlowerTickMissesIsNone) {
  for (const double period_us : {990.0, 1010.0}) {
    set_period(period_us);
    Imu imu = running();
    read_for(imu, 20);
    const Errors with = errors(imu, 2900);
    // 1 % slower: each is read, 29 ticks find none. 1 % faster: each tick finds one, 29 are never read.
    EXPECT_NEAR(with.samples, period_us > 1000.0 ? 2900 * 1000 / 1010 : 2900, 1);
  }
}

TEST_F(ImuTime, TheWireMayComeAndGo) {
  device.period_us = 1010.0;
  Imu imu = running();
  read_for(imu, 200);
  bool on = true;
  std::optional<test::LineEdge> held;
  line = [&] { return on ? (held = device.interrupt_1()) : held; };
  for (int i = 0; i < 6; ++i) {
    on = !on;
    const Errors changing = errors(imu, 150);
    EXPECT_EQ(changing.older, 0);
    EXPECT_LE(changing.worst_us(), 520.0);
    EXPECT_EQ(imu.faults().has(BoardFault::imu_line_lost), !on);
  }
}

TEST_F(ImuTime, ALineThatFloatsIsNotBelievedAndCostsNoTime) {
  Imu imu = running();
  read_for(imu, 200);
  spi.forget_traffic();
  read_for(imu, 101);
  const double quiet_us = spi.wire_us();
  std::mt19937 random{1};
  std::uniform_int_distribution<int> ago{0, 100};
  std::int64_t number = 0;
  line = [&]() -> std::optional<test::LineEdge> {
    return test::LineEdge{clock.time - Microseconds{ago(random)}, number += 5};
  };
  read_for(imu, 105);
  spi.forget_traffic();
  const Errors floating = errors(imu, 100);
  EXPECT_LE(floating.worst_us(), 520.0);
  EXPECT_EQ(floating.older, 0);
  EXPECT_DOUBLE_EQ(spi.wire_us(), quiet_us);
  EXPECT_TRUE(imu.faults().has(BoardFault::imu_line_lost));
}

TEST_F(ImuTime, ASampleThatComesWhileAnotherIsReadIsReadWithItsOwnTime) {
  Imu imu = running();
  read_for(imu, 20);
  device.before_status = [this] { clock.time += tick; };
  const ImuSample sample = next(imu);
  EXPECT_EQ((sample.time + Imu::filter_delay).count() % 3'000'000, sample.rate[0] * 100 + sample.rate[1] % 100);
  EXPECT_EQ(sample.time + Imu::filter_delay, device.interrupt_1()->time);
}

TEST_F(ImuTime, AfterAResetOfTheDeviceItsEdgesAreBelievedAgain) {
  Imu imu = running();
  read_for(imu, 100);
  device.reset();
  clock.time += tick;
  read_for(imu, 100);
  EXPECT_LE(errors(imu, 100).worst_us(), 2.0);
  EXPECT_TRUE(imu.faults().none());
}

}  // namespace
}  // namespace fantail::hal::stm32f4
