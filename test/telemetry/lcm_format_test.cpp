// SPDX-License-Identifier: MIT
#include "telemetry/lcm_format.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace fantail::telemetry {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span{text}); }

std::string text_of(std::span<const std::byte> bytes) {
  std::string text;
  std::ranges::transform(bytes, std::back_inserter(text), [](std::byte byte) { return static_cast<char>(byte); });
  return text;
}

// By LCM's own description of its UDP format: magic number, number of the message, channel with a zero behind it,
// message.
std::string short_message(const std::string& channel, const std::string& content) {
  return "LC02" + std::string{"\0\0\0\7", 4} + channel + '\0' + content;
}

TEST(LcmDatagram, OfAShortMessageIsItsChannelAndItsBytes) {
  const std::string datagram = short_message("FANTAIL_STATE", {"a\0b", 3});
  const auto message = read_datagram(bytes_of(datagram));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->channel, "FANTAIL_STATE");
  EXPECT_EQ(text_of(message->bytes), std::string("a\0b", 3));
  const std::string empty = short_message("X", "");
  ASSERT_TRUE(read_datagram(bytes_of(empty)));
  EXPECT_TRUE(read_datagram(bytes_of(empty))->bytes.empty());
}

TEST(LcmDatagram, OfAFragmentOrOfAnythingElseIsNone) {
  const std::string sound = short_message("FANTAIL_STATE", "abc");
  std::string fragment = sound;
  fragment[3] = '3';
  EXPECT_FALSE(read_datagram(bytes_of(fragment)));
  EXPECT_FALSE(read_datagram(bytes_of("")));
  EXPECT_FALSE(read_datagram(bytes_of("LC02")));
  EXPECT_FALSE(read_datagram(bytes_of("GET / HTTP/1.1\r\n\r\n")));
  EXPECT_FALSE(read_datagram(bytes_of("LC02" + std::string(8, 'x')))) << "a channel without an end";
  EXPECT_TRUE(read_datagram(bytes_of(short_message(std::string(63, 'c'), ""))));
  EXPECT_FALSE(read_datagram(bytes_of(short_message(std::string(64, 'c'), ""))));
  EXPECT_FALSE(read_datagram(bytes_of(short_message("FANTAIL_STATE", std::string(longest_datagram, 'x')))));
  for (std::size_t size = 0; size < sound.size(); ++size) {
    const std::string cut = sound.substr(0, size);
    const auto message = read_datagram(bytes_of(cut));
    EXPECT_EQ(message.has_value(), size >= sound.size() - 3) << size;
  }
}

std::string be(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) {
    text += static_cast<char>(value >> static_cast<unsigned>(8 * i));
  }
  return text;
}

std::string event(std::uint64_t time_us, const std::string& channel, const std::string& content) {
  return "\xED\xA1\xDA\x01" + be(0, 8) + be(time_us, 8) + be(channel.size(), 4) + be(content.size(), 4) + channel +
         content;
}

/// What a log of these bytes has, a line an event; a few bytes come at a time, as from a pipe.
std::string read_log(const std::string& bytes, std::size_t at_a_time, std::uint64_t* foreign = nullptr) {
  std::size_t used = 0;
  LcmLog log{[&](std::span<char> to) {
    const std::size_t count = std::min({at_a_time, to.size(), bytes.size() - used});
    std::copy_n(bytes.data() + used, count, to.data());
    used += count;
    return count;
  }};
  std::string all;
  while (const auto next = log.next()) {
    all += std::to_string(next->time_us) + ' ' + next->channel + ' ' + text_of(next->bytes) + '\n';
  }
  if (foreign != nullptr) {
    *foreign = log.foreign_bytes();
  }
  return all;
}

TEST(LcmLog, HasItsEventsInTheirOrderHoweverItComes) {
  const std::string log = event(7, "FANTAIL_STATE", "abc") + event(9, "CAMERA", std::string(200'000, '\xED')) +
                          event(8, "FANTAIL_EVENT", "d");
  for (const std::size_t at_a_time : {std::size_t{1}, std::size_t{7}, log.size()}) {
    EXPECT_EQ(read_log(log, at_a_time), "7 FANTAIL_STATE abc\n9 CAMERA \n8 FANTAIL_EVENT d\n");
  }
}

TEST(LcmLog, CountsTheBytesThatBelongToNoWholeEvent) {
  const std::string one = event(1, "FANTAIL_STATE", "a") + event(2, "CAMERA", std::string(500, 'c'));
  const std::string two = event(2, "FANTAIL_STATE", "b");
  std::uint64_t foreign = 0;
  for (std::size_t size = 0; size < two.size(); ++size) {
    (void)read_log(one + two.substr(0, size), 5, &foreign);
    EXPECT_EQ(foreign, size);
  }
  (void)read_log(one + "dust\xED\xA1" + two, 5, &foreign);
  EXPECT_EQ(foreign, 6U);
  (void)read_log(one.substr(0, one.size() - 1), 5, &foreign);
  EXPECT_EQ(foreign, 28U + 6 + 499) << "on a channel of somebody else";
}

TEST(LcmLog, PassesOverWhatIsDamagedAndEndsWhereItIsCutOff) {
  const std::string one = event(1, "FANTAIL_STATE", "a");
  const std::string two = event(2, "FANTAIL_STATE", "b");
  const std::string both = "1 FANTAIL_STATE a\n2 FANTAIL_STATE b\n";
  EXPECT_EQ(read_log(one + "dust\xED\xA1" + two, 5), both);
  // Sizes that nobody has: no channel, one of 1000 characters, a message of ours of 2 GB.
  const std::string sync = "\xED\xA1\xDA\x01";
  EXPECT_EQ(read_log(one + sync + be(0, 16) + be(0, 4) + be(4, 4) + two, 5), both);
  EXPECT_EQ(read_log(one + sync + be(0, 16) + be(1'000, 4) + be(4, 4) + two, 5), both);
  EXPECT_EQ(read_log(one + sync + be(0, 16) + be(13, 4) + be(0x7FFF'FFFF, 4) + "FANTAIL_STATE" + two, 5), both);
  EXPECT_EQ(read_log("", 5), "");
  EXPECT_EQ(read_log("a text that is no log", 5), "");
  for (std::size_t size = 0; size < two.size(); ++size) {
    EXPECT_EQ(read_log(one + two.substr(0, size), 5), "1 FANTAIL_STATE a\n") << size;
  }
}

}  // namespace
}  // namespace fantail::telemetry
