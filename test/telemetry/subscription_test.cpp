// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "system/folder.hpp"
#include "telemetry/publisher.hpp"
#include "telemetry/receiver.hpp"

namespace fantail::telemetry {
namespace {

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

}  // namespace
}  // namespace fantail::telemetry
