// SPDX-License-Identifier: MIT
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

const std::string stayed =
    "Roll not judged: ticks under control are missing; in the others it stayed within 0.0 deg of where this law "
    "settles; canards at their limit 0.0 % of control time, 4.0 deg to spare against the fin offset.";

/// Control ends at 4 s, apogee is at 4.2 s.
flight::Flight flight_without(const std::function<bool(double)>& is_missing) {
  SyntheticFlight synthetic;
  synthetic.end_control(4.0, core::PhaseReason::apogee);
  synthetic.flight.events.apogee_s = 4.2;
  std::erase_if(synthetic.flight.rows, [&](const flight::Row& row) { return is_missing(row.time_s); });
  return synthetic.flight;
}

Verdict verdict_of(const flight::Flight& flight) { return verdict(flight, figures(flight)); }

TEST(MissingTicks, AHoleUnderControlIsNamedAndNothingIsCalledHeld) {
  const Verdict v = verdict_of(flight_without([](double time_s) { return time_s > 2.0 && time_s < 3.0; }));
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_FALSE(v.roll_is_judged);
  EXPECT_EQ(v.text, stayed + " No tick is on record from 2.00 s to 3.00 s.");
}

TEST(MissingTicks, AHoleThatTookTheEndOfControlWithItIsOneUnderControl) {
  EXPECT_EQ(verdict_of(flight_without([](double time_s) { return time_s > 3.5 && time_s < 4.1; })).text,
            stayed + " No tick is on record from 3.50 s to 4.10 s.");
}

TEST(MissingTicks, ATableThatIsCutSaysBeforeWhat) {
  EXPECT_EQ(verdict_of(flight_without([](double time_s) { return time_s > 3.0; })).text,
            stayed + " The record ends at 3.00 s, before control ended at 4.00 s.");
  EXPECT_EQ(verdict_of(flight_without([](double time_s) { return time_s < 1.9995; })).text,
            stayed + " The record begins at 2.00 s, after control started at 0.60 s.");
}

TEST(MissingTicks, OutsideOfControlTheyAreNamedAndTheRollIsJudged) {
  const Verdict pad = verdict_of(flight_without([](double time_s) { return time_s > -0.4 && time_s < 0.5; }));
  EXPECT_EQ(pad.outcome, Outcome::held);
  EXPECT_NE(pad.text.find("fin offset. No tick is on record from -0.40 s to 0.50 s."), std::string::npos) << pad.text;
  flight::Flight after = flight_without([](double time_s) { return time_s > 4.05; });
  EXPECT_EQ(verdict_of(after).outcome, Outcome::held);
  after.events.apogee_s = 4.3;
  EXPECT_NE(verdict_of(after).text.find(" The record ends at 4.05 s, before apogee at 4.30 s."), std::string::npos);
}

TEST(MissingTicks, SeveralHolesAreCounted) {
  const Verdict v = verdict_of(flight_without(
      [](double time_s) { return (time_s > 1.0 && time_s < 1.3) || (time_s > 2.0 && time_s < 2.3) || time_s > 4.4; }));
  EXPECT_EQ(v.text, stayed + " No tick is on record from 1.00 s to 1.30 s, nor in 1 more gap.");
}

TEST(MissingTicks, OfAResetAreNoDoubtOfTheirOwn) {
  flight::Flight flight = flight_without([](double time_s) { return time_s > 2.0 && time_s < 2.3; });
  flight.outages = {{.from_s = 2.0, .to_s = 2.3, .cause = "watchdog", .resumed = true}};
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(v.text.find("No tick is on record"), std::string::npos) << v.text;
}

TEST(MissingTicks, OfARecordThatEndsUnderControlNobodyKnowsTheRest) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s.reset();
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_EQ(v.text.rfind("Until the record ends at 4.50 s, under control: roll stayed within 0.0 deg", 0), 0U);
  synthetic.flight.tunnel = true;  // where somebody ends the run
  EXPECT_EQ(verdict_of(synthetic.flight).text.find("record ends"), std::string::npos);
}

}  // namespace
}  // namespace fantail::report
