// SPDX-License-Identifier: MIT
#include "live/feed.hpp"

#include "degree.hpp"
#include "test.hpp"

namespace fantail::live {
namespace {

using hal::Microseconds;
using json::Value;
using telemetry::Canards;
using telemetry::Event;
using telemetry::Health;
using telemetry::Packet;
using telemetry::Stamp;
using telemetry::State;

/// A page that hears what it is given; both clocks go on together.
struct Heard {
  void hear(const Packet& packet) { feed.take(telemetry::name(packet.channel), packet.content(), now); }
  void hear_state(const State& state) {
    now += Microseconds{10'000};
    hear(encode(Stamp{.run = run, .sequence = sequence++, .time = now}, state));
  }
  void hear_phase(core::Phase before, core::Phase phase) {
    hear(encode(Stamp{.run = run, .sequence = events++, .time = now},
                Event{.phase = Event::PhaseChange{
                          .before = before, .phase = phase, .reason = core::PhaseReason::launch_detected}}));
  }
  Value frame() { return json::parse(feed.frame(now)); }
  Value greeting() { return json::parse(feed.greeting(now)); }

  std::int64_t run = 7;
  std::int64_t sequence = 0;
  std::int64_t events = 0;
  Microseconds now{1'000'000};
  Feed feed{{.name = "a <rocket>", .settles_off_rad = -24.5 * degree}};
};

TEST(LiveFeed, BeforeTheFirstMessageNothingIsClaimed) {
  Heard heard;
  const Value frame = heard.frame();
  EXPECT_EQ(frame["link"]["is"].text(), "silent");
  EXPECT_FALSE(frame.contains("phase"));
  EXPECT_TRUE(frame["run"].is_null());
  EXPECT_EQ(frame["plot"].size(), 0U);
}

TEST(LiveFeed, AFrameHasWhatWasHeardInDegrees) {
  Heard heard;
  heard.hear_state({.phase = core::Phase::controlling,
                    .saturated = true,
                    .roll_angle_rad = 30.0 * degree,
                    .reference_rad = -20.0 * degree,
                    .height_m = 12.34});
  Canards canards;
  canards.command_rad[1] = 2.0 * degree;
  canards.encoder_rad[1] = 1.5 * degree;
  canards.limited[1] = true;
  canards.verdicts[2] = core::CanardVerdict::stalled;
  heard.hear(encode(Stamp{.run = 7, .sequence = 0, .time = heard.now}, canards));
  const Value frame = heard.frame();
  EXPECT_EQ(frame["link"]["is"].text(), "live");
  EXPECT_EQ(frame["phase"].text(), "controlling");
  EXPECT_EQ(frame["roll_deg"].number(), 30.0);
  EXPECT_EQ(frame["reference_deg"].number(), -20.0);
  EXPECT_EQ(frame["height_m"].number(), 12.3);
  EXPECT_TRUE(frame["saturated"].boolean());
  EXPECT_TRUE(frame["speed_m_s"].is_null());
  EXPECT_EQ(frame["canards"][1]["command_deg"].number(), 2.0);
  EXPECT_EQ(frame["canards"][1]["encoder_deg"].number(), 1.5);
  EXPECT_TRUE(frame["canards"][1]["limited"].boolean());
  EXPECT_TRUE(frame["canards"][0]["encoder_deg"].is_null());
  EXPECT_EQ(frame["canards"][2]["verdict"].text(), "stalled");
  EXPECT_TRUE(frame["health"].is_null());
}

TEST(LiveFeed, OutsideOfControlThereIsNoReference) {
  Heard heard;
  heard.hear_state({.phase = core::Phase::finished, .reference_rad = 0.0});
  const Value frame = heard.frame();
  EXPECT_TRUE(frame["reference_deg"].is_null());
  EXPECT_TRUE(frame["plot"][0][4].is_null());
}

TEST(LiveFeed, FramesAreNumberedAndEachTellsItsNewsOnce) {
  Heard heard;
  heard.hear_state({});
  heard.hear_phase(core::Phase::safe, core::Phase::armed);
  const Value one = heard.frame();
  const Value two = heard.frame();
  EXPECT_EQ(two["frame"].count(), one["frame"].count() + 1);
  EXPECT_EQ(one["events"].size(), 1U);
  EXPECT_EQ(one["plot"].size(), 1U);
  EXPECT_EQ(two["events"].size(), 0U);
  EXPECT_EQ(two["plot"].size(), 0U);
}

TEST(LiveFeed, WhoComesLateIsToldEverythingUpToTheFrameOfThatNumber) {
  Heard heard;
  heard.hear_state({});
  heard.hear_phase(core::Phase::safe, core::Phase::armed);
  const Value frame = heard.frame();
  heard.hear_state({});
  const Value greeting = heard.greeting();
  EXPECT_EQ(greeting["frame"].count(), frame["frame"].count());
  EXPECT_EQ(greeting["source"].text(), "a <rocket>");
  EXPECT_EQ(greeting["settles_off_deg"].number(), -24.5);
  EXPECT_EQ(greeting["events"].size(), 1U);
  EXPECT_EQ(greeting["plot"].size(), 1U);
  EXPECT_EQ(heard.frame()["plot"].size(), 1U) << "what the greeting did not tell";
}

TEST(LiveFeed, EventsAreToldInPlainWords) {
  Heard heard;
  heard.hear_state({});
  heard.hear_phase(core::Phase::armed, core::Phase::launched);
  EXPECT_EQ(heard.frame()["events"][0]["text"].text(), "Launched: launch detected");
  const telemetry::Event::VerdictChange change{.canard = 2, .verdict = core::CanardVerdict::stalled};
  heard.hear(encode(Stamp{.run = heard.run, .sequence = heard.events++, .time = heard.now},
                    telemetry::Event{.verdict = change}));
  EXPECT_EQ(heard.frame()["events"][0]["text"].text(), "Canard 3: stalled, before: healthy");
}

TEST(LiveFeed, ThatNoMoreComesIsToldToEverybodyFromThenOn) {
  Heard heard;
  heard.hear_state({});
  EXPECT_TRUE(heard.frame()["ended"].is_null());
  heard.feed.end();
  EXPECT_EQ(heard.frame()["ended"].text(), "The program behind this page");
  EXPECT_EQ(heard.greeting()["ended"].text(), "The program behind this page");
}

TEST(LiveFeed, TheLinkIsCountedOverNoLongerThanSinceTheFirstMessage) {
  Heard heard;
  (void)heard.frame();
  heard.now += Microseconds{4'000'000};  // a browser is waited for
  heard.hear_state({});
  for (int i = 0; i < 32; ++i) {
    heard.now += Microseconds{100'000};
    (void)heard.frame();
  }
  EXPECT_DOUBLE_EQ(heard.frame()["link"]["span_s"].number(), 3.2);
}

TEST(LiveFeed, TheClockBeginsWithTheDetectionAndEndsWithABackToArmed) {
  Heard heard;
  heard.hear_state({.phase = core::Phase::armed});
  EXPECT_TRUE(heard.frame()["since_launch_s"].is_null());
  heard.hear_phase(core::Phase::armed, core::Phase::launched);
  heard.hear_state({.phase = core::Phase::launched});
  heard.hear_state({.phase = core::Phase::controlling});
  EXPECT_DOUBLE_EQ(heard.frame()["since_launch_s"].number(), 0.02);
  heard.hear_state({.phase = core::Phase::armed});
  EXPECT_TRUE(heard.frame()["since_launch_s"].is_null());
}

TEST(LiveFeed, OfALaunchWhoseEventWasLostTheClockBeginsWithItsFirstState) {
  Heard heard;
  heard.hear_state({.phase = core::Phase::armed});
  heard.hear_state({.phase = core::Phase::launched});
  heard.hear_state({.phase = core::Phase::launched});
  EXPECT_DOUBLE_EQ(heard.frame()["since_launch_s"].number(), 0.01);
}

TEST(LiveFeed, OfALaunchThatWasNotSeenThereIsNoClock) {
  Heard heard;
  heard.hear_state({.phase = core::Phase::controlling});
  heard.hear_state({.phase = core::Phase::controlling});
  EXPECT_TRUE(heard.frame()["since_launch_s"].is_null());
}

TEST(LiveFeed, WhatIsNotNewForASecondIsOldAndStays) {
  Heard heard;
  heard.hear_state({.phase = core::Phase::finished, .height_m = 300.0});
  heard.now += Microseconds{1'100'000};
  const Value frame = heard.frame();
  EXPECT_EQ(frame["link"]["is"].text(), "old");
  EXPECT_EQ(frame["link"]["age_s"].number(), 1.1);
  EXPECT_EQ(frame["phase"].text(), "finished");
  EXPECT_EQ(frame["height_m"].number(), 300.0);
}

TEST(LiveFeed, AnotherSendersFlightBeginsWithEmptyPlots) {
  Heard heard;
  for (int i = 0; i < 20; ++i) {
    heard.hear_state({});
  }
  heard.hear_phase(core::Phase::safe, core::Phase::armed);
  (void)heard.frame();
  heard.run = 8;
  heard.sequence = 0;
  for (int i = 0; i < 200; ++i) {
    heard.hear_state({});
  }
  const Value frame = heard.frame();
  EXPECT_EQ(frame["run"].text(), "8");
  EXPECT_EQ(heard.greeting()["events"].size(), 0U);
  EXPECT_GT(heard.greeting()["plot"][0][0].number(), 1200.0);
  EXPECT_EQ(frame["link"]["restarts"].number(), 1.0);
}

TEST(LiveFeed, OfGarbageNothingIsShown) {
  Heard heard;
  const std::string bytes(100, 'x');
  heard.feed.take("FANTAIL_STATE", std::as_bytes(std::span{bytes}), heard.now);
  heard.feed.take("<script>", {}, heard.now);
  EXPECT_EQ(heard.frame()["link"]["is"].text(), "silent");
}

}  // namespace
}  // namespace fantail::live
