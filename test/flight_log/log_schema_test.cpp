// SPDX-License-Identifier: MIT
// The schema that goes into every header, against what is written.
#include "protocol/log_schema.hpp"

#include "flight_log/schema.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/log_tick.hpp"
#include "test.hpp"

namespace fantail::flight_log {
namespace {

using core::Microseconds;
using protocol::DeviceStatus;
using Values = std::map<std::string, double>;

// Every value by its name, as a reader sees it who knows the schema and nothing else.
Values values(const std::string& record, std::span<const std::byte> payload) {
  const auto schema = parse_schema(protocol::log_schema());
  const SchemaRecord* found = find_record(schema, record);
  Values result;
  if (found == nullptr || found->size != payload.size()) {
    ADD_FAILURE() << record << " is not of the size that the schema says";
    return result;
  }
  for (const SchemaField& field : found->fields) {
    EXPECT_TRUE(result.emplace(field.name, value(field, payload).value_or(-1e9)).second) << field.name << " twice";
  }
  return result;
}

// How often the fields of a record claim each of its bits.
std::vector<int> claims(const SchemaRecord& record) {
  std::vector<int> bits(8 * record.size);
  for (const SchemaField& field : record.fields) {
    const std::size_t first = 8 * field.offset + field.first_bit;
    const std::size_t count = field.bits == 0 ? 8 * field.bytes : field.bits;
    for (std::size_t i = first; i < first + count; ++i) {
      bits[i] += 1;
    }
  }
  return bits;
}

TEST(LogSchema, EveryLineIsUnderstood) {
  const std::string_view text = protocol::log_schema_of_two_gyros();
  std::size_t fields = 0;
  const auto schema = parse_schema(text);
  for (const SchemaRecord& record : schema) {
    fields += record.fields.size();
  }
  EXPECT_EQ(schema.size() + fields, static_cast<std::size_t>(std::ranges::count(text, '\n')));
}

TEST(LogSchema, NoTwoFieldsShareABitAndOnlyOneBitIsSpare) {
  const auto schema = parse_schema(protocol::log_schema_of_two_gyros());
  for (const SchemaRecord& record : schema) {
    const auto bits = claims(record);
    EXPECT_EQ(std::ranges::count_if(bits, [](int n) { return n > 1; }), 0) << record.name;
    EXPECT_EQ(std::ranges::count(bits, 0), record.name == "tick" ? 1 : 0) << record.name;
  }
}

TEST(LogSchema, OfOneGyroIsThatOfTwoWithoutTheRecordOfTheSecond) {
  const std::string_view two = protocol::log_schema_of_two_gyros();
  EXPECT_EQ(two.find(protocol::log_schema()), 0U);
  EXPECT_EQ(two.substr(protocol::log_schema().size()).find("second_gyro 9\n"), 0U);
}

TEST(LogSchema, FindsEveryValueOfASecondGyroBehindTheTick) {
  const protocol::LogTick tick{
      .time = Microseconds{1'000'000},
      .second_gyro = protocol::LogSecondGyro{
          .time = Microseconds{1'000'000 - 333}, .rate_counts = {-7, 8, -9}, .status = DeviceStatus::error}};
  protocol::SampleTimes times;
  std::array<std::byte, protocol::log_tick_size_with(true, false)> bytes{};
  protocol::pack(tick, times, bytes);
  const auto schema = parse_schema(protocol::log_schema_of_two_gyros());
  const SchemaRecord* record = find_record(schema, "second_gyro");
  ASSERT_NE(record, nullptr);
  const auto behind = std::span{bytes}.subspan(protocol::log_tick_size);
  ASSERT_EQ(record->size, behind.size());
  const std::map<std::string, double> expected{
      {"age", 333}, {"rate_x", -7}, {"rate_y", 8}, {"rate_z", -9}, {"status", 1}};
  for (const auto& [name, number] : expected) {
    EXPECT_EQ(value(*record->find(name), behind), number) << name;
  }
}

TEST(LogSchema, FindsThePressureBehindATick) {
  const protocol::LogTick tick{.time = Microseconds{1'000'000},
                               .pressure = protocol::LogPressure{.time = Microseconds{995'001}, .pressure_pa = 89'875}};
  protocol::SampleTimes times;
  std::array<std::byte, protocol::log_tick_size_with(false, true)> bytes{};
  protocol::pack(tick, times, bytes);
  const auto schema =
      parse_schema(std::string{protocol::log_schema()} + std::string{protocol::log_schema_of_barometer()});
  const SchemaRecord* record = find_record(schema, "barometer");
  ASSERT_NE(record, nullptr);
  const auto behind = std::span{bytes}.subspan(protocol::log_tick_size);
  ASSERT_EQ(record->size, behind.size());
  EXPECT_EQ(value(*record->find("age"), behind), 4'999.0);
  EXPECT_EQ(value(*record->find("pressure"), behind), 89'875.0);
}

TEST(LogSchema, FindsEveryValueOfATick) {
  // Each value is one that no other has.
  const protocol::LogTick tick{
      .time = Microseconds{1'000'000},
      .imu_time = Microseconds{1'000'000 - 151},
      .rate_counts = {-101, 102, -103},
      .specific_force_counts = {1104, -1105, 1106},
      .imu_status = DeviceStatus::error,
      .accelerometer_time = Microseconds{1'000'000 - 2052},
      .accelerometer_counts = {-2107, 2108, -2109},
      .accelerometer_status = DeviceStatus::no_reading,
      .encoder_counts = {16001, 16002, 16003, 16004},
      .encoder_status = {DeviceStatus::ok, DeviceStatus::error, DeviceStatus::no_reading, DeviceStatus::error},
      .phase = core::Phase::controlling,
      .command_status = core::CommandStatus::not_finite,
      .command = core::Angle::from_radians(-0.125F),
      .canard_commands = {core::Angle::from_degrees(5.001F), core::Angle::from_degrees(-6.002F), std::nullopt,
                          core::Angle::from_degrees(8.004F)},
      .duration_before = Microseconds{321},
      .digest = 0x89ABCDEF};
  protocol::SampleTimes times;
  const Values expected{{"phase", 3},
                        {"command_status", 3},
                        {"imu_status", 1},
                        {"accelerometer_status", 2},
                        {"imu_age", 151},
                        {"accelerometer_age", 2052},
                        {"rate_x", -101},
                        {"rate_y", 102},
                        {"rate_z", -103},
                        {"specific_force_x", 1104},
                        {"specific_force_y", -1105},
                        {"specific_force_z", 1106},
                        {"accelerometer_x", -2107},
                        {"accelerometer_y", 2108},
                        {"accelerometer_z", -2109},
                        {"encoder_1", 16001},
                        {"encoder_2", 16002},
                        {"encoder_3", 16003},
                        {"encoder_4", 16004},
                        {"encoder_1_status", 0},
                        {"encoder_2_status", 1},
                        {"encoder_3_status", 2},
                        {"encoder_4_status", 1},
                        {"command", -0.125},
                        {"command_1", 5001},
                        {"command_2", -6002},
                        {"command_3", -32768},
                        {"command_4", 8004},
                        {"duration_before", 321},
                        {"digest", 2309737967.0},
                        {"arm_switch_closed", 0},
                        {"arm_command", 0},
                        {"start_command", 0},
                        {"saturated", 0},
                        {"timing_fault", 0},
                        {"abort", 0}};
  EXPECT_EQ(values("tick", protocol::pack(tick, times)), expected);
}

TEST(LogSchema, FindsEveryFlagOfATickByItself) {
  const std::map<std::string, bool protocol::LogTick::*> flags{
      {"arm_switch_closed", &protocol::LogTick::arm_switch_closed}, {"arm_command", &protocol::LogTick::arm_command},
      {"start_command", &protocol::LogTick::start_command},         {"saturated", &protocol::LogTick::saturated},
      {"timing_fault", &protocol::LogTick::timing_fault},           {"abort", &protocol::LogTick::abort}};
  protocol::SampleTimes times;
  const Values plain = values("tick", protocol::pack(protocol::LogTick{}, times));
  for (const auto& [name, member] : flags) {
    protocol::LogTick tick;
    tick.*member = true;
    Values expected = plain;
    expected[name] = 1;
    EXPECT_EQ(values("tick", protocol::pack(tick, times)), expected) << name;
  }
}

TEST(LogSchema, FindsEveryValueOfAnEvent) {
  const protocol::LogEvent event{
      .kind = protocol::LogEventKind::canard_verdict, .value = 4, .detail = 9, .index = 2, .number = 0x01020304};
  EXPECT_EQ(values("event", protocol::pack(event)),
            (Values{{"kind", 3}, {"value", 4}, {"detail", 9}, {"index", 2}, {"number", 16909060.0}}));
}

TEST(LogSchema, FindsEveryValueOfAHealthRecord) {
  const protocol::LogHealth health{.verdicts = {core::CanardVerdict::dead, core::CanardVerdict::stalled,
                                                core::CanardVerdict::slipping, core::CanardVerdict::disagreeing},
                                   .gyro = core::SensorState::lost,
                                   .accelerometer = core::SensorState::coasting,
                                   .bus_state = 7,
                                   .longest_tick_us = 1001,
                                   .longest_queue = 1002,
                                   .ticks_dropped = 100003,
                                   .unsent = 100004,
                                   .bus_errors = 100005};
  EXPECT_EQ(values("health", protocol::pack(health)), (Values{{"verdict_1", 1},
                                                              {"verdict_2", 2},
                                                              {"verdict_3", 3},
                                                              {"verdict_4", 4},
                                                              {"gyro_state", 2},
                                                              {"accelerometer_state", 1},
                                                              {"bus_state", 7},
                                                              {"longest_tick", 1001},
                                                              {"longest_queue", 1002},
                                                              {"ticks_dropped", 100003},
                                                              {"unsent", 100004},
                                                              {"bus_errors", 100005}}));
}

}  // namespace
}  // namespace fantail::flight_log
