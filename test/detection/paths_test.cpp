// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/launch_detector.hpp"
#include "detection/event_models.hpp"
#include "detection/rehearsal.hpp"
#include "detection/screen.hpp"
#include "seed.hpp"

namespace fantail::detection {
namespace {

std::vector<Kind> events_that_are_no_launch() {
  std::vector<Kind> result;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    if (!is_launch(static_cast<Kind>(kind))) {
      result.push_back(static_cast<Kind>(kind));
    }
  }
  return result;
}

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
  for (const Kind kind : events_that_are_no_launch()) {
    for (std::uint64_t event = 0; event < (kind == Kind::shaking ? 600U : 60U); ++event) {
      const auto& a = fast.play(seed, kind, event, Path::fast);
      const auto& b = full.play(seed, kind, event, Path::full);
      for (std::size_t rule = 0; rule < rules.size(); ++rule) {
        ASSERT_EQ(a[rule].detected, b[rule].detected) << info(kind).name << ' ' << event << rules[rule].name();
        ASSERT_EQ(a[rule].controlling, b[rule].controlling) << info(kind).name << ' ' << event;
        ASSERT_EQ(a[rule].nearness, b[rule].nearness) << info(kind).name << ' ' << event;
        ASSERT_EQ(a[rule].flown, b[rule].flown) << info(kind).name << ' ' << event;
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

/// Does a detector fire that begins with this step?
bool fires_from(const core::FlightPlan& plan, const Readings& readings, std::size_t first, std::size_t length) {
  core::LaunchDetector detector{plan.launch_detection, plan.motion.stale_time};
  for (std::size_t i = first; i < length; ++i) {
    const core::Microseconds now{static_cast<std::int64_t>(i) * 1'000};
    std::array<core::AccelerometerSample, 2> samples{};
    for (std::size_t which = 0; which < 2; ++which) {
      samples[which] = {.time = now,
                        .specific_force_m_s2 = {readings.axial_m_s2[which][i], 0.0F, 0.0F},
                        .quality = readings.quality[which][i]};
    }
    if (detector.update(now, samples) == core::DetectionState::detected) {
      return true;
    }
  }
  return false;
}

// Of many more, through the detector alone: from the beginning, and from any sample on which the law may let it begin
// anew.
TEST(Paths, WhereTheScreenSaysThatNoRuleFiresNoneDoes) {
  const std::uint32_t seed = test::seed(7);
  std::mt19937 random{seed};
  std::vector<Rule> rules = rules_of({});
  rules.push_back(rules.front());
  rules.back().plan.launch_detection.accelerometers = core::AccelerometerRule::two_agree;
  rules.back().plan.launch_detection.single_allowed = true;
  const auto motion = std::make_unique<Motion>();
  const auto readings = std::make_unique<Readings>();
  std::size_t kept_out = 0;
  std::size_t kept_from_the_law = 0;
  std::size_t fired = 0;
  for (const Kind kind : events_that_are_no_launch()) {
    for (std::uint64_t event = 0; event < (is_flight(kind) ? 100U : 500U); ++event) {
      Streams streams = streams_of(seed, kind, event);
      make_event(kind, streams, *motion, false);
      begin_readings(kind, event, *motion, streams.axial, *readings);
      finish_readings(*motion, streams.axial, *readings);
      for (const Rule& rule : rules) {
        const Screened screen = screened(rule.plan, *motion, *readings);
        const bool does = fires(rule.plan, *readings, motion->length);
        ASSERT_TRUE(screen != Screened::quiet || !does) << info(kind).name << ' ' << event << ' ' << rule.name();
        kept_out += screen == Screened::quiet ? 1 : 0;
        fired += does ? 1 : 0;
        const auto rest = static_cast<std::size_t>(rule.plan.motion.rest_time / core::Microseconds{1'000});
        if (screen != Screened::law_decides && motion->length > rest) {
          ++kept_from_the_law;
          const std::size_t first = std::uniform_int_distribution<std::size_t>{rest, motion->length - 1}(random);
          ASSERT_FALSE(fires_from(rule.plan, *readings, first, motion->length))
              << info(kind).name << ' ' << event << ' ' << rule.name() << " from step " << first;
        }
      }
    }
  }
  EXPECT_GT(kept_out, 10'000U);
  EXPECT_GT(kept_from_the_law, 5'000U);
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
