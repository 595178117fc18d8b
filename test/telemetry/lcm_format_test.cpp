// SPDX-License-Identifier: MIT

#include "telemetry/lcm_format.hpp"

#include "system/folder.hpp"
#include "telemetry/publisher.hpp"
#include "telemetry/receiver.hpp"
#include "telemetry/url.hpp"
#include "test.hpp"

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

using test::Folder;

Packet state(std::int64_t sequence) {
  return encode(Stamp{.run = 9, .sequence = sequence, .time = core::Microseconds{10'000 * sequence}},
                State{.roll_angle_rad = static_cast<double>(sequence)});
}

void listen_to_the_end(const std::string& url, Receiver& receiver) {
  Subscription subscription{Url{url}};
  while (subscription.listen([&](auto channel, auto bytes) { receiver.take(channel, bytes, {}); })) {
    subscription.wait(std::chrono::milliseconds{100});
  }
}

TEST(Subscription, HearsAllThatWasWrittenIntoALog) {
  const Folder folder;
  const std::string url = "file://" + (folder / "flight.lcmlog");
  {
    const auto log = open_outlet(Url{url});
    for (std::int64_t i = 0; i < 20'000; ++i) {
      if (i % 100 != 50) {
        EXPECT_TRUE(log->put(state(i)));
      }
    }
    EXPECT_TRUE(log->close());
  }
  Receiver receiver;
  listen_to_the_end(url + "?speed=0", receiver);
  EXPECT_EQ(receiver.total(Channel::state), (ChannelFigures{.received = 19'800, .lost = 200}));
  EXPECT_EQ(receiver.state()->content.roll_angle_rad, 19'999.0);
}

TEST(Subscription, ALogOfThisFormatReadsBackToTheByte) {
  const Folder folder;
  const std::string path = folder / "flight.lcmlog";
  const Packet packet = state(3);
  {
    const auto log = open_outlet(Url{"file://" + path});
    EXPECT_TRUE(log->put(packet));
    EXPECT_TRUE(log->close());
  }
  // Of the format's description: sync word, number, time in microseconds, two lengths, channel, message.
  std::string wanted{"\xED\xA1\xDA\x01", 4};
  wanted += std::string{"\0\0\0\0\0\0\0\0", 8};
  wanted += std::string{"\0\0\0\0\0\0\x75\x30", 8};  // 30 000 us
  wanted += std::string{"\0\0\0\x0D", 4};
  wanted += std::string{"\0\0\0", 3} + static_cast<char>(packet.size);
  wanted += "FANTAIL_STATE";
  for (const std::byte byte : packet.content()) {
    wanted += static_cast<char>(byte);
  }
  EXPECT_EQ(test::content(path), wanted);
}

TEST(Subscription, AFileThatIsNotThereOrNoLogIsAnError) {
  const Folder folder;
  EXPECT_THROW(Subscription{Url{"file://" + (folder / "none")}}, TelemetryError);
  const std::string empty = folder.write("empty", "");
  EXPECT_THROW(Subscription{Url{"file://" + empty}}, TelemetryError);
}

TEST(Outlet, AFolderThatIsNotThereAndAFullDiskAreErrors) {
  const Folder folder;
  EXPECT_THROW((void)open_outlet(Url{"file://" + (folder / "none/flight.lcmlog")}), TelemetryError);
  const auto full = open_outlet(Url{"file:///dev/full"});
  (void)full->put(state(0));
  EXPECT_FALSE(full->close());
}

TEST(Url, WhatIsLeftOutIsWhatTheToolsOfLcmTake) {
  for (const char* text : {"udpm://", "udpm://239.255.76.67", "udpm://239.255.76.67:7667", "udpm://?ttl=1"}) {
    const Url url{text};
    EXPECT_FALSE(url.is_file());
    EXPECT_EQ(url.address(), "239.255.76.67") << text;
    EXPECT_EQ(url.port(), 7667) << text;
  }
}

TEST(Url, AFileIsAPathWithoutItsOptions) {
  const Url url{"file:///tmp/a b.lcmlog?speed=0.5"};
  EXPECT_TRUE(url.is_file());
  EXPECT_EQ(url.path(), "/tmp/a b.lcmlog");
  EXPECT_EQ(Url{"file://flight.lcmlog"}.path(), "flight.lcmlog");
}

TEST(Url, TheEndsOfEveryRange) {
  for (const char* good : {"udpm://224.0.0.0:1", "udpm://239.255.255.255:65535", "udpm://?ttl=0", "udpm://?ttl=255",
                           "udpm://239.0.0.1:7667?ttl=1&recv_buf_size=2000000", "file:///f?speed=0"}) {
    EXPECT_EQ(objection_to_url(good), "") << good;
  }
  for (const char* bad : {"",
                          "udpm",
                          "udp://239.255.76.67:7667",
                          "239.255.76.67:7667",
                          "memq://",
                          "udpm://223.255.255.255:7667",
                          "udpm://240.0.0.0:7667",
                          "udpm://localhost:7667",
                          "udpm://239.255.76.67:0",
                          "udpm://239.255.76.67:65536",
                          "udpm://239.255.76.67:",
                          "udpm://239.255.76.67:76a",
                          "udpm://?ttl=256",
                          "udpm://?ttl=-1",
                          "udpm://?ttl=",
                          "udpm://?tll=1",
                          "udpm://?",
                          "udpm://?ttl=1&",
                          "udpm://?recv_buf_size=0",
                          "file://",
                          "file://?speed=1",
                          "file:///f?mode=w",
                          "file:///f?speed=-1",
                          "file:///f?speed=fast",
                          "file:///f?speed=nan"}) {
    EXPECT_NE(objection_to_url(bad), "") << bad;
  }
}

TEST(Url, AnObjectionNamesWhatIsWrongAndWhatIsAllowed) {
  EXPECT_EQ(
      objection_to_url("udpm://10.0.0.1:7667"),
      "\"10.0.0.1\" is not a multicast address; allowed: udpm://ADDRESS:PORT with a multicast address (224.0.0.0 to "
      "239.255.255.255), or file:///PATH");
  EXPECT_EQ(objection_to_url("udpm://?tll=1"),
            "\"tll=1\" is not an option of \"udpm://?tll=1\"; allowed: ttl=HOPS (0 to 255, 0: this computer only), "
            "recv_buf_size=BYTES");
}

}  // namespace

}  // namespace fantail::telemetry
