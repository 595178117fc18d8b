// SPDX-License-Identifier: MIT
#include "avionics/avionics.hpp"

#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;
using core::Phase;
using hal::Microseconds;
using Pulses = std::array<std::optional<hal::Pulse>, hal::canards>;

constexpr float force_scale = 9.80665F / 1000.0F;  // 1 g is 1000 counts

struct FakeClock final : hal::Clock {
  Microseconds time{};
  [[nodiscard]] Microseconds now() const override { return time; }
};
struct FakeImu final : hal::Imu {
  hal::ImuSample sample{.time = {}, .rate = {}, .specific_force = {1000, 0, 0}, .status = hal::Status::ok};
  hal::ImuSample read() override { return sample; }
  [[nodiscard]] hal::ImuScale scale() const override { return {0.001F, force_scale}; }
};
struct FakeAccelerometer final : hal::Accelerometer {
  hal::AccelerometerSample sample{.time = {}, .specific_force = {1000, 0, 0}, .status = hal::Status::ok};
  hal::AccelerometerSample read() override { return sample; }
  [[nodiscard]] float scale() const override { return force_scale; }
};
struct FakeServo final : hal::Servo {
  Pulses written{};
  int writes = 0;
  void write(const Pulses& pulses) override {
    written = pulses;
    writes += 1;
  }
};
struct FakeEncoder final : hal::Encoder {
  hal::EncoderReading reading{};
  hal::EncoderReading read() override { return reading; }
};
struct FakeArmSwitch final : hal::ArmSwitch {
  bool is_closed = false;
  [[nodiscard]] bool closed() const override { return is_closed; }
};

core::FlightPlan tunnel_plan() {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  return plan;
}

class AnAvionics : public testing::Test {
 protected:
  AnAvionics() {
    for (hal::EncoderSample& encoder : encoder_.reading.each) {
      encoder.status = hal::Status::ok;
    }
  }
  const core::TickRecord& tick() {
    clock_.time += Microseconds{1000};
    imu_.sample.time = accelerometer_.sample.time = encoder_.reading.time = clock_.time;
    return avionics_.tick();
  }
  void rest(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick();
    }
  }

  FakeClock clock_;
  FakeImu imu_;
  FakeAccelerometer accelerometer_;
  FakeServo servo_;
  FakeEncoder encoder_;
  FakeArmSwitch arm_switch_;
  Avionics avionics_{{clock_, imu_, accelerometer_, servo_, encoder_, arm_switch_}, tunnel_plan()};
};

TEST_F(AnAvionics, WritesEveryServoOnceATick) {
  rest(3);
  EXPECT_EQ(servo_.writes, 3);
}

TEST_F(AnAvionics, StandsSafeAtTrim) {
  rest(100);
  EXPECT_EQ(tick().phase, Phase::safe);
  for (const auto& pulse : servo_.written) {
    EXPECT_EQ(pulse, hal::Pulse{1'500'000});
  }
}

TEST_F(AnAvionics, LeavesACanardOffWhoseEncoderHasNotSpoken) {
  encoder_.reading.each[2].status = hal::Status::no_reading;
  tick();
  EXPECT_TRUE(servo_.written[0].has_value());
  EXPECT_FALSE(servo_.written[2].has_value());
}

TEST_F(AnAvionics, ArmsOnSwitchAndCommandTogether) {
  arm_switch_.is_closed = true;
  rest(10);
  avionics_.command_arm();
  EXPECT_EQ(tick().phase, Phase::armed);
}

TEST_F(AnAvionics, AnArmCommandLastsOneTick) {
  avionics_.command_arm();
  EXPECT_EQ(tick().phase, Phase::safe) << "the switch is open";
  arm_switch_.is_closed = true;
  rest(10);
  EXPECT_EQ(tick().phase, Phase::safe) << "the command is spent";
}

TEST_F(AnAvionics, AStartCommandLastsOneTickToo) {
  arm_switch_.is_closed = true;
  rest(10);
  avionics_.command_start();
  rest(1);
  avionics_.command_arm();
  rest(3000);
  EXPECT_EQ(tick().phase, Phase::armed) << "the start command came before arming";
  avionics_.command_start();
  EXPECT_EQ(tick().phase, Phase::controlling);
}

TEST_F(AnAvionics, APositiveRollRateTurnsTheCanardsAgainstIt) {
  arm_switch_.is_closed = true;
  rest(10);
  avionics_.command_arm();
  rest(3000);
  avionics_.command_start();
  rest(1);
  imu_.sample.rate = {1000, 0, 0};  // 1 rad/s times 0.05 s
  tick();
  const core::TickRecord& record = tick();
  EXPECT_EQ(record.phase, Phase::controlling);
  EXPECT_NEAR(record.command.radians(), -0.05F, 0.005F);
  EXPECT_LT(*servo_.written[0], hal::Pulse{1'500'000});
}

TEST_F(AnAvionics, BothAccelerometersEncodersAndTheClockReachTheRecord) {
  encoder_.reading.each[1].counts = 512;
  const core::TickRecord& record = tick();
  EXPECT_EQ(record.time, Microseconds{1000});
  EXPECT_NEAR(record.encoders[1]->degrees(), 11.25F, 1e-4F);
  EXPECT_NEAR(record.canard_angle->degrees(), 11.25F / 4.0F, 1e-4F);
}

}  // namespace
}  // namespace fantail::avionics
