// SPDX-License-Identifier: MIT

#include "seed.hpp"
#include "telemetry/messages.hpp"
#include "test.hpp"

namespace fantail::telemetry {
namespace {

const Stamp stamp{.run = 4711, .sequence = 12, .time = core::Microseconds{3'456'789}};

State some_state() {
  return {.phase = core::Phase::controlling,
          .reason = core::PhaseReason::guide_clear,
          .command_status = core::CommandStatus::gyro_lost,
          .timing_fault = true,
          .saturated = true,
          .roll_angle_rad = 1.0,
          .roll_rate_rad_s = 2.0,
          .reference_rad = 3.0,
          .excitation_rad = 4.0,
          .unclamped_command_rad = 5.0,
          .command_rad = 6.0,
          .specific_force_m_s2 = 7.0,
          .height_m = 8.0,
          .speed_m_s = 9.0,
          .vertical_speed_m_s = 10.0,
          .tilt_rad = 11.0};
}

Canards some_canards() {
  Canards canards;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    canards.command_rad[i] = 0.1 * static_cast<double>(i);
    canards.encoder_rad[i] = 1.0 + 0.1 * static_cast<double>(i);
    canards.limit_rad[i] = 2.0 + 0.1 * static_cast<double>(i);
  }
  canards.canard_rad = 3.0;
  canards.limited = {true, false, true, false};
  canards.verdicts = {core::CanardVerdict::healthy, core::CanardVerdict::dead, core::CanardVerdict::stalled,
                      core::CanardVerdict::disagreeing};
  return canards;
}

Event phase_event() {
  return {.phase = Event::PhaseChange{.before = core::Phase::armed,
                                      .phase = core::Phase::launched,
                                      .reason = core::PhaseReason::launch_detected}};
}

Event verdict_event() {
  return {.verdict = Event::VerdictChange{
              .canard = 3, .before = core::CanardVerdict::healthy, .verdict = core::CanardVerdict::slipping}};
}

Health some_health() {
  return {.gyro = core::SensorState::fresh,
          .accelerometer = core::SensorState::coasting,
          .verdicts = {core::CanardVerdict::healthy, core::CanardVerdict::dead, core::CanardVerdict::healthy,
                       core::CanardVerdict::healthy},
          .timing_fault = true,
          .longest_tick_s = 0.0005,
          .late_ticks = 3,
          .bus = Health::Bus{.state = hal::CanState::error_passive, .unsent = 1, .overrun = 2, .errors = 3},
          .gateway = Health::Gateway{
              .state = hal::CanState::down, .frames = 4, .lost = 5, .damaged = 6, .foreign = 7, .overrun = 8}};
}

template <typename Content>
void expect_to_come_back(const Content& content) {
  const Packet packet = encode(stamp, content);
  const auto decoded = decode(packet.channel, packet.content());
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->stamp, stamp);
  EXPECT_EQ(std::get<Content>(decoded->content), content);
}

std::vector<Packet> one_of_each() {
  return {encode(stamp, some_state()), encode(stamp, some_canards()), encode(stamp, phase_event()),
          encode(stamp, verdict_event()), encode(stamp, some_health())};
}

TEST(Packet, WhatIsSaidComesBackFieldByField) {
  expect_to_come_back(some_state());
  expect_to_come_back(some_canards());
  expect_to_come_back(phase_event());
  expect_to_come_back(verdict_event());
  expect_to_come_back(some_health());
}

TEST(Packet, WhatIsNotKnownComesBackAsNotKnown) {
  expect_to_come_back(State{});
  expect_to_come_back(Canards{});
  expect_to_come_back(Health{});
}

TEST(Packet, AChannelIsNamedAfterItsType) {
  EXPECT_EQ(name(Channel::state), "FANTAIL_STATE");
  EXPECT_EQ(name(Channel::health), "FANTAIL_HEALTH");
  EXPECT_EQ(channel_named("FANTAIL_EVENT"), Channel::event);
  EXPECT_EQ(channel_named("FANTAIL_STATES"), std::nullopt);
}

TEST(Packet, EveryOtherLengthIsRefused) {
  for (const Packet& packet : one_of_each()) {
    std::vector<std::byte> bytes(packet.bytes.begin(), packet.bytes.end());
    bytes.resize(400);
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
      EXPECT_EQ(decode(packet.channel, std::span{bytes}.first(size)).has_value(), size == packet.size) << size;
    }
  }
}

TEST(Packet, AMessageOfAnotherTypeIsRefused) {
  for (const Packet& packet : one_of_each()) {
    for (const Channel channel : {Channel::state, Channel::canards, Channel::event, Channel::health}) {
      EXPECT_EQ(decode(channel, packet.content()).has_value(), channel == packet.channel);
    }
  }
}

// The fingerprint of the type fills the first eight bytes, big end first; the stamp the next 24.
TEST(Packet, AnotherVersionOfATypeIsRefused) {
  for (Packet packet : one_of_each()) {
    for (std::size_t i = 0; i < 8; ++i) {
      packet.bytes[i] ^= std::byte{1};
      EXPECT_FALSE(decode(packet.channel, packet.content()));
      packet.bytes[i] ^= std::byte{1};
    }
  }
}

TEST(Packet, AWordThatThereIsNotIsRefused) {
  Packet state = encode(stamp, some_state());
  constexpr std::size_t phase = 32;
  for (int word = 0; word < 256; ++word) {
    state.bytes[phase] = static_cast<std::byte>(word);
    EXPECT_EQ(decode(Channel::state, state.content()).has_value(), word <= 4) << word;
  }
  Packet event = encode(stamp, verdict_event());
  constexpr std::size_t canard = 36;
  for (int word = 0; word < 256; ++word) {
    event.bytes[canard] = static_cast<std::byte>(word);
    EXPECT_EQ(decode(Channel::event, event.content()).has_value(), word >= 1 && word <= 4) << word;
  }
}

TEST(Packet, AnyBytesAtAllAreReadOrRefused) {
  std::mt19937 random{test::seed(5)};
  std::uniform_int_distribution<int> byte{0, 255};
  for (const Packet& packet : one_of_each()) {
    for (int round = 0; round < 20'000; ++round) {
      Packet damaged = packet;
      for (int hit = 0; hit < 3; ++hit) {
        damaged.bytes[static_cast<std::size_t>(byte(random)) % damaged.size] = static_cast<std::byte>(byte(random));
      }
      if (const auto decoded = decode(damaged.channel, damaged.content())) {
        EXPECT_GE(decoded->stamp.sequence, 0);
      }
    }
  }
}

}  // namespace
}  // namespace fantail::telemetry
