// SPDX-License-Identifier: MIT

#include "live/sheet_feed.hpp"

#include "json/value.hpp"
#include "live/panel.hpp"
#include "live/plot_history.hpp"
#include "live/server.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::live {
namespace {

json::Value frame_of(SheetFeed& feed) { return json::parse(feed.frame()); }

TEST(SheetFeed, SaysWhereTheCanardsAreAndWhatIsDone) {
  SheetFeed feed;
  EXPECT_EQ(frame_of(feed)["of_s"], 0.0) << "nothing has begun";
  feed.begin(22.0, {text::radians(6.0), text::radians(6.0), text::radians(5.0), text::radians(6.0)});
  feed.move(1.5, 1.4, "canard 1 alone: at the centre", {text::radians(2.0)}, {text::radians(1.25)});
  const json::Value frame = frame_of(feed);
  EXPECT_EQ(frame["time_s"], 1.4) << "what the exercise has done, not the rocket's clock";
  EXPECT_EQ(frame["of_s"], 22.0);
  EXPECT_EQ(frame["now"], "canard 1 alone: at the centre");
  EXPECT_EQ(frame["ended"], false);
  EXPECT_EQ(frame["canards"][0]["encoder_deg"], 1.25);
  EXPECT_EQ(frame["canards"][2]["limit_deg"], 5.0);
  EXPECT_TRUE(frame["canards"][3]["encoder_deg"].is_null());
  EXPECT_EQ(frame["plot"][0].dump(),
            "[1500,1500,200,200,125,125,null,null,null,null,null,null,null,null,null,null,null,null]");
}

TEST(SheetFeed, ASheetIsToldOnceAndToEverybodyWhoComesLater) {
  SheetFeed feed;
  feed.begin(1.0, {});
  EXPECT_FALSE(frame_of(feed).contains("sheet"));
  feed.fill("<p>so far</p>");
  EXPECT_EQ(frame_of(feed)["sheet"], "<p>so far</p>");
  EXPECT_FALSE(frame_of(feed).contains("sheet"));
  const json::Value greeting = json::parse(feed.greeting());
  EXPECT_EQ(greeting["sheet"], "<p>so far</p>");
  EXPECT_EQ(greeting["first"], true);
}

TEST(SheetFeed, AnExerciseOfAMinuteIsKeptFromItsBeginning) {
  SheetFeed feed;
  feed.begin(61.0, {});
  for (int ms = 0; ms <= 61'000; ++ms) {
    feed.move(1e-3 * ms, 1e-3 * ms, "", {}, {});
  }
  (void)feed.frame();
  const json::Value told = json::parse(feed.greeting());
  EXPECT_EQ(told["plot"][0][0], 0.0);
  EXPECT_LE(told["plot"].size(), 61.0 * 40.0 + 2.0);
  feed.end();
  EXPECT_EQ(frame_of(feed)["ended"], true);
  EXPECT_EQ(frame_of(feed)["why"], "");
}

TEST(SheetFeed, AnEarlyEndIsToldWithItsReason) {
  SheetFeed feed;
  feed.end("interrupted; the canards are centred");
  const json::Value frame = frame_of(feed);
  EXPECT_EQ(frame["ended"], true);
  EXPECT_EQ(frame["why"], "interrupted; the canards are centred");
}

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

TEST(LivePanel, ANameWithHtmlInItIsText) {
  const std::string page =
      panel({.source = "<img src=x onerror=alert(1)>{js}", .command = "fantail fly '<b>'", .version = "1.2"}).html;
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("<title>Fantail live: &lt;img src=x onerror=alert(1)&gt;{js}</title>"), std::string::npos);
  EXPECT_NE(page.find(">fantail fly &#39;&lt;b&gt;&#39;</code>, Fantail <span id=\"version\">1.2"), std::string::npos);
}

TEST(LivePanel, LoadsNothingAndSaysThatItMovesNothing) {
  const std::string page = panel({.source = "a rocket"}).html;
  EXPECT_NE(page.find("nothing on it can move or arm anything"), std::string::npos);
  for (const char* loads :
       {" src=", "@import", "url(", "fetch(", "XMLHttpRequest", "WebSocket", "<form", "<link rel=\"stylesheet\""}) {
    EXPECT_EQ(page.find(loads), std::string::npos) << loads;
  }
  EXPECT_NE(page.find("new EventSource(\"events\")"), std::string::npos);
  EXPECT_NE(page.find("uPlot"), std::string::npos);
}

using hal::Microseconds;
using json::Value;

Sample roll(double degrees) { return {degrees}; }

// Begin and end in ms, and the two values of the first signal in hundredths.
std::array<double, 4> first(const Value& row) {
  return {row[0].number(), row[1].number(), row[2].number(), row[3].number()};
}

TEST(PlotHistory, AStretchKeepsItsExtremesInTheOrderOfTheirTime) {
  PlotHistory plots{signals};
  for (const auto& [ms, degrees] : std::vector<std::pair<int, double>>{{0, 1.0}, {1, -7.5}, {2, 9.0}, {3, 2.0}}) {
    plots.add(Microseconds{1000 * ms}, roll(degrees));
  }
  const Value up = plots.take_news();
  ASSERT_EQ(up.size(), 1U);
  EXPECT_EQ(first(up[0]), (std::array{0.0, 3.0, -750.0, 900.0}));
  for (const auto& [ms, degrees] : std::vector<std::pair<int, double>>{{4, 1.0}, {5, 9.0}, {6, -7.5}}) {
    plots.add(Microseconds{1000 * ms}, roll(degrees));
  }
  EXPECT_EQ(first(plots.take_news()[0]), (std::array{4.0, 6.0, 900.0, -750.0}));
}

TEST(PlotHistory, AKilohertzBecomesFortyStretchesASecondAndNoneOfThemTwice) {
  PlotHistory plots{signals};
  for (int ms = 0; ms < 1000; ++ms) {
    plots.add(Microseconds{1000 * ms}, roll(ms));
  }
  const Value news = plots.take_news();
  ASSERT_EQ(news.size(), 40U);
  EXPECT_EQ(first(news[39]), (std::array{975.0, 999.0, 97500.0, 99900.0}));
  EXPECT_EQ(plots.take_news().size(), 0U);
  plots.add(Microseconds{1'000'000}, roll(5.0));
  EXPECT_EQ(first(plots.take_news()[0]), (std::array{1000.0, 1000.0, 500.0, 500.0}));
}

TEST(PlotHistory, WhoComesLateIsToldWhatOthersWereAndNotWhatTheyWillBe) {
  PlotHistory plots{signals};
  plots.add(Microseconds{0}, roll(1.0));
  (void)plots.take_news();
  plots.add(Microseconds{30'000}, roll(2.0));
  const Value told = plots.all_told();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(first(told[0])[2], 100.0);
  EXPECT_EQ(plots.take_news().size(), 1U);
  EXPECT_EQ(plots.all_told().size(), 2U);
}

TEST(PlotHistory, HalfAMinuteIsKept) {
  PlotHistory plots{signals};
  for (int ms = 0; ms <= 60'000; ms += 10) {
    plots.add(Microseconds{1000 * ms}, roll(ms));
    if (ms % 1000 == 0) {
      (void)plots.take_news();
    }
  }
  const Value all = plots.all_told();
  EXPECT_GE(all[0][1].number(), 30'000.0);
  EXPECT_LE(all[0][0].number(), 30'100.0);
  // Nobody takes them: then no more is waiting than is kept.
  for (int ms = 60'010; ms <= 180'000; ms += 10) {
    plots.add(Microseconds{1000 * ms}, roll(ms));
  }
  EXPECT_LE(plots.take_news().size(), 1201U);
}

TEST(PlotHistory, WhatIsUnknownIsNullAndWhatIsOldIsLeftOut) {
  PlotHistory plots{signals};
  plots.add(Microseconds{5'000}, Sample{std::nullopt, 3.0, std::nan(""), 1e300});
  plots.add(Microseconds{5'000}, roll(7.0));
  plots.add(Microseconds{4'000}, roll(7.0));
  const Value news = plots.take_news();
  ASSERT_EQ(news.size(), 1U);
  EXPECT_TRUE(news[0][2].is_null());
  EXPECT_EQ(news[0][4].number(), 300.0);
  EXPECT_TRUE(news[0][6].is_null());
  EXPECT_TRUE(news[0][8].is_null()) << "no browser could add it to anything";
  EXPECT_EQ(news[0].size(), 2U + 2U * signals);
}

}  // namespace

}  // namespace fantail::live
