// SPDX-License-Identifier: MIT
#include "telemetry/url.hpp"

#include <string>

#include <gtest/gtest.h>

namespace fantail::telemetry {
namespace {

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
