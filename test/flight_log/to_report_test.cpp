// SPDX-License-Identifier: MIT

#include "flight_log/to_report.hpp"

#include "flight/write_csv.hpp"
#include "flight_log/event_text.hpp"
#include "flight_log/flight_figures.hpp"
#include "flight_log/made_flight.hpp"
#include "flight_log/schema.hpp"
#include "hal/board.hpp"
#include "test.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;

struct Read {
  MadeFlight made = make_flight();
  Flight flight = parse_log(made.bytes, "").flights.at(0);
  Regeneration regeneration = regenerate(flight, *flight.plan);
};

// Flown from 5.5 s on, thrust from 6 s on: the tick at 6.000 s has the first sample with thrust, which the replayed
// window includes.
constexpr double pad_s = 0.5;

TEST(ToReport, HasARowForEveryTickWithTimeZeroAtTheStartOfTheReplayedWindow) {
  const Read read;
  const flight::Flight flight = to_report(read.flight, read.regeneration);
  ASSERT_EQ(flight.rows.size(), 3000U);
  EXPECT_NEAR(flight.rows.front().time_s, -pad_s, 0.005);
  EXPECT_NEAR(flight.rows[1].time_s - flight.rows[0].time_s, 0.001, 1e-9);
  EXPECT_EQ(flight.events.liftoff_s, 0.0);
  EXPECT_FALSE(flight.tunnel);
  for (std::size_t i = 0; i < flight.rows.size(); ++i) {
    ASSERT_EQ(flight.rows[i].roll_angle_rad, static_cast<double>(read.made.records[i].motion.roll_angle.radians()));
    ASSERT_FALSE(flight.rows[i].truth.has_value());
  }
}

// As log info calls it, and not after its place in the flash.
TEST(ToReport, IsCalledByItsNumberInTheFile) {
  MadeFlight two = make_flight();
  const MadeFlight second = make_flight({.flight = 0x40000});
  two.bytes.insert(two.bytes.end(), second.bytes.begin(), second.bytes.end());
  const LogFile file = parse_log(two.bytes, "");
  ASSERT_EQ(file.flights.size(), 2U);
  const Flight& flight = file.flights[1];
  EXPECT_EQ(flight.flight, 0x40000U);
  EXPECT_TRUE(to_report(flight, regenerate(flight, *flight.plan)).scenario.starts_with("flight 2, power-up"));
}

TEST(ToReport, KnowsWhoFlewWhat) {
  const Read read;
  const flight::Flight flight = to_report(read.flight, read.regeneration);
  EXPECT_EQ(flight.vehicle, "paper dart");
  EXPECT_EQ(flight.version, "0.1.0");
  EXPECT_NE(flight.plan_name.find("plan "), std::string::npos) << "the default plan is not one of the shipped ones";
  EXPECT_TRUE(flight.notes.empty());
}

TEST(ToReport, CountsTheTicksOfWhichTheReplayGivesSomethingElse) {
  Read read;
  EXPECT_EQ(to_report(read.flight, read.regeneration).differing_ticks, 0U);
  read.flight.ticks[1000].tick.canard_commands[2] = core::Angle::from_degrees(1.234F);
  read.regeneration = regenerate(read.flight, *read.flight.plan);
  EXPECT_EQ(to_report(read.flight, read.regeneration).differing_ticks, 1U);
}

// 1 % of what was felt, h + g t^2 / 2, and 0.06 g over the time; next to nothing is across.
TEST(ToReport, HasTheErrorOfAHeightByAnAccelerometer) {
  const Read read;
  const flight::Row row = to_report(read.flight, read.regeneration).rows.back();
  const double fallen_m = 0.5 * 9.80665 * row.time_s * row.time_s;
  EXPECT_NEAR(row.height_error_m.value(), 0.01 * (row.height_m + fallen_m) + 0.06 * fallen_m, 0.1);
}

TEST(ToReport, HasThePhasesWithTheirReasonsAndTheEvents) {
  const Read read;
  const flight::Flight flight = to_report(read.flight, read.regeneration);
  ASSERT_GE(flight.phase_changes.size(), 3U);
  EXPECT_EQ(flight.phase_changes[0].phase, core::Phase::armed);
  EXPECT_EQ(flight.phase_changes[1].reason, core::PhaseReason::launch_detected);
  EXPECT_EQ(flight.phase_changes[2].reason, core::PhaseReason::guide_clear);
  EXPECT_EQ(flight.events.detected_s, flight.phase_changes[1].time_s);
  EXPECT_EQ(flight.events.control_start_s, flight.phase_changes[2].time_s);
  EXPECT_FALSE(flight.events.control_end_s.has_value());
}

TEST(ToReport, AfterAGapTheBeginOfAPhaseIsWhatTheRecorderNotedOrUnknown) {
  const Read read;
  Flight flight = read.flight;
  // Nothing is left of the half second in which it was detected and control began.
  flight.checkpoints.erase(flight.checkpoints.begin(), flight.checkpoints.begin() + 3);
  const Regeneration regeneration = regenerate(flight, *flight.plan);
  const auto begins = to_report(read.flight, read.regeneration).events;
  const auto noted = to_report(flight, regeneration);
  const double moved_s = *begins.liftoff_s - *noted.events.liftoff_s;
  EXPECT_NEAR(*noted.events.control_start_s + moved_s, *begins.control_start_s, 1e-6);
  EXPECT_FALSE(noted.notes.empty());

  flight.events.clear();
  EXPECT_FALSE(to_report(flight, regeneration).events.control_start_s.has_value());
}

TEST(ToReport, AFlightThatCannotBeReplayedHasNoRowsAndSaysWhy) {
  const Read read;
  Flight flight = read.flight;
  flight.checkpoints.clear();
  const flight::Flight result = to_report(flight, regenerate(flight, *flight.plan));
  EXPECT_TRUE(result.rows.empty());
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_NE(result.notes[0].find("no checkpoint"), std::string::npos);
}

std::string of_board(std::uint32_t bits) {
  return event_text({.kind = protocol::LogEventKind::board_faults, .number = bits}, {});
}

// The recorder says the phase of its first tick, which may be minutes old.
TEST(EventText, APhaseThatTheFirstTickShowsBeganBeforeTheLog) {
  protocol::LogEvent event{.time = core::Microseconds{5000},
                           .kind = protocol::LogEventKind::phase,
                           .value = static_cast<std::uint8_t>(core::Phase::armed),
                           .detail = static_cast<std::uint8_t>(core::PhaseReason::armed_by_switch_and_command)};
  EXPECT_EQ(event_text(event, core::Microseconds{5000}),
            "Armed: already when the log begins (armed by switch and command)");
  EXPECT_EQ(event_text(event, core::Microseconds{4000}), "Armed: armed by switch and command");
}

TEST(EventText, NamesEveryFaultOfTheBoard) {
  constexpr std::uint32_t low = 1U << static_cast<unsigned>(hal::BoardFault::supply_low);
  EXPECT_EQ(of_board(low), "board: supply_low");
  EXPECT_EQ(of_board(1U << 3U | low), "board: imu_silent, supply_low");
  EXPECT_EQ(of_board(0), "board: no fault");
}

TEST(EventText, AFaultOfANewerBoardIsNotPassedOver) {
  EXPECT_EQ(of_board(0x8000'0000), "board: unknown 0x80000000");
  EXPECT_EQ(of_board(0x8000'0001), "board: crystal_failed, unknown 0x80000000");
}

using core::Microseconds;

Flight with_durations(const std::vector<int>& durations_us) {
  Flight flight;
  for (std::size_t i = 0; i < durations_us.size(); ++i) {
    flight.ticks.push_back({.sequence = static_cast<std::uint32_t>(i),
                            .tick = {.time = Microseconds{1'000} * static_cast<std::int64_t>(i),
                                     .duration_before = Microseconds{durations_us[i]}}});
  }
  return flight;
}

TEST(LoopTimes, MeanNinetyNinthPercentileAndLongest) {
  std::vector<int> durations(198, 100);
  durations.push_back(400);
  durations.push_back(1'000);
  const auto times = loop_times(with_durations(durations));
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->ticks, 200U);
  EXPECT_DOUBLE_EQ(times->mean_us, (198 * 100 + 400 + 1'000) / 200.0);
  EXPECT_EQ(times->p99_us, 100.0) << "198 of 200 are 99 %";
  EXPECT_EQ(times->longest_us, 1'000.0);
  EXPECT_EQ(times->late, 1U) << "a whole millisecond is too long";
  EXPECT_EQ(times->longest_step_us, 1'000.0);
}

TEST(LoopTimes, OneTickIsItsOwnPercentile) {
  const auto times = loop_times(with_durations({70}));
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->p99_us, 70.0);
  EXPECT_EQ(times->longest_step_us, 0.0);
}

TEST(LoopTimes, AStepOverLostRecordsIsNoLateTick) {
  Flight flight = with_durations({100, 100, 100, 100});
  flight.ticks[2].sequence += 5;
  flight.ticks[3].sequence += 5;
  flight.ticks[2].tick.time += Microseconds{5'000};
  flight.ticks[3].tick.time += Microseconds{6'200};
  flight.gaps.push_back({.first_missing = 2, .count = 5});
  EXPECT_EQ(loop_times(flight)->longest_step_us, 2'200.0);
}

TEST(LoopTimes, NoTickHasNone) { EXPECT_FALSE(loop_times(Flight{}).has_value()); }

constexpr std::array bytes{std::byte{0xFE}, std::byte{0xFF}, std::byte{0x34}, std::byte{0x12},
                           std::byte{0x00}, std::byte{0x00}, std::byte{0x20}, std::byte{0x41}};

std::optional<double> read(const std::string& type_at) {
  const auto schema = parse_schema("tick 8\n" + type_at + " x\n");
  const SchemaField* field = find_record(schema, "tick")->find("x");
  return field == nullptr ? std::nullopt : value(*field, bytes);
}

TEST(Schema, EveryTypeIsReadWhereItLies) {
  EXPECT_EQ(read("0 u8"), 254.0);
  EXPECT_EQ(read("0 i8"), -2.0);
  EXPECT_EQ(read("0 i16"), -2.0);
  EXPECT_EQ(read("0 u16"), 65534.0);
  EXPECT_EQ(read("2 u16"), 4660.0);
  EXPECT_EQ(read("0 u32"), 305463294.0);  // 0x1234FFFE
  EXPECT_EQ(read("4 f32"), 10.0);
  EXPECT_EQ(read("0 i32"), 305463294.0);
}

TEST(Schema, BitsAreCutOut) {
  EXPECT_EQ(read("2 u16:0.4"), 4.0);
  EXPECT_EQ(read("2 u16:4.4"), 3.0);
  EXPECT_EQ(read("2 u16:12.4"), 1.0);
  EXPECT_EQ(read("0 u8:0.8"), 254.0);
}

TEST(Schema, ALineThatCannotBeUnderstoodIsLeftOutAndTheOthersStay) {
  for (const char* line : {"0 u128", "0 u16:15.2", "0 u16:16.1", "0 u16:1.0", "0 i16:1.2", "0 u16:1", "8 u8", "7 u16",
                           "18446744073709551615 u8", "0 f16", "0"}) {
    const auto schema = parse_schema(std::string{"tick 8\n"} + line + " x unit\n1 u8 y furlong\n");
    ASSERT_EQ(schema.size(), 1U) << line;
    EXPECT_EQ(schema[0].find("x"), nullptr) << line;
    ASSERT_NE(schema[0].find("y"), nullptr) << line;
    EXPECT_EQ(schema[0].find("y")->unit, "furlong");
  }
}

TEST(Schema, ARecordWhoseSizeCannotBeReadIsLeftOutWithItsLines) {
  const auto schema = parse_schema("tick many\n0 u8 a\nevent 2\n1 u8 b\n");
  ASSERT_EQ(schema.size(), 1U);
  EXPECT_EQ(schema[0].name, "event");
  EXPECT_EQ(find_record(schema, "tick"), nullptr);
}

TEST(Schema, AShortPayloadHasNoValue) {
  const auto schema = parse_schema("tick 8\n6 u16 x\n");
  EXPECT_EQ(value(schema[0].fields[0], std::span{bytes}.first(7)), std::nullopt);
}

TEST(Schema, AnyTextIsASchemaOfSomeRecords) {
  EXPECT_TRUE(parse_schema("").empty());
  EXPECT_TRUE(parse_schema("0 u8 field_before_any_record\n").empty());
  EXPECT_TRUE(parse_schema("\n\n\n").empty());
}

}  // namespace

}  // namespace fantail::flight_log
