// SPDX-License-Identifier: MIT

#include "fake_capture.hpp"
#include "hal/stm32f4/edge_timer.hpp"
#include "hal/stm32f4/imu.hpp"
#include "hal/stm32f4/sample_edges.hpp"
#include "imu_rig.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

// When a sample was measured, of an IMU whose own clock is wrong.

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

/// Samples of a device with this period; how many of them were believed to have come at their edges.
int believed(SampleEdges& edges, double period_us, int samples, std::uint32_t begin = 1'000'000) {
  int count = 0;
  for (int i = 1; i <= samples; ++i) {
    count += edges.take(begin + static_cast<std::uint32_t>(std::lround(period_us * i)), false) ? 1 : 0;
  }
  return count;
}

TEST(SampleEdges, AreBelievedFromTheTenthOnWhateverTheDevicesOscillatorDoes) {
  for (const double period_us : {965.0, 990.0, 1000.0, 1010.0, 1035.0}) {  // 1.5 % and 2 %
    SampleEdges edges;
    EXPECT_EQ(believed(edges, period_us, 1000), 990) << period_us;
    EXPECT_FALSE(edges.lost());
  }
}

TEST(SampleEdges, TheWrapOfTheCounterIsNone) {
  SampleEdges edges;
  EXPECT_EQ(believed(edges, 1010.0, 1000, 0xFFFF'FFFF - 500'000), 990);
}

TEST(SampleEdges, ASampleThatWasNeverReadIsNoMisfit) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 990.0, 20));
  EXPECT_TRUE(edges.take(1'000'000 + 22 * 990, true));
  EXPECT_TRUE(edges.take(1'000'000 + 26 * 990, true));
}

TEST(SampleEdges, WithoutAWireNoneIsBelievedAndAfterAHundredSamplesItIsLost) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 100));
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(edges.lost());
    EXPECT_FALSE(edges.take(1'100'000, false));
  }
  for (int i = 0; i < 3; ++i) {  // of the twenty that fitted, two misfits leave ten
    EXPECT_FALSE(edges.take(1'100'000, false));
  }
  EXPECT_TRUE(edges.lost());
  EXPECT_GE(believed(edges, 1000.0, 100), 89) << "and it comes back";
  EXPECT_FALSE(edges.lost());
}

TEST(SampleEdges, ALineThatFloatsIsNotBelieved) {
  std::mt19937 random{1};
  std::uniform_int_distribution<std::uint32_t> when{0, 999};
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 100));
  int count = 0;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    count += edges.take(2'000'000 + 1000 * i + when(random), i % 2 == 0) ? 1 : 0;
  }
  EXPECT_LE(count, 3) << "in 100 s, before it was found out";
  EXPECT_TRUE(edges.lost());
}

TEST(SampleEdges, ALineWithThousandsOfEdgesIsNotBelievedThoughTheLatestIsAlwaysATickBehindTheLast) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 100));
  for (std::uint32_t i = 0; i < 200; ++i) {
    EXPECT_FALSE(edges.take(2'000'000 + 1000 * i, true));
  }
  EXPECT_TRUE(edges.lost());
}

TEST(SampleEdges, ASpikeCostsTwoSamplesTheirTimesAndNotTheLine) {
  SampleEdges edges;
  static_cast<void>(believed(edges, 1000.0, 50));
  EXPECT_FALSE(edges.take(1'051'300, true));
  EXPECT_FALSE(edges.take(1'052'000, false));
  EXPECT_TRUE(edges.take(1'053'000, false));
}

TEST(EdgeTimer, CountsMicrosecondsAndKeepsTheLastEdge) {
  for (const std::uint32_t hz : {84'000'000U, 16'000'000U}) {
    test::RegisterWorld world;
    test::FakeClock clock;
    std::optional<test::LineEdge> rose;
    test::FakeCapture capture{world, clock, static_cast<double>(hz), [&] { return rose; }};
    EdgeTimer timer{capture.registers, hz};
    ASSERT_TRUE(capture.captures());
    EXPECT_EQ(timer.last_edge(), 0U);
    rose = {Microseconds{12'345}, 1};
    EXPECT_FALSE(timer.take_overrun());
    clock.time = Microseconds{13'000};
    EXPECT_EQ(timer.last_edge(), 12'345U);
    EXPECT_EQ(timer.now(), 13'000U);
    rose = {Microseconds{12'900}, 2};
    EXPECT_FALSE(timer.take_overrun());
    rose = {Microseconds{12'950}, 3};
    EXPECT_TRUE(timer.take_overrun());
    EXPECT_FALSE(timer.take_overrun());
    // IC4F: eight samples at the timer's clock (RM0090 section 18.4.8).
    EXPECT_EQ(test::RegisterWorld::peek(capture.registers.ccmr[1]), 0x3100U);
    EXPECT_EQ(test::RegisterWorld::peek(capture.registers.ccer), 0x1000U);
  }
}

}  // namespace

}  // namespace fantail::hal::stm32f4
