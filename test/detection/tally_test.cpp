// SPDX-License-Identifier: MIT
#include "detection/tally.hpp"

#include <gtest/gtest.h>

#include "runs/row_text.hpp"

namespace fantail::detection {
namespace {

TEST(Tally, APointOfAHistogramHasItsShareAtOrBelowIt) {
  Histogram histogram;
  EXPECT_FALSE(histogram.point(0.5));
  histogram.add(-3, 50);
  histogram.add(10, 49);
  histogram.add(200);
  EXPECT_EQ(histogram.point(0.5), -3);
  EXPECT_EQ(histogram.point(0.51), 10);
  EXPECT_EQ(histogram.point(0.99), 10);
  EXPECT_EQ(histogram.point(0.999), 200);
}

Tally read_back(Tally tally) {
  runs::RowText text;
  text(tally);
  std::vector<Tally> back{Tally{0}};
  EXPECT_TRUE(runs::read_rows(text.text(), back)) << text.text();
  return back[0];
}

TEST(Tally, ComesBackFromItsTextAsItWas) {
  Tally tally{2};
  const std::vector<Rule> rules(2);
  Answer answer{.detected = 300, .controlling = 600, .nearness = 1.0F, .crossing = 180};
  answer.distance_m = 6.25F;
  answer.distance_error_m = -0.125F;
  tally.count(Kind::launch, 5, rules, {answer, Answer{}}, {.ignition = 170, .peak_g = 4});
  tally.count(Kind::shaking, 4, rules, {Answer{}, Answer{.detected = 3, .nearness = 0.5F}}, {});
  EXPECT_EQ(read_back(tally), tally);
  EXPECT_EQ(tally.of_rule[0][0].latency_ms.point(1.0), 120);
  EXPECT_EQ(tally.of_rule[0][0].control_ms.point(1.0), 430);
  EXPECT_EQ(tally.of_rule[0][0].missed_by_peak_g.total(), 0U);
  EXPECT_EQ(tally.of_rule[1][0].missed_by_peak_g.counts().at(4), 1U);
  EXPECT_EQ(tally.of_rule[1][0].worst, (Worst{.event = 5, .value = Worst::missed}));
}

TEST(Tally, AFlightThatARuleControlsAsItShouldIsNoEventForThatRule) {
  Tally tally{2};
  const std::vector<Rule> rules(2);
  const Answer woken{.detected = 9'000, .controlling = 9'400, .nearness = 1.0F, .part = Part::main};
  tally.count(Kind::missed_flight, 6, rules, {Answer{.flown = true}, woken}, {});
  EXPECT_EQ(tally.of_rule[0][0].events, 0U);
  EXPECT_EQ(tally.of_rule[0][0].flown, 1U);
  EXPECT_EQ(tally.of_rule[1][0].events, 1U);
  EXPECT_EQ(tally.of_rule[1][0].controlling, 1U);
  EXPECT_EQ(tally.of_rule[1][0].control_by_part.times(static_cast<int>(Part::main)), 1U);
  EXPECT_EQ(read_back(tally), tally);
}

TEST(Tally, OfARaisedRailAWrongTiltIsCountedBesideTheTimeThatItStood) {
  Tally tally{1};
  const std::vector<Rule> rules(1);
  Answer answer{.detected = 300, .controlling = 600, .crossing = 180};
  answer.tilt_error_rad = -0.2F;  // 11.459 deg
  const LaunchTruth truth{.ignition = 170, .peak_g = 4, .still_s = 3};
  tally.count(Kind::raised_rail, 1, rules, {answer}, truth);
  answer.tilt_error_rad = 0.03F;
  tally.count(Kind::raised_rail, 2, rules, {answer}, truth);
  tally.count(Kind::raised_rail, 3, rules, {Answer{}}, truth);
  const Count& count = tally.of_rule[0][0];
  EXPECT_EQ(count.tilt_error_ddeg.point(1.0), 115);
  EXPECT_EQ(count.all_by_still_s.times(3), 3U);
  EXPECT_EQ(count.tilted_by_still_s.times(3), 1U);
  EXPECT_EQ(count.missed_by_still_s.times(3), 1U);
  EXPECT_EQ(read_back(tally), tally);
}

TEST(Tally, OfEquallyBadEventsTheFirstIsKept) {
  Tally one{1};
  Tally other{1};
  const std::vector<Rule> rules(1);
  one.count(Kind::drop, 8, rules, {Answer{.nearness = 0.25F}}, {});
  other.count(Kind::drop, 4, rules, {Answer{.nearness = 0.25F}}, {});
  one.add(other);
  EXPECT_EQ(one.of_rule[0][0].worst.event, 4U);
  EXPECT_EQ(one.of_rule[0][0].events, 2U);
}

}  // namespace
}  // namespace fantail::detection
