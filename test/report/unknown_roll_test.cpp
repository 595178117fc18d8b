// SPDX-License-Identifier: MIT

#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

/// A roll that stayed within 0.0 deg where it is known, and is not judged; then these numbers.
void expect_not_judged(const Verdict& v, const Numbers& times) {
  EXPECT_EQ(v.outcome, Outcome::not_judged) << v.text;
  EXPECT_FALSE(v.roll_is_judged) << v.text;
  Numbers all{"0.0", "0.0", "4.0"};
  all.insert(all.end(), times.begin(), times.end());
  EXPECT_EQ(numbers(v), all) << v.text;
}

/// The last sentence names this as missing.
bool misses(const Verdict& v, const char* word) {
  return v.text.substr(v.text.rfind(". ")).find(word) != std::string::npos;
}

/// Control ends at 4 s, apogee is at 4.2 s.
flight::Flight flight_without(const std::function<bool(double)>& is_missing) {
  SyntheticFlight synthetic;
  synthetic.end_control(4.0, core::PhaseReason::apogee);
  synthetic.flight.events.apogee_s = 4.2;
  std::erase_if(synthetic.flight.rows, [&](const flight::Row& row) { return is_missing(row.time_s); });
  return synthetic.flight;
}

Verdict verdict_of(const flight::Flight& flight) { return verdict(flight, figures(flight)); }

TEST(UnknownRoll, AHoleUnderControlIsNamedAndNothingIsCalledHeld) {
  const Verdict v = verdict_of(flight_without([](double time_s) { return time_s > 2.0 && time_s < 3.0; }));
  expect_not_judged(v, {"2.00", "3.00"});
  EXPECT_FALSE(says(v, "hold error")) << v.text;
}

TEST(UnknownRoll, AHoleThatTookTheEndOfControlWithItIsOneUnderControl) {
  expect_not_judged(verdict_of(flight_without([](double time_s) { return time_s > 3.5 && time_s < 4.1; })),
                    {"3.50", "4.10"});
}

TEST(UnknownRoll, ATableThatIsCutSaysBeforeWhat) {
  expect_not_judged(verdict_of(flight_without([](double time_s) { return time_s > 3.0; })), {"3.00", "4.00"});
  expect_not_judged(verdict_of(flight_without([](double time_s) { return time_s < 1.9995; })), {"2.00", "0.60"});
}

TEST(UnknownRoll, OutsideOfControlTheyAreNamedAndTheRollIsJudged) {
  const Verdict pad = verdict_of(flight_without([](double time_s) { return time_s > -0.4 && time_s < 0.5; }));
  EXPECT_EQ(pad.outcome, Outcome::held);
  EXPECT_EQ(numbers(pad), (Numbers{"10.0", "0.0", "0.0", "4.0", "-0.40", "0.50"})) << pad.text;
  flight::Flight after = flight_without([](double time_s) { return time_s > 4.05; });
  EXPECT_EQ(verdict_of(after).outcome, Outcome::held);
  after.events.apogee_s = 4.3;
  EXPECT_EQ(numbers(verdict_of(after)), (Numbers{"10.0", "0.0", "0.0", "4.0", "4.05", "4.30"}));
  EXPECT_TRUE(says(verdict_of(after), "apogee"));
}

TEST(UnknownRoll, SeveralHolesAreCounted) {
  const Verdict v = verdict_of(flight_without(
      [](double time_s) { return (time_s > 1.0 && time_s < 1.3) || (time_s > 2.0 && time_s < 2.3) || time_s > 4.4; }));
  expect_not_judged(v, {"1.00", "1.30", "1"});
}

TEST(UnknownRoll, OfAResetAreNoDoubtOfTheirOwn) {
  flight::Flight flight = flight_without([](double time_s) { return time_s > 2.0 && time_s < 2.3; });
  flight.outages = {{.from_s = 2.0, .to_s = 2.3, .cause = "watchdog", .resumed = true}};
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(numbers(v), (Numbers{"10.0", "0.0", "0.0", "4.0", "2.000", "2.300"})) << v.text;
}

TEST(UnknownRoll, OfARecordThatEndsUnderControlNobodyKnowsTheRest) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s.reset();
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_EQ(numbers(v), (Numbers{"4.50", "10.0", "0.0", "0.0", "4.0"})) << v.text;
  EXPECT_TRUE(says(v, "record")) << v.text;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->speed_m_s = 22.0;
  }
  synthetic.flight.tunnel = true;
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::cut_short);
}

TEST(UnknownRoll, OfCellsWithoutANumberIsAHoleAndNoErrorOfZero) {
  SyntheticFlight synthetic;
  synthetic.end_control(4.0, core::PhaseReason::apogee);
  synthetic.flight.events.apogee_s = 4.2;
  flight::Flight part = synthetic.flight;
  const auto forget = [](flight::Flight& flight, double from_s, double to_s) {
    for (flight::Row& row : flight.rows) {
      if (row.time_s > from_s && row.time_s < to_s) {
        row.roll_angle_rad = std::nan("");
        row.truth->roll_angle_rad = std::nan("");
      }
    }
  };
  forget(part, 2.0, 3.0);
  expect_not_judged(verdict_of(part), {"2.00", "3.00"});
  flight::Flight whole = synthetic.flight;
  forget(whole, 0.5, 9.0);
  EXPECT_EQ(verdict_of(whole).outcome, Outcome::not_judged);
  EXPECT_FALSE(figures(whole).largest_hold_error_rad || figures(whole).roll_after_end_rad);
}

TEST(UnknownRoll, InATableWithARowASecondIsNotJudged) {
  const Verdict v = verdict_of(flight_without([](double time_s) {
    const double steps = time_s / 0.5;
    return std::abs(steps - std::round(steps)) > 1e-6;
  }));
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v).back(), "0.5") << v.text;
}

// A tenth of a second is a fast swing at its worst, or missed.
TEST(UnknownRoll, InATableOfTenRowsASecondIsJudgedWithAReservation) {
  const auto every = [](double step_s) {
    return verdict_of(flight_without([step_s](double time_s) {
      const double steps = time_s / step_s;
      return std::abs(steps - std::round(steps)) > 1e-6;
    }));
  };
  EXPECT_EQ(every(0.1).outcome, Outcome::held);
  EXPECT_EQ(numbers(every(0.1)), (Numbers{"10.0", "0.0", "0.0", "4.0", "0.1"})) << every(0.1).text;
  EXPECT_EQ(numbers(every(0.05)), (Numbers{"10.0", "0.0", "0.0", "4.0"})) << every(0.05).text;
}

TEST(UnknownRoll, OfARecordThatBeginsUnderControlNobodyKnowsSinceWhen) {
  flight::Flight flight = flight_without([](double time_s) { return time_s < 1.9995; });
  flight.events.control_start_s.reset();
  expect_not_judged(verdict_of(flight), {});
  EXPECT_TRUE(says(verdict_of(flight), "record"));
}

TEST(UnknownRoll, OfARecordWithoutATickUnderControlThatIsNoWantOfControl) {
  const Verdict v = verdict_of(flight_without([](double time_s) { return time_s > 0.4; }));
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v), (Numbers{"0.40", "4.00"})) << v.text;
  EXPECT_TRUE(says(v, "tick")) << v.text;
}

// The rocket goes back and forth with a reference that steps in the hole, and steps back behind it.
TEST(UnknownRoll, BehindAHoleTheRocketIsGivenTimeToSettleAgain) {
  SyntheticFlight synthetic;
  for (flight::Row& row : synthetic.flight.rows) {
    if (row.time_s > 2.5 && row.time_s < 3.0) {
      row.reference_rad = text::radians(45.0);
    }
    if (row.time_s > 2.5 && row.time_s < 3.9) {
      row.roll_angle_rad = row.truth->roll_angle_rad = text::radians(30.0);
    }
  }
  std::erase_if(synthetic.flight.rows, [](const flight::Row& row) { return row.time_s > 2.2 && row.time_s < 3.1; });
  EXPECT_EQ(verdict_of(synthetic.flight).outcome, Outcome::not_judged);
}

// What the truth counts from the pad, the law counts from detection.
TEST(UnknownRoll, WithoutTheTickOfDetectionTheRocketsOwnAngleIsJudged) {
  SyntheticFlight synthetic;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->roll_angle_rad += text::radians(row.time_s < 0.3 ? 20.0 : 20.0 + row.time_s);
  }
  EXPECT_NEAR(text::degrees(*figures(synthetic.flight).largest_hold_error_rad), 4.5, 1e-6);
  std::erase_if(synthetic.flight.rows, [](const flight::Row& row) { return row.time_s < 0.4; });
  EXPECT_NEAR(text::degrees(*figures(synthetic.flight).largest_hold_error_rad), 0.0, 1e-6);
}

/// From 2 s to 3 s the rocket is 60 degrees away, and what it is compared with is not known.
flight::Flight flight_that_forgets(const std::function<void(flight::Row&)>& forget) {
  flight::Flight flight = flight_without([](double) { return false; });
  for (flight::Row& row : flight.rows) {
    if (row.time_s > 2.0 && row.time_s < 3.0) {
      row.roll_angle_rad = row.truth->roll_angle_rad = text::radians(50.0);
      forget(row);
    }
  }
  return flight;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

TEST(UnknownHold, NothingIsCalledHeldWhileItsReferenceIsNotKnown) {
  const Verdict v = verdict_of(flight_that_forgets([](flight::Row& row) { row.reference_rad = unknown; }));
  expect_not_judged(v, {"2.00", "3.00"});
  EXPECT_TRUE(says(v, "hold error") && misses(v, "reference")) << v.text;
}

TEST(UnknownHold, NorWhileTheFinOffsetIsNotKnown) {
  const Verdict v = verdict_of(flight_that_forgets([](flight::Row& row) { row.truth->disturbance_rad = unknown; }));
  expect_not_judged(v, {"2.00", "3.00"});
  EXPECT_TRUE(misses(v, "fin offset")) << v.text;
}

TEST(UnknownHold, NorWhileASpeedThatTheGainsGoByIsNotKnown) {
  const auto forget = [](flight::Row& row) { row.speed_m_s = unknown; };
  flight::Flight flight = flight_that_forgets(forget);
  EXPECT_EQ(verdict_of(flight).outcome, Outcome::not_held);  // these gains go by nothing
  flight.plan.gain_schedule.speeds_count = 1;
  flight.plan.gain_schedule.factors[0] = 1.0F;
  const Verdict v = verdict_of(flight);
  expect_not_judged(v, {"2.00", "3.00"});
  EXPECT_TRUE(misses(v, "speed")) << v.text;
  flight.unmeasured.speed_bound_from_s = 0.0;  // the last row of the schedule counts, whatever the speed
  EXPECT_EQ(verdict_of(flight).outcome, Outcome::not_held);
}

TEST(UnknownHold, NorWithoutTheTickOfDetectionWhileTheRocketsOwnAngleIsNotKnown) {
  flight::Flight flight = flight_that_forgets([](flight::Row& row) { row.roll_angle_rad = unknown; });
  std::erase_if(flight.rows, [](const flight::Row& row) { return row.time_s < 0.4; });
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_TRUE(misses(v, "roll angle")) << v.text;
}

TEST(UnknownHold, NorBeforeItIsKnownOrBehindThatOrBetweenRowsThatKnowIt) {
  const auto times = [](const std::function<bool(double)>& is_missing) {
    flight::Flight flight = flight_without([](double) { return false; });
    for (flight::Row& row : flight.rows) {
      row.reference_rad = is_missing(row.time_s) ? unknown : 0.0;
    }
    const Verdict v = verdict_of(flight);
    EXPECT_EQ(v.outcome, Outcome::not_judged) << v.text;
    EXPECT_TRUE(misses(v, "reference")) << v.text;
    const Numbers all = numbers(v);
    return Numbers{all.begin() + std::min<std::ptrdiff_t>(3, std::ssize(all)), all.end()};
  };
  EXPECT_EQ(times([](double time_s) { return time_s < 1.0; }), (Numbers{"1.00", "0.60"}));
  EXPECT_EQ(times([](double time_s) { return time_s > 3.0; }), (Numbers{"3.00", "4.00"}));
  EXPECT_EQ(times([](double time_s) { return std::fmod(time_s, 0.25) > 0.0015; }).at(2), "11") << "more gaps";
  EXPECT_EQ(verdict_of(flight_without([](double) { return false; })).outcome, Outcome::held);
}

TEST(UnknownHold, OfAFlightWhoseReferenceIsNeverKnownThatIsTheReason) {
  flight::Flight flight = flight_without([](double) { return false; });
  for (flight::Row& row : flight.rows) {
    row.reference_rad = unknown;
  }
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(numbers(v), Numbers{"0.0"});
  EXPECT_TRUE(says(v, "reference") && !says(v, "offset")) << v.text;
}

}  // namespace
}  // namespace fantail::report
