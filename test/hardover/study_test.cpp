// SPDX-License-Identifier: MIT
#include "studies.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::hardover {
namespace {

// Upright and without wind the rocket is the same to all sides, so that it does not matter which canard it is, but for
// what the roll angle is at that moment, which only says to which side it goes.
TEST(Hardover, WithoutWindItDoesNotMatterWhichOfTheFourItIs) {
  const Study found = study({}, {.step_s = 3.0, .coupler_m = 0.8, .threads = 2});
  ASSERT_EQ(found.effects.size() % 8, 0U);
  EXPECT_EQ(found.instants, found.effects.size() / 8);
  ASSERT_GE(found.instants, 3U);
  for (std::size_t i = 0; i < found.effects.size(); ++i) {
    const Effect& of = found.effects[i];
    const Effect& first = found.effects[i % (2 * found.instants)];
    EXPECT_EQ(of.canard, i / (2 * found.instants));
    EXPECT_EQ(of.from_s, first.from_s);
    EXPECT_EQ(of.stop_rad, first.stop_rad);
    EXPECT_NEAR(of.side_force_n, first.side_force_n, 0.05 * first.side_force_n + 0.05) << i;
    EXPECT_NEAR(text::degrees(of.turned_rad), text::degrees(first.turned_rad), 2.0) << i;
  }
}

// To one side the canard works against the fin offset, which the others balance, and to the other with it.
TEST(Hardover, BothStopsAreFlownAndWorstIsTheWorseOfThem) {
  const Study found = study({}, {.step_s = 2.5, .coupler_m = {}, .threads = 2});
  Effect worst_of[2]{};
  for (const Effect& one : found.effects) {
    EXPECT_EQ(std::abs(one.stop_rad), found.stop_rad);
    Effect& worst = worst_of[one.stop_rad > 0.0 ? 1 : 0];
    worst.side_force_n = std::max(worst.side_force_n, one.side_force_n);
    worst.angle_of_attack_rad = std::max(worst.angle_of_attack_rad, one.angle_of_attack_rad);
    worst.rolled_rad = std::max(worst.rolled_rad, one.rolled_rad);
  }
  EXPECT_EQ(found.worst().side_force_n, std::max(worst_of[0].side_force_n, worst_of[1].side_force_n));
  EXPECT_EQ(found.worst().angle_of_attack_rad,
            std::max(worst_of[0].angle_of_attack_rad, worst_of[1].angle_of_attack_rad));
  EXPECT_EQ(found.worst().rolled_rad, std::max(worst_of[0].rolled_rad, worst_of[1].rolled_rad));
  // The offset of -4.9 degrees takes 19.6 of the 27 degrees that three canards have: what is left is less than 25, and
  // the rocket spins. The positive stop does their work, and more.
  EXPECT_GT(text::degrees(worst_of[0].rolled_rad), 360.0);
  EXPECT_LT(text::degrees(worst_of[1].rolled_rad), 30.0);
}

// At its stop of 25 degrees against three that stand at 9 at most: the sum across the axis is at most that of 25 + 9
// and 9 + 9 at right angles, and at least what is left when the opposite one stands at 9 the same way.
TEST(Hardover, TheSideForceIsThatOfTheDeflectionsThatTheStopAndThePlanLimitAllow) {
  const Study found = study({}, {.step_s = 2.0, .coupler_m = {}, .threads = 2});
  EXPECT_EQ(found.stop_rad, text::radians(25.0));
  for (const Effect& one : found.effects) {
    const double sum_deg = text::degrees(one.side_force_n / (one.pressure_pa * found.side_area_m2));
    EXPECT_GE(sum_deg, 25.0 - 9.0 - 0.5);
    EXPECT_LE(sum_deg, std::hypot(25.0 + 9.0, 9.0 + 9.0) + 0.5);
    EXPECT_EQ(one.moment_n_m, std::nullopt);
  }
}

TEST(Hardover, ACanardThatPushesToNoSideMovesNoApogee) {
  const Study found = study({"aerodynamics.canard_side_area_m2=0", "aerodynamics.canard_position_m=0.3"},
                            {.step_s = 4.0, .coupler_m = 0.8, .threads = 2});
  for (const Effect& one : found.effects) {
    EXPECT_EQ(one.side_force_n, 0.0);
    EXPECT_EQ(one.moment_n_m, 0.0);
    EXPECT_NEAR(one.away_m, 0.0, 1e-6);
    EXPECT_NEAR(one.apogee_m, found.sound_apogee_m, 1e-6);
  }
}

TEST(Hardover, TheBendingMomentIsTheForceTimesItsDistanceFromTheCoupler) {
  const Study found = study({}, {.step_s = 5.0, .coupler_m = 0.8, .threads = 2});
  for (const Effect& one : found.effects) {
    EXPECT_DOUBLE_EQ(one.moment_n_m.value(), one.side_force_n * (0.8 - found.position_m));
  }
  EXPECT_EQ(found.worst().moment_n_m.value(), found.worst().side_force_n * (0.8 - found.position_m));
}

TEST(Hardover, OfARocketFasterThanTheModelHoldsForSaysSoBeforeItsFigures) {
  const Options few{.step_s = 8.0, .coupler_m = {}, .threads = 2};
  const Study slow = study({}, few);
  EXPECT_TRUE(slow.beyond_model.empty());
  EXPECT_EQ(answer(slow).verdict.sentence.find("Mach"), std::string::npos);
  const Study fast = study({"motor.thrust_factor=1.2", "body.mass_kg=1.4", "body.drag_area_m2=0.001"}, few);
  EXPECT_NE(fast.beyond_model.find("Mach"), std::string::npos);
  EXPECT_LT(answer(fast).verdict.sentence.find(fast.beyond_model), answer(fast).verdict.sentence.find("canard"));
}

TEST(Hardover, InFrontOfTheCanardsNothingBendsAndOutsideOfTheRocketIsRefused) {
  EXPECT_EQ(study({}, {.step_s = 9.0, .coupler_m = 0.0, .threads = 2}).worst().moment_n_m, 0.0);
  for (const double outside_m : {-0.1, 9.0}) {
    try {
      (void)study({}, {.step_s = 9.0, .coupler_m = outside_m, .threads = 2});
      FAIL() << "it flew";
    } catch (const text::Error& error) {
      EXPECT_NE(std::string{error.what()}.find("allowed: 0 to 1."), std::string::npos) << error.what();
    }
  }
}

TEST(Hardover, SaysHowItWasMadeAndFromHowManyFlights) {
  Study found = study({"run.canard_fault=end_control"}, {.step_s = 5.0, .coupler_m = {}, .threads = 2});
  found.made = {.command = "fantail campaign hardover x --step 5", .version = "v9", .seed = {}, .changes = {"a.b=c"}};
  const std::string text = text_of(found);
  const std::string page = page_of(found);
  const std::string json = json_of(found);
  for (const std::string& all : {text, page, json}) {
    for (const char* const part :
         {"fantail campaign hardover x --step 5", "v9", "a.b=c", "tasha3_launch2", "end_control"}) {
      EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
    }
    EXPECT_EQ(all.find("ending moment"), std::string::npos) << "nobody asked for one\n" << all;
  }
  for (const std::string& read : {text, page}) {
    EXPECT_NE(read.find("16 flights"), std::string::npos) << read;
    EXPECT_NE(read.find("go to trim"), std::string::npos) << read;
  }
  EXPECT_NE(text.find("--step)"), std::string::npos) << "so few instants\n" << text;
  const std::string usual = text_of(study({}, {.step_s = 5.0, .coupler_m = 0.8, .threads = 2}));
  EXPECT_EQ(usual.find("go to trim"), std::string::npos) << usual;
  EXPECT_NE(usual.find("Bending moment"), std::string::npos) << usual;
}

// Across a wind of 30 m/s the rocket never comes to 20 m/s along its axis, sound or not: that is no angle of 0.
TEST(Hardover, OfARocketThatIsNeverFastItSaysSoInsteadOfAnAngleOfAttack) {
  const Study found = study({"wind.speed_m_s=30"}, {.step_s = 9.0, .coupler_m = {}, .threads = 1});
  EXPECT_EQ(found.sound_angle_of_attack_rad, std::nullopt);
  EXPECT_NE(text_of(found).find("never"), std::string::npos) << text_of(found);
  EXPECT_NE(json_of(found).find("\"sound_angle_of_attack_deg\": null"), std::string::npos);
  const Study calm = study({}, {.step_s = 9.0, .coupler_m = {}, .threads = 1});
  EXPECT_LT(calm.sound_angle_of_attack_rad.value(), text::radians(0.05));
  EXPECT_NE(text_of(calm).find("0.0 deg"), std::string::npos) << text_of(calm);
  EXPECT_EQ(text_of(calm).find("never"), std::string::npos) << text_of(calm);
}

/// Of the verdict at the top of the page.
TEST(Hardover, TheMapHasEveryApogeeWhereItIsOverGroundToTheSameScaleBothWays) {
  const Study found = study({"wind.speed_m_s=6"}, {.step_s = 5.0, .coupler_m = {}, .threads = 2});
  for (const Effect& one : found.effects) {
    EXPECT_NEAR(
        std::hypot(one.apogee_east_m - found.sound_apogee_east_m, one.apogee_north_m - found.sound_apogee_north_m),
        one.away_m, 1e-9);
  }
  // The wind of the shipped scenario comes from the north: the rocket turns into it.
  EXPECT_GT(found.sound_apogee_north_m, 30.0);
  EXPECT_NEAR(found.sound_apogee_east_m, 0.0, 10.0);
  const page::Chart map = apogee_map(found);
  std::size_t points = 0;
  for (const page::Series& series : map.series) {
    points += series.x.size();
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      EXPECT_TRUE(series.x[i] >= map.x_range->low && series.x[i] <= map.x_range->high) << series.name;
      EXPECT_TRUE(series.y[i] >= map.y_range->low && series.y[i] <= map.y_range->high) << series.name;
    }
  }
  EXPECT_EQ(points, found.effects.size() + 2) << "the healthy rocket and the guide, too";
  EXPECT_NEAR(map.x_range->high - map.x_range->low, map.y_range->high - map.y_range->low, 1e-9);
}

TEST(Hardover, TheHeadlineIsTwoSentencesAndThePageSaysWhatItsWordsMeanAndWhichStopACurveIs) {
  const Study found = study({}, {.step_s = 5.0, .coupler_m = 0.8, .threads = 2});
  const std::string page = page_of(found);
  const std::string verdict = answer(found).verdict.sentence;
  std::size_t sentences = 0;
  for (std::size_t at = 0; (at = verdict.find(". ", at)) != std::string::npos; ++at) {
    ++sentences;
  }
  EXPECT_EQ(sentences, 1U) << verdict;
  EXPECT_LT(verdict.size(), 230U) << verdict;
  for (const char* const part : {"Path deflection: ", "Roll change: ", "Apogee shift: ", "stop at +25 deg",
                                 "stop at \u221225 deg", "bending moment"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  const std::string cut =
      page_of(study({}, {.failure = Failure::cut_pulses, .step_s = 5.0, .coupler_m = {}, .threads = 2}));
  EXPECT_EQ(cut.find("stop at"), std::string::npos);
}

TEST(Hardover, SaysThatItsRowsClearNoRange) {
  const Study found = study({}, {.step_s = 9.0, .coupler_m = {}, .threads = 2});
  const std::vector<std::string> not_in_it = answer(found).verdict.not_in_it;
  ASSERT_EQ(not_in_it.size(), 1U);
  for (const char* const word : {"healthy rocket", "guide", "wind", "do not clear a range", "parachute"}) {
    EXPECT_NE(not_in_it[0].find(word), std::string::npos) << word;
  }
  EXPECT_NE(text_of(found).find(not_in_it[0]), std::string::npos) << text_of(found);
  EXPECT_NE(page_of(found).find(not_in_it[0].substr(not_in_it[0].find(" and not"))), std::string::npos);
}

TEST(Hardover, EarlyItTurnsTheWayMoreThanLate) {
  const Study found = study({}, {.step_s = 4.0, .coupler_m = {}, .threads = 2});
  EXPECT_GT(found.effects[0].away_m, 2.0 * found.effects[found.instants - 1].away_m);
  EXPECT_GT(found.effects[0].away_m, 1.0);
}

// A servo of 600 deg/s turns by 12 degrees in 20 ms and for the time of a frame more, and lift grows with the angle:
// less than that of a stop at 25 degrees, and the rocket is back on its way.
TEST(Hardover, CutPulsesTurnTheRocketByLittle) {
  const Study cut = study({}, {.failure = Failure::cut_pulses, .step_s = 2.0, .coupler_m = {}, .threads = 2});
  EXPECT_EQ(cut.effects.size(), 4 * cut.instants);
  for (const Effect& one : cut.effects) {
    EXPECT_EQ(one.stop_rad, 0.0);
    if (one.side_force_n > 0.0) {
      EXPECT_LE(text::degrees(one.side_force_n / (one.pressure_pa * cut.side_area_m2)), 600.0 * (cut_s + 0.01));
    }
    EXPECT_LT(one.away_m, 10.0) << one.from_s;
  }
  EXPECT_GT(cut.worst().side_force_n, 0.01);
}

TEST(Hardover, TheResultsDoNotDependOnTheNumberOfThreads) {
  const Options one{.step_s = 5.0, .coupler_m = 0.8, .threads = 1};
  const Options three{.step_s = 5.0, .coupler_m = 0.8, .threads = 3};
  EXPECT_EQ(json_of(study({}, one)), json_of(study({}, three)));
}

TEST(Hardover, AVehicleThatDoesNotSayWhatItsCanardsDoToTheSideIsRefused) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.geometry.reset();
  try {
    (void)fly(scenario, {}, [](std::size_t, std::size_t) {});
    FAIL() << "it flew";
  } catch (const text::Error& error) {
    EXPECT_NE(std::string{error.what()}.find("canard_side_area_m2"), std::string::npos) << error.what();
  }
  scenario.surroundings = sim::Surroundings::tunnel;
  EXPECT_THROW((void)fly(scenario, {}, [](std::size_t, std::size_t) {}), text::Error);
  scenario.surroundings = sim::Surroundings::flight;
  scenario.vehicle.airframe.reset();
  EXPECT_THROW((void)fly(scenario, {}, [](std::size_t, std::size_t) {}), text::Error);
}

}  // namespace
}  // namespace fantail::hardover
