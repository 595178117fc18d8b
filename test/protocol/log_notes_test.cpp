// SPDX-License-Identifier: MIT
#include "protocol/log_notes.hpp"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace fantail::protocol {
namespace {

constexpr core::Microseconds now{42};

TEST(LogEvent, ComesBackWithEverythingInIt) {
  const LogEvent event{.time = now,
                       .kind = LogEventKind::canard_verdict,
                       .value = static_cast<std::uint8_t>(core::CanardVerdict::disagreeing),
                       .detail = 0,
                       .index = 3,
                       .number = 0x12345678};
  EXPECT_EQ(unpack_event(now, pack(event)), event);
}

TEST(LogEvent, OneOfWhichThisVersionKnowsNothingIsRefused) {
  const auto accepts = [](std::uint8_t kind, std::uint8_t value, std::uint8_t detail, std::uint8_t index) {
    const LogEvent event{.kind = static_cast<LogEventKind>(kind), .value = value, .detail = detail, .index = index};
    return unpack_event(now, pack(event)).has_value();
  };
  const auto number = [](LogEventKind kind) { return static_cast<std::uint8_t>(kind); };
  EXPECT_FALSE(accepts(log_event_kinds, 0, 0, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::phase), 4, 15, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::phase), 5, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::phase), 0, 16, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::canard_verdict), 4, 0, 3));
  EXPECT_FALSE(accepts(number(LogEventKind::canard_verdict), 4, 0, 4));
  EXPECT_FALSE(accepts(number(LogEventKind::recording_ended), 4, 0, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::recording_began), 1, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::recording_began), 2, 0, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::resumed), 1, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::resumed), 2, 0, 0));
}

TEST(LogHealth, ComesBackWithEverythingInIt) {
  const LogHealth health{.time = now,
                         .verdicts = {core::CanardVerdict::healthy, core::CanardVerdict::dead,
                                      core::CanardVerdict::stalled, core::CanardVerdict::slipping},
                         .gyro = core::SensorState::coasting,
                         .accelerometer = core::SensorState::lost,
                         .bus_state = 3,
                         .longest_tick_us = 0x0102,
                         .longest_queue = 0x0304,
                         .ticks_dropped = 0x05060708,
                         .unsent = 0x090A0B0C,
                         .bus_errors = 0x0D0E0F10};
  const auto bytes = pack(health);
  const auto back = unpack_health(now, bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->time, now);
  EXPECT_EQ(back->verdicts, health.verdicts);
  EXPECT_EQ(back->gyro, health.gyro);
  EXPECT_EQ(back->accelerometer, health.accelerometer);
  EXPECT_EQ(back->bus_state, 3);
  EXPECT_EQ(back->longest_tick_us, 0x0102);
  EXPECT_EQ(back->longest_queue, 0x0304);
  EXPECT_EQ(back->ticks_dropped, 0x05060708U);
  EXPECT_EQ(back->unsent, 0x090A0B0CU);
  EXPECT_EQ(back->bus_errors, 0x0D0E0F10U);
  EXPECT_FALSE(unpack_health(now, std::span{bytes}.first(log_health_size - 1)));
  auto spoilt = bytes;
  spoilt[4] = std::byte{core::sensor_states};
  EXPECT_FALSE(unpack_health(now, spoilt));
}

}  // namespace
}  // namespace fantail::protocol
