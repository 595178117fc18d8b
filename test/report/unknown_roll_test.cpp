// SPDX-License-Identifier: MIT

#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

const std::string stayed =
    "Roll not judged: the roll is not known at all times under control; where it is, the roll stayed within 0.0 deg of "
    "where this law settles; canards at their limit 0.0 % of control time, 4.0 deg to spare against the fin offset.";

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
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_FALSE(v.roll_is_judged);
  EXPECT_EQ(v.text, stayed + " The roll is not known from 2.00 s to 3.00 s.");
}

TEST(UnknownRoll, AHoleThatTookTheEndOfControlWithItIsOneUnderControl) {
  EXPECT_EQ(verdict_of(flight_without([](double time_s) { return time_s > 3.5 && time_s < 4.1; })).text,
            stayed + " The roll is not known from 3.50 s to 4.10 s.");
}

TEST(UnknownRoll, ATableThatIsCutSaysBeforeWhat) {
  EXPECT_EQ(verdict_of(flight_without([](double time_s) { return time_s > 3.0; })).text,
            stayed + " The roll is known only until 3.00 s, and control ended at 4.00 s.");
  EXPECT_EQ(verdict_of(flight_without([](double time_s) { return time_s < 1.9995; })).text,
            stayed + " The roll is known only from 2.00 s on, and control started at 0.60 s.");
}

TEST(UnknownRoll, OutsideOfControlTheyAreNamedAndTheRollIsJudged) {
  const Verdict pad = verdict_of(flight_without([](double time_s) { return time_s > -0.4 && time_s < 0.5; }));
  EXPECT_EQ(pad.outcome, Outcome::held);
  EXPECT_NE(pad.text.find("fin offset. The roll is not known from -0.40 s to 0.50 s."), std::string::npos) << pad.text;
  flight::Flight after = flight_without([](double time_s) { return time_s > 4.05; });
  EXPECT_EQ(verdict_of(after).outcome, Outcome::held);
  after.events.apogee_s = 4.3;
  EXPECT_NE(verdict_of(after).text.find(" The roll is known only until 4.05 s, and apogee was at 4.30 s."),
            std::string::npos);
}

TEST(UnknownRoll, SeveralHolesAreCounted) {
  const Verdict v = verdict_of(flight_without(
      [](double time_s) { return (time_s > 1.0 && time_s < 1.3) || (time_s > 2.0 && time_s < 2.3) || time_s > 4.4; }));
  EXPECT_EQ(v.text, stayed + " The roll is not known from 1.00 s to 1.30 s, nor in 1 more gap.");
}

TEST(UnknownRoll, OfAResetAreNoDoubtOfTheirOwn) {
  flight::Flight flight = flight_without([](double time_s) { return time_s > 2.0 && time_s < 2.3; });
  flight.outages = {{.from_s = 2.0, .to_s = 2.3, .cause = "watchdog", .resumed = true}};
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::held);
  EXPECT_EQ(v.text.find("is not known"), std::string::npos) << v.text;
}

TEST(UnknownRoll, OfARecordThatEndsUnderControlNobodyKnowsTheRest) {
  SyntheticFlight synthetic;
  synthetic.flight.events.apogee_s.reset();
  const Verdict v = verdict_of(synthetic.flight);
  EXPECT_EQ(v.outcome, Outcome::cut_short);
  EXPECT_EQ(v.text.rfind("Until the record ends at 4.50 s, under control: steady, 10.0 deg from the command: ", 0), 0U);
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
  EXPECT_EQ(verdict_of(part).text, stayed + " The roll is not known from 2.00 s to 3.00 s.");
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
  EXPECT_NE(v.text.find(" The roll is known only every 0.5 s."), std::string::npos) << v.text;
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
  EXPECT_NE(every(0.1).text.find(" The roll is known every 0.1 s, and may have been farther off in between."),
            std::string::npos)
      << every(0.1).text;
  EXPECT_EQ(every(0.05).text.find("known every"), std::string::npos) << every(0.05).text;
}

TEST(UnknownRoll, OfARecordThatBeginsUnderControlNobodyKnowsSinceWhen) {
  flight::Flight flight = flight_without([](double time_s) { return time_s < 1.9995; });
  flight.events.control_start_s.reset();
  EXPECT_EQ(verdict_of(flight).text, stayed + " The record begins under control.");
}

TEST(UnknownRoll, OfARecordWithoutATickUnderControlThatIsNoWantOfControl) {
  const Verdict v = verdict_of(flight_without([](double time_s) { return time_s > 0.4; }));
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_EQ(v.text,
            "Roll not judged: no tick under control is on record. The roll is known only until 0.40 s, and control "
            "ended at 4.00 s.");
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
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_FALSE(v.roll_is_judged);
  EXPECT_EQ(v.text,
            "Roll not judged: the hold error is not known at all times under control; where it is, the roll stayed "
            "within 0.0 deg of where this law settles; canards at their limit 0.0 % of control time, 4.0 deg to spare "
            "against the fin offset. The hold error is not known from 2.00 s to 3.00 s: the reference is missing.");
}

TEST(UnknownHold, NorWhileTheFinOffsetIsNotKnown) {
  const Verdict v = verdict_of(flight_that_forgets([](flight::Row& row) { row.truth->disturbance_rad = unknown; }));
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_NE(v.text.find(" The hold error is not known from 2.00 s to 3.00 s: the fin offset is missing."),
            std::string::npos)
      << v.text;
}

TEST(UnknownHold, NorWhileASpeedThatTheGainsGoByIsNotKnown) {
  const auto forget = [](flight::Row& row) { row.speed_m_s = unknown; };
  flight::Flight flight = flight_that_forgets(forget);
  EXPECT_EQ(verdict_of(flight).outcome, Outcome::not_held);  // these gains go by nothing
  flight.plan.gain_schedule.speeds_count = 1;
  flight.plan.gain_schedule.factors[0] = 1.0F;
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_NE(v.text.find(" from 2.00 s to 3.00 s: the speed is missing."), std::string::npos) << v.text;
  flight.unmeasured.speed_bound_from_s = 0.0;  // the last row of the schedule counts, whatever the speed
  EXPECT_EQ(verdict_of(flight).outcome, Outcome::not_held);
}

TEST(UnknownHold, NorWithoutTheTickOfDetectionWhileTheRocketsOwnAngleIsNotKnown) {
  flight::Flight flight = flight_that_forgets([](flight::Row& row) { row.roll_angle_rad = unknown; });
  std::erase_if(flight.rows, [](const flight::Row& row) { return row.time_s < 0.4; });
  const Verdict v = verdict_of(flight);
  EXPECT_EQ(v.outcome, Outcome::not_judged);
  EXPECT_NE(v.text.find(": the measured roll angle is missing."), std::string::npos) << v.text;
}

TEST(UnknownHold, NorBeforeItIsKnownOrBehindThatOrBetweenRowsThatKnowIt) {
  const auto said = [](const std::function<bool(double)>& is_missing) {
    flight::Flight flight = flight_without([](double) { return false; });
    for (flight::Row& row : flight.rows) {
      row.reference_rad = is_missing(row.time_s) ? unknown : 0.0;
    }
    const Verdict v = verdict_of(flight);
    EXPECT_EQ(v.outcome, Outcome::not_judged) << v.text;
    return v.text.substr(v.text.find("fin offset.") + 11);
  };
  EXPECT_EQ(
      said([](double time_s) { return time_s < 1.0; }),
      " The hold error is known only from 1.00 s on, and the record shows control from 0.60 s on: the reference is "
      "missing.");
  EXPECT_EQ(said([](double time_s) { return time_s > 3.0; }),
            " The hold error is known only until 3.00 s, and the record shows control until 4.00 s: the reference is "
            "missing.");
  EXPECT_NE(said([](double time_s) { return std::fmod(time_s, 0.25) > 0.0015; }).find("nor in 11 more gaps: the refer"),
            std::string::npos);
  EXPECT_EQ(verdict_of(flight_without([](double) { return false; })).outcome, Outcome::held);
}

TEST(UnknownHold, OfAFlightWhoseReferenceIsNeverKnownThatIsTheReason) {
  flight::Flight flight = flight_without([](double) { return false; });
  for (flight::Row& row : flight.rows) {
    row.reference_rad = unknown;
  }
  EXPECT_EQ(verdict_of(flight).text,
            "Roll not judged: the reference, and with it where roll should settle, is unknown; canards at their limit "
            "0.0 % of control time.");
}

}  // namespace
}  // namespace fantail::report
