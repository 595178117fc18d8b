// SPDX-License-Identifier: MIT
#include "protocol/log_notes.hpp"

#include <bit>
#include <new>

#include "test.hpp"

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

// As log_schema.cpp tells readers of other versions.
TEST(LogNotes, EveryByteIsWhereTheSchemaSays) {
  const auto event =
      pack(LogEvent{.kind = LogEventKind::canard_verdict, .value = 1, .detail = 2, .index = 3, .number = 0x04050607});
  EXPECT_EQ(event, std::bit_cast<decltype(event)>(std::array<std::uint8_t, 8>{3, 1, 2, 3, 7, 6, 5, 4}));
  const auto health = pack(LogHealth{.verdicts = {core::CanardVerdict::dead, core::CanardVerdict::stalled,
                                                  core::CanardVerdict::slipping, core::CanardVerdict::disagreeing},
                                     .gyro = core::SensorState::coasting,
                                     .accelerometer = core::SensorState::lost,
                                     .bus_state = 5,
                                     .longest_tick_us = 0x0607,
                                     .longest_queue = 0x0809,
                                     .ticks_dropped = 0x0A0B0C0D,
                                     .unsent = 0x0E0F1011,
                                     .bus_errors = 0x12131415});
  EXPECT_EQ(health, std::bit_cast<decltype(health)>(std::array<std::uint8_t, 23>{
                        1,    2,    3,    4,    1,    2,    5,    0x07, 0x06, 0x09, 0x08, 0x0D,
                        0x0C, 0x0B, 0x0A, 0x11, 0x10, 0x0F, 0x0E, 0x15, 0x14, 0x13, 0x12}));
}

// As log_notes.hpp says it: two times of 8 bytes each, then the state.
TEST(LogNotes, TheStateOfACheckpointLiesBehindTwoTimes) { EXPECT_EQ(log_checkpoint_times_size, 2U * 8U); }

TEST(LogNotes, AHealthRecordLeavesWhatLiesBehindItAlone) {
  std::array<std::byte, 24> room{};
  room.fill(std::byte{0x5A});
  new (room.data()) std::array<std::byte, 23>(pack(LogHealth{}));  // made where it lies
  EXPECT_EQ(room.back(), std::byte{0x5A});
}

TEST(LogNotes, OneOfWhichNothingIsSaidHasNoNumbers) {
  EXPECT_EQ(pack(LogEvent{}), (std::array<std::byte, 8>{}));
  const auto health = pack(LogHealth{});
  EXPECT_EQ(health[4], std::byte{3});  // of a sensor that nobody has heard of: failed
  EXPECT_EQ(health[5], std::byte{3});
  EXPECT_TRUE(std::ranges::all_of(std::span{health}.subspan(6), [](std::byte b) { return b == std::byte{}; }));
}

TEST(LogEvent, OneOfWhichThisVersionKnowsNothingIsRefused) {
  const auto accepts = [](std::uint8_t kind, std::uint8_t value, std::uint8_t detail, std::uint8_t index) {
    const LogEvent event{.kind = static_cast<LogEventKind>(kind), .value = value, .detail = detail, .index = index};
    return unpack_event(now, pack(event)).has_value();
  };
  const auto number = [](LogEventKind kind) { return static_cast<std::uint8_t>(kind); };
  EXPECT_FALSE(accepts(log_event_kinds, 0, 0, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::phase), 5, 22, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::phase), 6, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::phase), 0, 23, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::canard_verdict), 4, 0, 3));
  EXPECT_FALSE(accepts(number(LogEventKind::canard_verdict), 4, 0, 4));
  EXPECT_TRUE(accepts(number(LogEventKind::recording_ended), 3, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::recording_ended), 4, 0, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::recording_began), 1, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::recording_began), 2, 0, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::resumed), 1, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::resumed), 2, 0, 0));
  for (const LogEventKind kind : {LogEventKind::gyro_state, LogEventKind::accelerometer_state}) {
    EXPECT_TRUE(accepts(number(kind), core::sensor_states - 1, 0, 0));
    EXPECT_FALSE(accepts(number(kind), core::sensor_states, 0, 0));
  }
  EXPECT_TRUE(accepts(number(LogEventKind::command_status), core::command_statuses - 1, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::command_status), core::command_statuses, 0, 0));
  EXPECT_TRUE(accepts(number(LogEventKind::gyro_vote), core::gyro_votes - 1, 0, 0));
  EXPECT_FALSE(accepts(number(LogEventKind::gyro_vote), core::gyro_votes, 0, 0));
  for (const LogEventKind kind :
       {LogEventKind::records_dropped, LogEventKind::longest_tick, LogEventKind::board_faults}) {
    EXPECT_TRUE(accepts(number(kind), 0, 0, 0));
    EXPECT_FALSE(accepts(number(kind), 1, 0, 0));
    EXPECT_FALSE(accepts(number(kind), 0, 1, 0));
    EXPECT_FALSE(accepts(number(kind), 0, 0, 1));
  }
}

TEST(LogEvent, OneOfAnotherSizeIsRefused) {
  const auto bytes = pack(LogEvent{});
  EXPECT_TRUE(unpack_event(now, bytes));
  EXPECT_FALSE(unpack_event(now, std::span{bytes}.first(log_event_size - 1)));
}

TEST(LogEvent, EachDifferenceMakesItAnother) {
  const LogEvent event{.time = now, .value = 1, .detail = 2, .index = 3, .number = 4};
  const auto differs = [&](auto change) {
    LogEvent other = event;
    change(other);
    return !(other == event);
  };
  EXPECT_FALSE(differs([](LogEvent&) {}));
  EXPECT_TRUE(differs([](LogEvent& e) { e.time += core::Microseconds{1}; }));
  EXPECT_TRUE(differs([](LogEvent& e) { e.kind = LogEventKind::phase; }));
  EXPECT_TRUE(differs([](LogEvent& e) { e.value = 0; }));
  EXPECT_TRUE(differs([](LogEvent& e) { e.detail = 0; }));
  EXPECT_TRUE(differs([](LogEvent& e) { e.index = 0; }));
  EXPECT_TRUE(differs([](LogEvent& e) { e.number = 0; }));
}

// Walks an enumeration from its first value until its names end; every name must be new.
template <typename Enumeration>
std::size_t distinct_names() {
  std::set<std::string_view> names;
  for (std::uint8_t value = 0; name(static_cast<Enumeration>(value)) != "unknown"; ++value) {
    EXPECT_FALSE(name(static_cast<Enumeration>(value)).empty());
    if (!names.insert(name(static_cast<Enumeration>(value))).second) {
      ADD_FAILURE() << "twice: " << name(static_cast<Enumeration>(value));
      break;
    }
  }
  return names.size();
}

TEST(LogNotes, EveryValueOfAnEnumerationHasANameOfItsOwn) {
  EXPECT_EQ(distinct_names<LogEventKind>(), log_event_kinds);
  EXPECT_EQ(distinct_names<LogBegin>(), log_begins);
  EXPECT_EQ(distinct_names<LogEnd>(), log_ends);
  EXPECT_EQ(distinct_names<ResumedAfter>(), resumed_after_causes);
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
  const auto accepts = [&](std::size_t at, std::size_t value) {
    auto other = bytes;
    other[at] = static_cast<std::byte>(value);
    return unpack_health(now, other).has_value();
  };
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    EXPECT_TRUE(accepts(i, core::canard_verdicts - 1));
    EXPECT_FALSE(accepts(i, core::canard_verdicts));
  }
  for (const std::size_t state : {4U, 5U}) {
    EXPECT_TRUE(accepts(state, core::sensor_states - 1));
    EXPECT_FALSE(accepts(state, core::sensor_states));
  }
}

}  // namespace
}  // namespace fantail::protocol
