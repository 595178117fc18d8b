// SPDX-License-Identifier: MIT
#include "identify/choices.hpp"

#include <variant>

#include <gtest/gtest.h>

#include "identify/flown_log.hpp"
#include "identify/make_record.hpp"
#include "logs/refused.hpp"

namespace fantail::identify {
namespace {

using namespace model;

using test::expect_refused;
using test::flown_log;
using text::ErrorKind;

// 1 s to 9 s on the log's clock; burn-out at 4 s.
Record record() { return make_record(flown_log(), find_window(flown_log(), "control"), {}); }

TEST(NodeChoice, MayBeTimes) {
  EXPECT_EQ(std::get<NodeTimes>(find_nodes(flown_log(), record(), "0,5")), (NodeTimes{0.0, 5.0}));
  EXPECT_EQ(std::get<NodeTimes>(find_nodes(flown_log(), record(), "2.5")), (NodeTimes{2.5}));
}

TEST(NodeChoice, MayBeEvenOrAutomatic) {
  EXPECT_EQ(std::get<EvenNodes>(find_nodes(flown_log(), record(), "even:3")).intervals, 3U);
  EXPECT_EQ(std::get<EvenNodes>(find_nodes(flown_log(), record(), "even:0")).intervals, 0U);
  EXPECT_EQ(std::get<AutomaticNodes>(find_nodes(flown_log(), record(), "auto")).most, 6U);
}

TEST(NodeChoice, MayDivideThrustAndCoast) {
  const NodeTimes nodes = std::get<NodeTimes>(find_nodes(flown_log(), record(), "thrust:2,coast:2"));
  ASSERT_EQ(nodes.size(), 5U);
  const NodeTimes expected{1.0, 2.5, 4.0, 6.5, 9.0};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(nodes[k], expected[k], 1e-9);
  }
}

TEST(NodeChoice, NeedsToKnowBurnOutForThat) {
  logs::RollLog log = flown_log();
  log.burnout_s = 0.5;
  expect_refused(ErrorKind::bad_data, {"--nodes thrust:1,coast:1", "burnt out at 0.5 s", "outside the window control"},
                 [&] { (void)find_nodes(log, record(), "thrust:1,coast:1"); });
  log.burnout_s.reset();
  log.specific_force_m_s2.clear();
  expect_refused(ErrorKind::bad_data, {"burn-out is unknown"},
                 [&] { (void)find_nodes(log, record(), "thrust:1,coast:1"); });
}

TEST(NodeChoice, OfAnotherKindIsRefusedWithTheKindsThereAre) {
  for (const char* text : {"", "5,0", "1,1", "a", "1,", "even:", "even:-1", "even:1.5", "even:1000", "thrust:2",
                           "coast:1,thrust:1", "thrust:0,coast:1", "automatic"}) {
    expect_refused(ErrorKind::bad_configuration, {"--nodes", text, "even:N; thrust:N,coast:M; auto"},
                   [&] { (void)find_nodes(flown_log(), record(), text); });
  }
}

TEST(Axis, IsReadFromFirstLastAndStep) {
  const auto axis = parse_axis("1:60:0.5");
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->values().size(), 119U);
  for (const char* text :
       {"", "1", "1:60", "1:60:0", "60:1:1", "0:60:1", "1:60:-1", "a:60:1", "1:60:1:1", "1:60:0.001", "::"}) {
    EXPECT_FALSE(parse_axis(text)) << text;
  }
}

void expect_window(const std::string& text, double from_s, double to_s) {
  const Window window = find_window(flown_log(), text);
  ASSERT_TRUE(window.from_s && window.to_s) << text;
  EXPECT_NEAR(*window.from_s, from_s, 1e-9) << text;
  EXPECT_NEAR(*window.to_s, to_s, 1e-9) << text;
  EXPECT_EQ(window.name, text);
}

TEST(Window, IsFoundByTheEventsOfTheLog) {
  expect_window("control", 1.0, 9.0);
  expect_window("thrust", 1.0, 4.0);
  expect_window("coast", 4.0, 9.0);
  expect_window("step:1", 3.0, 4.99);
  expect_window("step:2", 5.0, 9.0);
}

TEST(Window, MayBeGivenInSeconds) {
  expect_window("0.4:2", 0.4, 2.0);
  expect_window("-1:2e0", -1.0, 2.0);
  EXPECT_EQ(find_window(flown_log(), "3:").to_s, std::nullopt);
  EXPECT_EQ(find_window(flown_log(), ":3").from_s, std::nullopt);
}

TEST(Window, AWordThatIsNoneIsRefusedWithThoseThatAre) {
  for (const char* text : {"controll", "", ":", "a:b", "1:b", "step:0", "step:-1", "step:", "step:1x", "1", "1:2:3"}) {
    expect_refused(ErrorKind::bad_configuration, {"--window", text, "allowed: control, thrust, coast, step:N, A:B"},
                   [&] { (void)find_window(flown_log(), text); });
  }
  expect_refused(ErrorKind::bad_configuration, {"did you mean control?"},
                 [] { (void)find_window(flown_log(), "controll"); });
}

TEST(Window, WhatTheLogDoesNotSayIsRefused) {
  logs::RollLog log = flown_log();
  expect_refused(ErrorKind::bad_data, {"flown.csv: --window step:3", "changes of the reference under control: 2"},
                 [&] { (void)find_window(log, "step:3"); });
  log.reference_rad.clear();
  expect_refused(ErrorKind::bad_data, {"no column reference_deg"}, [&] { (void)find_window(log, "step:1"); });
  log.specific_force_m_s2.clear();
  expect_refused(ErrorKind::bad_data, {"burn-out is unknown"}, [&] { (void)find_window(log, "coast"); });
  log.burnout_s = 0.5;
  expect_refused(ErrorKind::bad_data, {"burnt out at 0.5 s, which is not inside control, 1 s to 9 s"},
                 [&] { (void)find_window(log, "thrust"); });
  log.phase.assign(log.time_s.size(), core::Phase::armed);
  expect_refused(ErrorKind::bad_data, {"never \"controlling\""}, [&] { (void)find_window(log, "control"); });
  log.phase.clear();
  expect_refused(ErrorKind::bad_data, {"no column phase", "seconds"}, [&] { (void)find_window(log, "control"); });
}

TEST(BurnOut, IsWhatTheSummarySays) {
  logs::RollLog log = flown_log();
  log.burnout_s = 3.188;
  EXPECT_EQ(burnout_s(log), 3.188);
}

TEST(BurnOut, IsWhereTheSpecificForceFallsBelowZeroForGood) {
  logs::RollLog log = flown_log();
  ASSERT_TRUE(burnout_s(log));
  EXPECT_NEAR(*burnout_s(log), 4.0, 1e-9);
  log.specific_force_m_s2[300] = -1.0;  // one sample at 2 s is not for good
  EXPECT_NEAR(*burnout_s(log), 4.0, 1e-9);
}

TEST(BurnOut, IsUnknownWithoutThrust) {
  logs::RollLog log = flown_log();
  log.specific_force_m_s2.assign(log.time_s.size(), -1.0);
  EXPECT_EQ(burnout_s(log), std::nullopt);
  log.specific_force_m_s2.assign(log.time_s.size(), 9.8);
  EXPECT_EQ(burnout_s(log), std::nullopt);
  log.specific_force_m_s2.clear();
  EXPECT_EQ(burnout_s(log), std::nullopt);
}

}  // namespace
}  // namespace fantail::identify
