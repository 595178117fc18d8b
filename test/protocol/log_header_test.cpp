// SPDX-License-Identifier: MIT
#include "protocol/log_header.hpp"

#include "log_bytes.hpp"
#include "protocol/log_schema.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

std::vector<std::byte> payload_of(const LogHeader& header) {
  const auto fixed = encode(header);
  std::vector<std::byte> bytes{fixed.begin(), fixed.end()};
  append(bytes, header.plan_block);
  append(bytes, std::as_bytes(std::span{header.schema}));
  return bytes;
}

TEST(LogHeader, ComesBackWithEverythingInIt) {
  const std::array<std::byte, 3> plan{std::byte{1}, std::byte{2}, std::byte{3}};
  const std::vector<std::byte> bytes = payload_of({.flight = 17,
                                                   .power_up = 4,
                                                   .state_layout = 0xABCD0123,
                                                   .rate_scale_rad_s = 0.001F,
                                                   .specific_force_scale_m_s2 = 0.002F,
                                                   .accelerometer_scale_m_s2 = 0.003F,
                                                   .firmware_version = "0.5.0",
                                                   .git_hash = "0123456789abcdef",
                                                   .vehicle = "tasha3",
                                                   .sensors = "ICM-42688-P",
                                                   .plan_block = plan,
                                                   .schema = "tick 50\n"});
  const auto header = decode_log_header(bytes);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->format_version, log_format_version);
  EXPECT_EQ(header->flight, 17U);
  EXPECT_EQ(header->power_up, 4U);
  EXPECT_EQ(header->state_layout, 0xABCD0123U);
  EXPECT_EQ(header->rate_scale_rad_s, 0.001F);
  EXPECT_EQ(header->specific_force_scale_m_s2, 0.002F);
  EXPECT_EQ(header->accelerometer_scale_m_s2, 0.003F);
  EXPECT_EQ(header->firmware_version, "0.5.0");
  EXPECT_EQ(header->git_hash, "0123456789abcdef");
  EXPECT_EQ(header->vehicle, "tasha3");
  EXPECT_EQ(header->sensors, "ICM-42688-P");
  EXPECT_TRUE(std::ranges::equal(header->plan_block, plan));
  EXPECT_EQ(header->schema, "tick 50\n");
}

// All that is not text: log_header.hpp and docs/flight_log.md say what lies where.
TEST(LogHeader, LiesThereAsItsDocumentationSays) {
  const std::array<std::byte, 0x0102> plan{};
  const LogHeader header{.flight = 0x03040506,
                         .power_up = 0x0708090A,
                         .state_layout = 0x0B0C0D0E,
                         .rate_scale_rad_s = 1.0F,
                         .specific_force_scale_m_s2 = -2.0F,
                         .accelerometer_scale_m_s2 = 0.5F,
                         .firmware_version = "abc",
                         .git_hash = "d",
                         .vehicle = "ef",
                         .sensors = "g",
                         .plan_block = plan};
  constexpr std::array<std::uint8_t, 28> numbers{0x01, 0x00, 0x02, 0x01, 0x06, 0x05, 0x04, 0x03, 0x0A, 0x09,
                                                 0x08, 0x07, 0x0E, 0x0D, 0x0C, 0x0B, 0x00, 0x00, 0x80, 0x3F,
                                                 0x00, 0x00, 0x00, 0xC0, 0x00, 0x00, 0x00, 0x3F};
  std::string expected(156, '\0');
  std::ranges::copy(numbers, expected.begin());
  expected.replace(28, 3, "abc").replace(60, 1, "d").replace(92, 2, "ef").replace(124, 1, "g");
  const auto bytes = encode(header);
  ASSERT_EQ(bytes.size(), expected.size());
  EXPECT_TRUE(std::ranges::equal(bytes, std::as_bytes(std::span{expected})));
  const std::vector<std::byte> payload = payload_of(header);
  const auto back = decode_log_header(payload);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->flight, 0x03040506U);
  EXPECT_EQ(back->power_up, 0x0708090AU);
  EXPECT_EQ(back->state_layout, 0x0B0C0D0EU);
  EXPECT_EQ(back->specific_force_scale_m_s2, -2.0F);
  EXPECT_EQ(back->accelerometer_scale_m_s2, 0.5F);
  EXPECT_EQ(back->plan_block.size(), plan.size());
}

TEST(LogHeader, OneOfWhichNothingIsSaidHasZerosBehindItsVersion) {
  const auto bytes = encode(LogHeader{});
  EXPECT_EQ(bytes[0], std::byte{1});
  EXPECT_TRUE(std::ranges::all_of(std::span{bytes}.subspan(1), [](std::byte b) { return b == std::byte{}; }));
  EXPECT_EQ(encode_second_rate_scale(LogHeader{}), (std::array<std::byte, 4>{}));
}

// Without a plan block and without a schema: nothing behind what every header has.
TEST(LogHeader, TheShortestOneIsRead) {
  const LogHeader of_two_gyros{.second_rate_scale_rad_s = 1.0F};
  EXPECT_TRUE(decode_log_header(encode(LogHeader{})));
  const auto fixed = encode(of_two_gyros);
  std::vector<std::byte> bytes{fixed.begin(), fixed.end()};
  append(bytes, encode_second_rate_scale(of_two_gyros));
  const auto back = decode_log_header(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->second_rate_scale_rad_s, 1.0F);
  EXPECT_TRUE(back->plan_block.empty() && back->schema.empty());
}

// Two bytes: 0x0102 is not 2, and who knows what stands behind such a header.
TEST(LogHeader, AVersionHasTwoBytes) {
  const std::vector<std::byte> bytes = payload_of({.format_version = 0x0102, .schema = "later"});
  const auto back = decode_log_header(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->format_version, 0x0102);
  EXPECT_FALSE(back->second_rate_scale_rad_s);
  EXPECT_EQ(back->schema, "later");
}

TEST(LogHeader, OfTwoGyrosHasASecondScaleAndAVersionOfItsOwn) {
  const std::array<std::byte, 2> plan{std::byte{1}, std::byte{2}};
  const LogHeader header{.second_rate_scale_rad_s = 0.0025F, .plan_block = plan, .schema = "tick 50\n"};
  const auto fixed = encode(header);
  const auto scale = encode_second_rate_scale(header);
  std::vector<std::byte> bytes{fixed.begin(), fixed.end()};
  append(bytes, scale);
  append(bytes, header.plan_block);
  append(bytes, std::as_bytes(std::span{header.schema}));
  const auto back = decode_log_header(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->format_version, 2);
  EXPECT_EQ(back->second_rate_scale_rad_s, 0.0025F);
  EXPECT_TRUE(std::ranges::equal(back->plan_block, plan));
  EXPECT_EQ(back->schema, "tick 50\n");
  EXPECT_FALSE(decode_log_header(std::span{bytes}.first(log_header_fixed_size + 3)));
}

TEST(LogHeader, TheSchemaOfTwoGyrosIsThatOfOneAndMore) {
  EXPECT_TRUE(log_schema_of_two_gyros().starts_with(log_schema()));
  EXPECT_TRUE(log_schema().starts_with("tick 50\n0 u16:0.3 phase\n"));
  EXPECT_TRUE(log_schema().ends_with("19 u32 bus_errors frame\n"));
  EXPECT_NE(log_schema_of_two_gyros().find("second_gyro"), std::string_view::npos);
  EXPECT_EQ(log_schema().find("second_gyro"), std::string_view::npos);
}

TEST(LogHeader, ATextThatIsTooLongIsCutOff) {
  const std::string name(100, 'x');
  const std::vector<std::byte> bytes = payload_of({.vehicle = name, .sensors = "next"});
  const auto header = decode_log_header(bytes);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->vehicle, name.substr(0, log_text_size));
  EXPECT_EQ(header->sensors, "next");
}

TEST(LogHeader, OneThatIsShorterThanItSaysIsRefused) {
  const std::array<std::byte, 3> plan{};
  const std::vector<std::byte> bytes = payload_of({.plan_block = plan});
  EXPECT_TRUE(decode_log_header(bytes));
  EXPECT_FALSE(decode_log_header(std::span{bytes}.first(bytes.size() - 1)));
  EXPECT_FALSE(decode_log_header(std::span{bytes}.first(log_header_fixed_size - 1)));
  EXPECT_FALSE(decode_log_header({}));
}

}  // namespace
}  // namespace fantail::protocol
