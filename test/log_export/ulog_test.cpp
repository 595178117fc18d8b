// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "log_export/formats.hpp"
#include "made_flight.hpp"

namespace fantail::log_export {
namespace {

template <typename T>
T number(std::string_view bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.substr(at, sizeof value).data(), sizeof value);
  return value;
}

struct Message {
  char type;
  std::string content;
};

std::vector<Message> messages(const std::string& file) {
  std::vector<Message> all;
  for (std::size_t at = 16; at < file.size();) {
    const auto size = number<std::uint16_t>(file, at);
    all.push_back({file.at(at + 2), file.substr(at + 3, size)});
    EXPECT_EQ(all.back().content.size(), size) << "the file ends within a message";
    at += 3U + size;
  }
  return all;
}

std::size_t count(const std::vector<Message>& all, char type) {
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [type](const Message& m) { return m.type == type; }));
}

std::size_t data_of(const std::vector<Message>& all, std::uint16_t topic) {
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [topic](const Message& m) {
    return m.type == 'D' && number<std::uint16_t>(m.content, 0) == topic;
  }));
}

TEST(UlogExport, BeginsWithTheMagicOfVersionOneTheFirstTickAndTheFlags) {
  const MadeFlight made;
  const std::string file = ulog(made.source(), every_field(made.source()));
  EXPECT_EQ(file.substr(0, 8), std::string("ULog\x01\x12\x35\x01"));
  EXPECT_EQ(number<std::uint64_t>(file, 8), 10'000'000U);
  EXPECT_EQ(messages(file).front().type, 'B');
  EXPECT_EQ(messages(file).front().content, std::string(40, '\0'));
}

TEST(UlogExport, HasATickOfTheLogForEachAndAReplayedOneWhereTheReplayCame) {
  const MadeFlight made;
  const auto all = messages(ulog(made.source(), every_field(made.source())));
  EXPECT_EQ(count(all, 'A'), 3U);
  EXPECT_EQ(data_of(all, 0), 950U);
  EXPECT_EQ(data_of(all, 1), 940U);
  EXPECT_EQ(data_of(all, 2), 3U);
}

TEST(UlogExport, EventsAreTextsAndTheGapADropoutOfItsLength) {
  const MadeFlight made;
  const auto all = messages(ulog(made.source(), every_field(made.source())));
  std::vector<std::string> texts;
  for (const Message& message : all) {
    if (message.type == 'L') {
      texts.push_back(message.content.substr(0, 1) + message.content.substr(9));
    } else if (message.type == 'O') {
      EXPECT_EQ(number<std::uint16_t>(message.content, 0), 51U);  // ms from the tick before it to the one behind it
    }
  }
  EXPECT_EQ(texts, (std::vector<std::string>{"6Launched: launch detected", "4canard 3 stalled"}));
  EXPECT_EQ(count(all, 'O'), 1U);
}

TEST(UlogExport, OnlyTheChosenFieldsAreThere) {
  const MadeFlight made;
  const auto all = messages(ulog(made.source(), {*find_field("rate_x_count"), *find_field("roll_angle_deg")}));
  std::vector<std::string> formats;
  for (const Message& message : all) {
    if (message.type == 'F') {
      formats.push_back(message.content);
    }
  }
  ASSERT_EQ(formats.size(), 3U);
  EXPECT_EQ(formats[0], "fantail_recorded:uint64_t timestamp;int32_t rate_x_count;");
  EXPECT_EQ(formats[1], "fantail_replayed:uint64_t timestamp;float roll_angle_deg;");
}

}  // namespace
}  // namespace fantail::log_export
