// SPDX-License-Identifier: MIT
#include "flight_log/schema.hpp"

#include <array>

#include <gtest/gtest.h>

namespace fantail::flight_log {
namespace {

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
