// SPDX-License-Identifier: MIT
#include "avionics/telemetry.hpp"

#include "avionics/board_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;

struct Rates {
  int commands;
  int encoders;
  int status;
  int motion;
};

Rates heard_in_a_second(BoardRig& rig) {
  const auto now = [&rig] {
    return Rates{.commands = rig.pc.count<protocol::CommandReport>(),
                 .encoders = rig.pc.count<protocol::EncoderReport>(),
                 .status = rig.pc.count<protocol::StatusReport>(),
                 .motion = rig.pc.count<protocol::MotionReport>()};
  };
  const Rates before = now();
  rig.run(second);
  const Rates after = now();
  return {.commands = after.commands - before.commands,
          .encoders = after.encoders - before.encoders,
          .status = after.status - before.status,
          .motion = after.motion - before.motion};
}

void expect_rate(BoardRig& rig, int of_canards) {
  const Rates rates = heard_in_a_second(rig);
  EXPECT_EQ(rates.commands, of_canards);
  EXPECT_EQ(rates.encoders, of_canards);
  EXPECT_EQ(rates.status, 100);
  EXPECT_EQ(rates.motion, 100);
}

TEST(Telemetry, ReportsCanardsAHundredTimesASecondWhileNothingMayMove) {
  BoardRig rig;
  expect_rate(rig, 100);
}

TEST(Telemetry, ReportsCanardsEveryMillisecondInABenchSession) {
  BoardRig rig;
  rig.open_session();
  expect_rate(rig, 1000);
}

TEST(Telemetry, ReportsCanardsEveryMillisecondInTheSelfTest) {
  BoardRig rig;
  rig.run(second);
  rig.pc.say(protocol::ArmAction::self_test);
  rig.tick();
  expect_rate(rig, 1000);
}

TEST(Telemetry, AnArmedRocketIsQuietAgain) {
  BoardRig rig;
  rig.arm();
  expect_rate(rig, 100);
}

TEST(Telemetry, ReportsCanardsEveryMillisecondInControl) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  BoardRig rig{plan};
  rig.arm();
  rig.pc.say(protocol::ArmAction::start, rig.armed_with);
  ASSERT_EQ(rig.tick().phase, core::Phase::controlling);
  expect_rate(rig, 1000);
}

TEST(Telemetry, ReportsCanardsEveryMillisecondWhileTheRocketLeavesItsGuide) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, core::Phase::armed);
  rig.hardware.imu.specific_force = rig.hardware.accelerometer.specific_force = {5000, 0, 0};
  int ticks = 0;
  while (rig.tick().phase == core::Phase::armed && ++ticks < 1000) {
  }
  const int before = rig.pc.count<protocol::CommandReport>();
  ASSERT_EQ(rig.run(50 * millisecond)->phase, core::Phase::launched);
  EXPECT_EQ(rig.pc.count<protocol::CommandReport>() - before, 50);
}

TEST(Telemetry, TheSensorsAreReportedInSafeOnly) {
  BoardRig rig;
  rig.hardware.imu.rate = {-100, 20, 3000};
  rig.hardware.accelerometer.specific_force = {1000, 500, -250};
  const auto gyros = [&rig] { return rig.pc.count<protocol::GyroReport>(); };
  rig.run(second);
  EXPECT_EQ(gyros(), 50);
  EXPECT_EQ(rig.pc.count<protocol::AccelerometerReport>(), 50);
  const auto& gyro = *rig.pc.heard<protocol::GyroReport>();
  EXPECT_EQ(gyro.quality, core::SampleQuality::valid);
  EXPECT_NEAR(gyro.rate_rad_s.x, -0.1F, 0.001F);
  EXPECT_NEAR(gyro.rate_rad_s.y, 0.02F, 0.001F);
  EXPECT_NEAR(gyro.rate_rad_s.z, 3.0F, 0.001F);
  EXPECT_EQ(gyro.time_ms % 20, 9) << "the tick, of which the first is at one millisecond";
  rig.hardware.imu.rate = {};
  ASSERT_EQ(rig.arm().phase, core::Phase::armed);
  const int before = gyros();
  rig.run(second);
  EXPECT_EQ(gyros(), before);
}

TEST(Telemetry, TheTwoAccelerometersAreReportedInTurn) {
  BoardRig rig;
  rig.hardware.imu.specific_force = {1000, 0, 0};
  rig.hardware.accelerometer.specific_force = {0, 500, -250};
  int of_imu = 0;
  int of_second = 0;
  int heard = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    rig.tick();
    if (rig.pc.count<protocol::AccelerometerReport>() == heard) {
      continue;
    }
    heard = rig.pc.count<protocol::AccelerometerReport>();
    const auto& report = *rig.pc.heard<protocol::AccelerometerReport>();
    if (report.sensor == protocol::Accelerometer::of_imu) {
      of_imu += 1;
      EXPECT_NEAR(report.specific_force_m_s2.x, 9.80665F, 0.006F);
    } else {
      of_second += 1;
      EXPECT_NEAR(report.specific_force_m_s2.y, 0.5F * 9.80665F, 0.006F);
      EXPECT_NEAR(report.specific_force_m_s2.z, -0.25F * 9.80665F, 0.006F);
    }
  }
  EXPECT_EQ(of_imu, 25);
  EXPECT_EQ(of_second, 25);
}

TEST(Telemetry, TheLongestTickOfATenthOfASecondIsReported) {
  Telemetry telemetry;
  hal::sim::CanWire wire;
  hal::sim::CanBus board{wire};
  hal::sim::CanBus pc{wire};
  const core::TickRecord record{};
  std::vector<int> longest_us;
  for (int tick = 0; tick < 300; ++tick) {
    Report report{};
    report.tick_duration = Microseconds{tick == 50 ? 700 : 200};
    telemetry.send(record, core::Inputs{}, report, board);
    while (const auto frame = pc.receive()) {
      const auto decoded = protocol::decode_from_avionics(bus_frame(*frame));
      if (const auto* health = std::get_if<protocol::HealthReport>(&*decoded.message)) {
        longest_us.push_back(health->longest_tick_us);
      }
    }
  }
  EXPECT_EQ(longest_us, (std::vector<int>{200, 700, 200}));
}

TEST(Telemetry, TheReportsSayWhatTheServosAreToldAndWhatTheEncodersRead) {
  BoardRig rig;
  rig.unplugged[3] = true;
  rig.open_session();
  rig.pc.say(protocol::BenchRequest{.angle = {5_deg, std::nullopt, std::nullopt, std::nullopt}});
  rig.run(second);
  const auto& commands = *rig.pc.heard<protocol::CommandReport>();
  const auto& encoders = *rig.pc.heard<protocol::EncoderReport>();
  EXPECT_NEAR(commands.angle[0]->degrees(), 5.0F, 0.006F);
  EXPECT_NEAR(encoders.angle[0]->degrees(), 5.0F, 0.02F);
  EXPECT_NEAR(encoders.angle[1]->degrees(), 0.0F, 0.02F);
  EXPECT_FALSE(encoders.angle[3]);
  EXPECT_EQ(rig.pc.heard<protocol::HealthReport>()->verdicts[3], core::CanardVerdict::dead);
}

TEST(Telemetry, TheLimitsAreThoseOfThePlan) {
  core::FlightPlan plan = core::default_plan();
  plan.canards.each[2].mechanical_stop = 9_deg;
  plan.controller.canard_limit = 9_deg;
  BoardRig rig{plan};
  rig.run(second);
  EXPECT_NEAR(rig.pc.heard<protocol::LimitReport>()->limit[2].degrees(), 9.0F, 0.001F);
}

TEST(Telemetry, TheHeartbeatNamesThePlanByItsChecksum) {
  core::FlightPlan plan = core::default_plan();
  plan.controller.canard_limit = 6_deg;
  BoardRig rig{plan};
  rig.run(second);
  // The last four bytes of the plan's block, little-endian.
  std::array<std::byte, protocol::largest_plan_block> block{};
  const std::size_t size = protocol::write_plan_block(plan, block);
  std::uint32_t checksum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    checksum |= static_cast<std::uint32_t>(block[size - 4 + i]) << (8U * i);
  }
  EXPECT_EQ(rig.pc.heard<protocol::HeartbeatReport>()->plan_crc, checksum);
  EXPECT_EQ(rig.pc.heard<protocol::HeartbeatReport>()->version, protocol::bus_protocol_version);
}

TEST(Telemetry, EvenTheWorstMillisecondFitsOnTheBus) {
  BoardRig rig;
  hal::sim::CanBus tap{rig.wire};
  rig.open_session();
  int most_bits = 0;
  for (int i = 0; i < 3000; ++i) {
    if (i % 20 == 0) {
      rig.pc.say(protocol::BenchSession{.action = protocol::SessionAction::keep, .session = 7});
    }
    if (i % 5 == 0) {
      rig.pc.say(protocol::BenchRequest{.angle = {5_deg, 5_deg, 5_deg, 5_deg}});
    }
    while (tap.receive()) {
    }
    rig.tick();
    int bits = 0;
    while (tap.receive()) {
      bits += 135;  // of any frame of eight bytes, all stuff bits counted
    }
    most_bits = std::max(most_bits, bits);
  }
  EXPECT_GE(most_bits, 270);
  EXPECT_LT(most_bits, 1000);
}

}  // namespace
}  // namespace fantail::avionics
