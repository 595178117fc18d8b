// SPDX-License-Identifier: MIT
#include "protocol/log_header.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "log_bytes.hpp"
#include "protocol/log_schema.hpp"

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
