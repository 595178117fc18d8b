// SPDX-License-Identifier: MIT

#include "avionics/identity.hpp"
#include "avionics/log_tick_of.hpp"
#include "core/autopilot.hpp"
#include "input/scenario_file.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/log_tick.hpp"
#include "protocol/plan_block.hpp"
#include "protocol/state_block.hpp"
#include "protocol/tick_digest.hpp"
#include "sim/world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

using protocol::LogRecord;

struct Flown {
  std::vector<core::TickRecord> records{};
  std::vector<std::byte> log{};
  core::FlightPlan plan{};
};

Flown fly(const std::string& name) {
  const sim::Scenario scenario = input::load_scenario(name, {});
  sim::World world{scenario, sim::World::large_flash};
  Flown flown{.plan = scenario.plan};
  while (!world.over()) {
    flown.records.push_back(world.tick());
    world.advance();
  }
  flown.log.assign(world.recorded().begin(), world.recorded().end());
  return flown;
}

// A reader as simple as one can be, that knows nothing but the format.
struct Replay {
  std::optional<protocol::LogHeader> header;
  std::optional<core::FlightPlan> plan;
  std::optional<core::Autopilot> law;
  protocol::SampleTimes times{};
  std::uint32_t sequence = 0;
  std::size_t headers = 0;
  std::size_t checkpoints = 0;
  std::size_t equal = 0;
  std::vector<protocol::LogTick> ticks;
  std::vector<protocol::LogEvent> events;
  std::vector<protocol::LogHealth> health;

  void read(std::span<const std::byte> log) {
    protocol::LogFrameReader reader{log};
    while (const auto frame = reader.next()) {
      ASSERT_EQ(frame->head.sequence, sequence);
      sequence += 1;
      read(*frame);
    }
    EXPECT_EQ(reader.foreign_bytes(), 0U);
  }

  void read(const protocol::LogFrame& frame) {
    switch (static_cast<LogRecord>(frame.head.type)) {
      case LogRecord::header:
        header = protocol::decode_log_header(frame.payload);
        ASSERT_TRUE(header.has_value());
        plan = protocol::read_plan_block(header->plan_block).plan;
        ASSERT_TRUE(plan.has_value());
        headers += 1;
        break;
      case LogRecord::checkpoint: begin_at(frame.payload); break;
      case LogRecord::tick: fly(frame); break;
      case LogRecord::event:
        ASSERT_TRUE(protocol::unpack_event(frame.head.time, frame.payload).has_value());
        events.push_back(*protocol::unpack_event(frame.head.time, frame.payload));
        break;
      case LogRecord::health:
        ASSERT_TRUE(protocol::unpack_health(frame.head.time, frame.payload).has_value());
        health.push_back(*protocol::unpack_health(frame.head.time, frame.payload));
        break;
    }
  }

  // Everything that was remembered before is forgotten, so that each checkpoint has to bear what follows it.
  void begin_at(std::span<const std::byte> payload) {
    ASSERT_TRUE(plan.has_value());
    law.emplace(*plan);
    ASSERT_TRUE(protocol::restore_state(*law, payload.subspan(protocol::log_checkpoint_times_size)));
    times = {.imu = core::Microseconds{static_cast<std::int64_t>(protocol::get<8>(payload, 0))},
             .accelerometer = core::Microseconds{static_cast<std::int64_t>(protocol::get<8>(payload, 8))}};
    checkpoints += 1;
  }

  void fly(const protocol::LogFrame& frame) {
    const auto tick = protocol::unpack_tick(frame.head.time, frame.payload, times);
    ASSERT_TRUE(tick.has_value());
    ASSERT_TRUE(law.has_value());
    ticks.push_back(*tick);
    const avionics::SampleScales scales{
        .imu = {.rate_rad_s = header->rate_scale_rad_s, .specific_force_m_s2 = header->specific_force_scale_m_s2},
        .accelerometer_m_s2 = header->accelerometer_scale_m_s2};
    const core::TickRecord& record = law->step(avionics::inputs_of(*tick, scales, plan->canards));
    equal += protocol::tick_digest(record) == tick->digest ? 1 : 0;
  }
};

std::map<std::int64_t, const core::TickRecord*> by_time(const std::vector<core::TickRecord>& records) {
  std::map<std::int64_t, const core::TickRecord*> out;
  for (const core::TickRecord& record : records) {
    out[record.time.count()] = &record;
  }
  return out;
}

const core::TickRecord& first_that_flies(const Flown& flown) {
  for (const core::TickRecord& record : flown.records) {
    if (record.phase != core::Phase::safe && record.phase != core::Phase::armed) {
      return record;
    }
  }
  return flown.records.back();
}

class RecordedFlight : public testing::TestWithParam<const char*> {};

TEST_P(RecordedFlight, IsReplayedFromEachOfItsCheckpointsWithEverySignalOfEveryTick) {
  const Flown flown = fly(GetParam());
  Replay replay;
  replay.read(flown.log);
  ASSERT_FALSE(replay.ticks.empty());
  EXPECT_EQ(replay.equal, replay.ticks.size());
  const auto recorded_s = static_cast<double>((replay.ticks.back().time - replay.ticks.front().time).count()) * 1e-6;
  EXPECT_NEAR(static_cast<double>(replay.checkpoints), recorded_s, 2.0);
  EXPECT_NEAR(static_cast<double>(replay.health.size()), 10.0 * recorded_s, 8.0);
  EXPECT_EQ(replay.headers, 1U + static_cast<std::size_t>(recorded_s / 5.0));
  const auto records = by_time(flown.records);
  for (const protocol::LogTick& tick : replay.ticks) {
    const core::TickRecord& record = *records.at(tick.time.count());
    ASSERT_EQ(tick.digest, protocol::tick_digest(record));
    ASSERT_EQ(tick.phase, record.phase);
    ASSERT_EQ(tick.command, record.command);
  }
}

TEST_P(RecordedFlight, BeginsHalfASecondBeforeTheForceHadLastedFiftyMillisecondsAndLeavesNoTickOut) {
  const Flown flown = fly(GetParam());
  Replay replay;
  replay.read(flown.log);
  ASSERT_FALSE(replay.ticks.empty());
  // Detection asks for more force, for longer: the record was there before it, and by less than that takes.
  const core::Microseconds before = first_that_flies(flown).time - replay.ticks.front().time;
  EXPECT_GE(before, core::Microseconds{500'000});
  EXPECT_LE(before, core::Microseconds{750'000});
  for (std::size_t i = 1; i < replay.ticks.size(); ++i) {
    ASSERT_EQ(replay.ticks[i].time - replay.ticks[i - 1].time, core::Microseconds{1'000});
  }
  // The page that was being filled when the world ended.
  EXPECT_GE(replay.ticks.back().time, flown.records.back().time - core::Microseconds{20'000});
}

TEST_P(RecordedFlight, TellsItsPhasesAndWhatItIs) {
  const Flown flown = fly(GetParam());
  Replay replay;
  replay.read(flown.log);
  ASSERT_TRUE(replay.header.has_value());
  EXPECT_EQ(replay.header->power_up, 1U);
  EXPECT_EQ(replay.header->flight, 0U);
  EXPECT_EQ(replay.header->firmware_version, avionics::firmware_version());
  EXPECT_EQ(protocol::plan_crc(*replay.plan), protocol::plan_crc(flown.plan));
  std::vector<std::pair<core::Phase, core::PhaseReason>> told;
  for (const protocol::LogEvent& event : replay.events) {
    if (event.kind == protocol::LogEventKind::phase) {
      told.emplace_back(static_cast<core::Phase>(event.value), static_cast<core::PhaseReason>(event.detail));
    }
  }
  std::vector<std::pair<core::Phase, core::PhaseReason>> flown_phases;
  for (const core::TickRecord& record : flown.records) {
    const bool is_news = flown_phases.empty() || flown_phases.back().first != record.phase;
    if (record.phase != core::Phase::safe && is_news) {
      flown_phases.emplace_back(record.phase, record.reason);
    }
  }
  EXPECT_EQ(told, flown_phases);
  EXPECT_EQ(replay.events.front().kind, protocol::LogEventKind::recording_began);
}

TEST_P(RecordedFlight, IsTheSameWhenTheFlashHasNoRoomForItsRecord) {
  const Flown flown = fly(GetParam());
  const sim::Scenario scenario = input::load_scenario(GetParam(), {});
  sim::World world{scenario, sim::World::small_flash};
  for (const core::TickRecord& record : flown.records) {
    ASSERT_FALSE(world.over());
    ASSERT_EQ(protocol::tick_digest(world.tick()), protocol::tick_digest(record)) << record.time.count();
    world.advance();
  }
  EXPECT_TRUE(world.over());
  EXPECT_TRUE(world.recorded().empty());
}

INSTANTIATE_TEST_SUITE_P(Shipped, RecordedFlight, testing::Values("tasha3_launch1", "tasha3_launch2", "tunnel_steps"));

}  // namespace
}  // namespace fantail::sil
