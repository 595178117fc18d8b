// SPDX-License-Identifier: MIT
#include <memory>

#include <gtest/gtest.h>

#include "detection/event_models.hpp"
#include "detection/rehearsal.hpp"
#include "detection/screen.hpp"
#include "seed.hpp"

namespace fantail::detection {
namespace {

// The whole law has the last word; that the detector alone, and the largest sample before it, leave out only events in
// which nothing fires is what makes the counts of ten million events believable.
TEST(Paths, TheFastPathGivesTheAnswerOfTheWholeFlightLaw) {
  const std::uint32_t seed = test::seed(2016);
  const std::vector<Rule> rules = rules_of({});
  Rehearsal fast{rules};
  Rehearsal full{rules};
  std::size_t detected = 0;
  std::size_t controlling = 0;
  std::size_t quiet = 0;
  for (std::size_t kind = 0; kind < event_kinds; ++kind) {
    for (std::uint64_t event = 0; event < (static_cast<Kind>(kind) == Kind::shaking ? 600U : 60U); ++event) {
      const auto& a = fast.play(seed, static_cast<Kind>(kind), event, Path::fast);
      const auto& b = full.play(seed, static_cast<Kind>(kind), event, Path::full);
      for (std::size_t rule = 0; rule < rules.size(); ++rule) {
        ASSERT_EQ(a[rule].detected, b[rule].detected) << kind_table[kind].name << ' ' << event << rules[rule].name();
        ASSERT_EQ(a[rule].controlling, b[rule].controlling) << kind_table[kind].name << ' ' << event;
        ASSERT_EQ(a[rule].nearness, b[rule].nearness) << kind_table[kind].name << ' ' << event;
        detected += b[rule].detected ? 1 : 0;
        controlling += b[rule].controlling ? 1 : 0;
        quiet += b[rule].detected ? 0 : 1;
      }
    }
  }
  // There was something to disagree about.
  EXPECT_GT(detected, 100U);
  EXPECT_GT(controlling, 5U);
  EXPECT_GT(quiet, 1'000U);
}

// Of many more, through the detector alone.
TEST(Paths, WhereTheScreenSaysThatNoRuleFiresNoneDoes) {
  const std::uint32_t seed = test::seed(7);
  std::vector<Rule> rules = rules_of({});
  rules.push_back(rules.front());
  rules.back().plan.launch_detection.accelerometers = core::AccelerometerRule::two_agree;
  rules.back().plan.launch_detection.single_allowed = true;
  const auto motion = std::make_unique<Motion>();
  const auto readings = std::make_unique<Readings>();
  std::size_t kept_out = 0;
  std::size_t fired = 0;
  for (std::size_t kind = 0; kind < event_kinds; ++kind) {
    for (std::uint64_t event = 0; event < 500; ++event) {
      Streams streams = streams_of(seed, static_cast<Kind>(kind), event);
      make_event(static_cast<Kind>(kind), streams, *motion, false);
      begin_readings(static_cast<Kind>(kind), event, *motion, streams.axial, *readings);
      finish_readings(*motion, streams.axial, *readings);
      for (const Rule& rule : rules) {
        const bool may = may_fire(rule.plan.launch_detection, *motion, *readings);
        const bool does = fires(rule.plan, *readings, motion->length);
        ASSERT_TRUE(may || !does) << kind_table[kind].name << ' ' << event << ' ' << rule.name();
        kept_out += may ? 0 : 1;
        fired += does ? 1 : 0;
      }
    }
  }
  EXPECT_GT(kept_out, 10'000U);
  EXPECT_GT(fired, 400U);
}

TEST(Paths, ALaunchIsDetectedAfterItsCrossingAndControlledBeyondTheGuide) {
  const std::uint32_t seed = test::seed(11);
  const std::vector<Rule> rules = rules_of({});
  Rehearsal rehearsal{rules};
  std::size_t controlled = 0;
  for (std::uint64_t event = 0; event < 150; ++event) {
    const auto& answers = rehearsal.play(seed, Kind::launch, event);
    for (std::size_t rule = 0; rule < rules.size(); ++rule) {
      const Answer& answer = answers[rule];
      if (answer.controlling) {
        ++controlled;
        ASSERT_TRUE(answer.detected && answer.crossing);
        EXPECT_LT(*answer.crossing, *answer.detected);
        EXPECT_LT(*answer.detected, *answer.controlling);
        EXPECT_GT(answer.distance_m, rules[rule].plan.guide.length_m) << rules[rule].name() << ' ' << event;
      }
    }
  }
  EXPECT_GT(controlled, 300U);
}

// A pad at rest that is sampled every 4 ms instead of every 1 ms is still rest: the attitude is known, and the tilt of
// the first tick of the event is that of the rail.
TEST(Paths, TheSparsePadTellsTheLawHowTheRailLeans) {
  const std::uint32_t seed = test::seed(12);
  const std::vector<std::string> names{"tasha3_launch2"};
  const std::vector<Rule> rules = rules_of(names);
  Rehearsal rehearsal{rules};
  for (std::uint64_t event = 0; event < 20; ++event) {
    float tilt_rad = -1.0F;
    core::Phase phase = core::Phase::safe;
    rehearsal.on_tick = [&](std::size_t, std::size_t step, const core::TickRecord& record) {
      if (step == 0) {
        tilt_rad = record.motion.tilt.radians();
        phase = record.phase;
      }
    };
    (void)rehearsal.play(seed, Kind::tilt, 2 * event, Path::full);
    EXPECT_EQ(phase, core::Phase::armed);
    // Zeros off by up to 0.05 g lean it by up to 0.07 rad across its axis, and 0.013 more along it.
    EXPECT_NEAR(static_cast<double>(tilt_rad), rehearsal.motion().start_pitch_rad, 0.085) << event;
  }
}

}  // namespace
}  // namespace fantail::detection
