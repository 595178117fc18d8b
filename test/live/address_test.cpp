// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "live/server.hpp"

namespace fantail::live {
namespace {

TEST(LiveAddress, WithoutAWordOnlyThisComputerReachesThePage) {
  EXPECT_EQ(Address{}.url(), "http://127.0.0.1:8080/");
  EXPECT_TRUE(Address{}.is_of_this_computer_alone());
}

TEST(LiveAddress, IsAHostAndAPort) {
  EXPECT_EQ(address_of("[::1]:9000").url(), "http://[::1]:9000/");
  EXPECT_EQ(address_of("rocket-pc.local:0").host, "rocket-pc.local");
  EXPECT_EQ(address_of("0.0.0.0:8080").url(), "http://localhost:8080/");
  for (const char* text : {"127.0.0.1:8080", "[::1]:1", "localhost:65535", "rocket-pc:0"}) {
    EXPECT_EQ(objection_to_address(text), "") << text;
  }
  for (const char* text : {"", ":", "8080", ":8080", "127.0.0.1", "127.0.0.1:", "127.0.0.1:65536", "127.0.0.1:-1",
                           "127.0.0.1:80x", "127.0.0.1: 80", "::1:8080", "[::1]", "[localhost]:80",
                           "http://localhost:80", "a b:80", "-x:80", "127.0.0.1:99999999999999999999"}) {
    EXPECT_NE(objection_to_address(text), "") << text;
  }
}

TEST(LiveAddress, OnlyWhatIsOnThisComputerIsOfThisComputerAlone) {
  for (const char* text : {"127.0.0.1:1", "127.0.0.2:1", "localhost:1", "[::1]:1"}) {
    EXPECT_TRUE(address_of(text).is_of_this_computer_alone()) << text;
  }
  for (const char* text : {"0.0.0.0:1", "[::]:1", "192.168.1.2:1", "rocket-pc:1"}) {
    EXPECT_FALSE(address_of(text).is_of_this_computer_alone()) << text;
  }
}

TEST(LiveAddress, AnotherSitesNameThatLeadsHereMayNotAsk) {
  const Address own;
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "LOCALHOST:8080", "[::1]:8080"}) {
    EXPECT_TRUE(may_ask(own, host, "pc")) << host;
  }
  for (const char* host : {"", "evil.example:8080", "localhost.evil.example:8080", "127.0.0.1", "127.0.0.1:80",
                           "localhost:8081", "pc:8080", "192.168.1.2:8080", "127.0.0.1:8080:8080", "127.0.0.1:8080x"}) {
    EXPECT_FALSE(may_ask(own, host, "pc")) << host;
  }
}

TEST(LiveAddress, ForEverybodyOnTheNetworkItMayBeAskedByNumberAndByTheComputersOwnName) {
  const Address all{.host = "0.0.0.0", .port = 8080};
  for (const char* host : {"192.168.1.2:8080", "[fe80::1]:8080", "localhost:8080", "pc:8080", "PC.local:8080"}) {
    EXPECT_TRUE(may_ask(all, host, "pc")) << host;
  }
  for (const char* host : {"evil.example:8080", "pc.evil.example:8080", "192.168.1.2:80"}) {
    EXPECT_FALSE(may_ask(all, host, "pc")) << host;
  }
  EXPECT_FALSE(may_ask(all, ".local:8080", ""));
  EXPECT_TRUE(may_ask({.host = "0.0.0.0", .port = 80}, "192.168.1.2", "pc")) << "80 is what a browser leaves out";
}

}  // namespace
}  // namespace fantail::live
