// SPDX-License-Identifier: MIT
#include "live/sheet_feed.hpp"

#include <gtest/gtest.h>

#include "json/value.hpp"
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

}  // namespace
}  // namespace fantail::live
