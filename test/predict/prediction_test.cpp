// SPDX-License-Identifier: MIT
#include "predict/prediction.hpp"

#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "json/value.hpp"
#include "look_away.hpp"
#include "predict/answer.hpp"
#include "predict/sentences.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
Prediction predicted(const std::string& scenario_name, const Options& options) {
  const sim::Scenario scenario = input::load_scenario(scenario_name, {});
  return predict(scenario, read_tunnel_result(scenario.tunnel_result.value(), {}), options, look_away);
}

TEST(Prediction, OfTheFirstLaunchIsNoGoBecauseOfItsOffset) {
  const Prediction p = predicted("tasha3_launch1", {.runs = 12});
  SCOPED_TRACE("seed " + std::to_string(p.seed));
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(d.criteria.at(0).key, "authority");
  EXPECT_EQ(d.criteria.at(0).judgement, Judgement::not_met);
  const Numbers offset_and_limit = figures(d.criteria.at(0).clause);
  ASSERT_EQ(offset_and_limit.size(), 2U) << d.text;  // in all runs
  EXPECT_NEAR(std::stod(offset_and_limit[0]), 7.15, 0.2);
  EXPECT_EQ(offset_and_limit[1], "6");
  EXPECT_EQ(p.authority.count, 0U);
  EXPECT_EQ(p.held.count, 0U);
  EXPECT_EQ(p.held.of, 12U);
  // Limit 6 less 7.15, the middle of 7.0 to 7.3.
  EXPECT_NEAR(degrees(p.authority_margin_rad.mean), -1.15, 0.2);
  EXPECT_FALSE(p.settle_rad);
  EXPECT_GT(p.spin_rate_rad_s->p5, 0.0);
}

// Published dampings and torques with the assumed airframe: k alpha / beta is 0.09 * 7.5 / 10 to 0.09 * 8.5 / 10,
// or 3.9 to 4.4 degrees, and the offset of 7 degrees is beyond it.
TEST(Prediction, OfTheFirstLaunchWarnsOfRollResonanceInTextJsonAndPage) {
  const Prediction p = predicted("tasha3_launch1", {.runs = 4});
  const Decision d = decide(p, {});
  ASSERT_TRUE(p.resonance);
  EXPECT_NEAR(degrees(p.resonance->resonant_rad.p50), 4.1, 0.7);
  EXPECT_EQ(p.resonance->past, 4U);
  // Each end of the range is that of a frequency, beside the spread of the runs.
  const double frequencies = p.resonance->most_frequency_1_m / p.resonance->least_frequency_1_m;
  EXPECT_GE(p.resonance->resonant_rad.p95 / p.resonance->resonant_rad.p5, frequencies);
  const json::Value json = json::parse(result::json(answer(p, d, {})));
  EXPECT_EQ(json["roll_resonance"]["past_runs"].number(), 4.0);
  ASSERT_EQ(json["not_in_verdict"].size(), 1U);
  const std::string in_short = json["not_in_verdict"][0].text();
  EXPECT_EQ(figures(in_short).at(1), "4");
  EXPECT_EQ(figures(in_short).at(2), "4");
  // In short right below the verdict, before what is asked for, and at length further down.
  const std::string said = result::text(answer(p, d, {}));
  EXPECT_LT(said.find(in_short), said.find("Requirements:")) << said;
  EXPECT_NE(said.find("Roll resonance: "), std::string::npos);
  const std::string page = result::html(answer(p, d, {}));
  EXPECT_NE(page.find(in_short), std::string::npos);
  EXPECT_NE(page.find("Roll resonance: "), std::string::npos);
}

// 80 runs are the fewest round number that can promise 95 %.
TEST(Prediction, OfTheSecondLaunchIsGo) {
  const Prediction p = predicted("tasha3_launch2", {.runs = 80});
  SCOPED_TRACE("seed " + std::to_string(p.seed));
  const Decision d = decide(p, {});
  EXPECT_TRUE(d.go) << d.text;
  EXPECT_EQ(d.heading(), "Go with caution");
  EXPECT_TRUE(d.text.starts_with("Go with caution: ")) << d.text;
  // Published: the flight came to an offset of -4.9 and -4.7 degrees; the band of the prediction must have it inside.
  EXPECT_LT(degrees(p.offset_size_rad.p5), 4.7);
  EXPECT_GT(degrees(p.offset_size_rad.p95), 4.9);
  EXPECT_FALSE(p.spin_rate_rad_s);
  ASSERT_TRUE(p.settle_rad);
  EXPECT_NEAR(degrees(p.settle_rad->mean), -20.0 - 4.62 / 0.5, 1.0);
  const std::string said = result::text(answer(p, d, {}));
  EXPECT_NE(said.find("  its reference then"), std::string::npos) << said;
  EXPECT_NEAR(degrees(p.settle_off_rad.value().p50), degrees(p.offset_size_rad.p50) / 0.5, 0.5);
}

TEST(Prediction, IsTheSameForAnyNumberOfThreads) {
  const Prediction one = predicted("tasha3_launch2", {.runs = 8, .threads = 1});
  const Prediction two = predicted("tasha3_launch2", {.runs = 8, .threads = 2});
  const result::Document first = answer(one, decide(one, {}), {});
  const result::Document second = answer(two, decide(two, {}), {});
  ASSERT_EQ(first.spreadsheets.size(), 2U);
  EXPECT_EQ(result::csv(first.spreadsheets[0]), result::csv(second.spreadsheets[0]));
  EXPECT_EQ(result::csv(first.spreadsheets[1]), result::csv(second.spreadsheets[1]));
  EXPECT_EQ(result::json(first), result::json(second));
}

TEST(Prediction, ARunIsTheSameHoweverManyThereAre) {
  const Prediction few = predicted("tasha3_launch2", {.runs = 2});
  const Prediction more = predicted("tasha3_launch2", {.runs = 5});
  for (std::size_t i = 0; i < few.runs.size(); ++i) {
    EXPECT_EQ(few.runs[i].seed, more.runs[i].seed);
    EXPECT_EQ(few.runs[i].roll_angle_rad, more.runs[i].roll_angle_rad);
  }
}

TEST(Prediction, SaysWhatTheJsonReaderNeedsAndThatInDegrees) {
  const Prediction p = predicted("tasha3_launch1", {.runs = 4});
  const json::Value all = json::parse(result::json(answer(p, decide(p, {}), {.version = "1.2.3"})));
  EXPECT_EQ(all["go"], false);
  EXPECT_EQ(all["answer"], "no");
  EXPECT_EQ(all["sentence"], all["verdict"]);
  EXPECT_EQ(all["seed"], 1);
  EXPECT_EQ(all["runs"], 4);
  EXPECT_EQ(all["version"], "1.2.3");
  EXPECT_NEAR(all["canard_limit_deg"].number(), 6.0, 1e-5);
  EXPECT_EQ(all["authority"]["share"], 0.0);
  EXPECT_TRUE(all["settle_deg"].is_null());
  EXPECT_EQ(all["criteria"].size(), 3U);
  EXPECT_EQ(all["tunnel"]["file"], "tasha3_launch1_flight.csv");
  EXPECT_GT(all["stability"]["over_speed"].size(), 10U);
}

TEST(Prediction, AServoThatWasMeasuredTakesThePlaceOfTheVehicles) {
  const Prediction usual = predicted("tasha3_launch2", {.runs = 2});
  const Prediction slow = predicted("tasha3_launch2", {.runs = 2, .servo_lag_s = 0.06, .servo_delay_s = 0.02});
  EXPECT_NEAR(usual.servo_lag_s, 0.020, 1e-12);
  EXPECT_NEAR(usual.delay_s, 0.003 + 0.5 / 333.0 + 0.0005, 1e-12);
  EXPECT_NEAR(slow.servo_lag_s, 0.06, 1e-12);
  EXPECT_NEAR(slow.delay_s, 0.02, 1e-12);
  EXPECT_LT(slow.worst_speed->phase_margin_rad.p5, usual.worst_speed->phase_margin_rad.p5);
  EXPECT_NE(slow.runs[0].roll_angle_rad, usual.runs[0].roll_angle_rad);  // it is flown, too
}

TunnelResult three_rows() {
  const TunnelStep step{.damping_m2 = 19.0, .torque_m = 9.0, .offset_begin_rad = -0.05, .offset_end_rad = -0.06};
  return {.name = "steps.csv", .steps = {step, step, step}, .swirl_words = ""};
}

TEST(Prediction, OfAnotherVehiclesStepsIsRefusedUnlessItIsMeant) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  TunnelResult other = three_rows();
  other.vehicle = "Dart";
  try {
    (void)predict(scenario, other, {.runs = 1}, look_away);
    FAIL() << "not refused";
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), text::ErrorKind::bad_configuration);
    EXPECT_STREQ(error.what(),
                 "steps.csv: its rows are of the vehicle \"Dart\", and tasha3_launch2 flies \"Tasha III, launch 2\"; "
                 "allowed: rows of that vehicle, or --other-vehicle to accept these");
  }
  const Prediction p = predict(scenario, other, {.runs = 1, .other_vehicle = true}, look_away);
  const auto accepted =
      std::ranges::find_if(p.notes, [](const std::string& note) { return note.find("Dart") != std::string::npos; });
  ASSERT_NE(accepted, p.notes.end());
  for (const char* named : {"steps.csv", "Tasha III, launch 2"}) {
    EXPECT_NE(accepted->find(named), std::string::npos) << *accepted;
  }
}

// "Fin offset: 3 deg, not measured" is true of the scenario, and said of nothing that flies here.
TEST(Prediction, SaysThatWhatTheRowsHaveCountsMoreThanAnAssumption) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  scenario.vehicle.assumed = {"Damping: guessed."};
  scenario.assumed = {"Fin offset: 3 deg, not measured."};
  const auto notes = predict(scenario, three_rows(), {.runs = 1}, look_away).notes;
  EXPECT_NE(notes[0].find("steps.csv"), std::string::npos) << notes[0];
  EXPECT_EQ(figures(notes[0]), Numbers{"2"}) << "sentences that follow";
  EXPECT_EQ(notes[1], scenario.vehicle.assumed[0]);
  EXPECT_EQ(notes[2], scenario.assumed[0]);
  const auto note_of_the_run = [&] { return repeat_run(scenario, three_rows(), {.runs = 1}, 0).flight.notes.front(); };
  const std::string below = note_of_the_run();
  scenario.vehicle.assumed.clear();
  const auto note = predict(scenario, three_rows(), {.runs = 1}, look_away).notes[0];
  EXPECT_NE(note.find("steps.csv"), std::string::npos) << note;
  EXPECT_EQ(figures(note), Numbers{}) << "one sentence follows";
  EXPECT_EQ(note_of_the_run(), below);
  scenario.assumed.clear();
  const std::string alone = note_of_the_run();
  EXPECT_TRUE(alone.ends_with(" deg.")) << alone;
  EXPECT_TRUE(below.starts_with(alone + " They replace ")) << below;
}

TEST(Prediction, SaysWithWhichInertiaTheStepsWereIdentified) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const auto said = [&scenario](const std::optional<double>& inertia_kg_m2) {
    TunnelResult tunnel = three_rows();
    tunnel.vehicle = scenario.vehicle.name;
    tunnel.inertia_kg_m2 = inertia_kg_m2;
    const std::vector<std::string> notes = predict(scenario, tunnel, {.runs = 1}, look_away).notes;
    const auto note = std::ranges::find_if(
        notes, [](const std::string& each) { return each.find("roll inertia") != std::string::npos; });
    return note == notes.end() ? std::string{} : *note;
  };
  const std::string unknown = said({});
  const std::string same = said(0.00393);
  for (const std::string& note : {unknown, same}) {
    EXPECT_FALSE(note.empty());
    EXPECT_EQ(note.find("kg m2"), std::string::npos) << note;
  }
  EXPECT_NE(unknown.find(" not "), std::string::npos) << unknown;
  EXPECT_EQ(same.find(" not "), std::string::npos) << same;
  for (const char* inertia : {"0.01 kg m2", "0.00393"}) {
    EXPECT_NE(said(0.01).find(inertia), std::string::npos) << said(0.01);
  }
}

// What was identified is the product of the area with damping and torque.
TEST(Prediction, StepsOfAnotherReferenceAreaAreConverted) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  TunnelResult tunnel = three_rows();
  tunnel.reference_area_m2 = 100.0 * scenario.vehicle.roll_plant.reference_area_m2;
  const Prediction p = predict(scenario, tunnel, {.runs = 2}, look_away);
  EXPECT_NEAR(p.runs[1].airframe.damping_m2, 1900.0, 1e-6);
  EXPECT_NEAR(p.runs[1].airframe.torque_m, 900.0, 1e-6);
  EXPECT_FALSE(p.area);
}

TEST(Prediction, AReferenceAreaThatIsNotKnownWellIsInTheSpread) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Prediction wide = predict(scenario, three_rows(), {.runs = 20}, look_away);
  ASSERT_TRUE(wide.area);
  EXPECT_NEAR(wide.area->low, 3.2 / 5.0265, 1e-9);
  EXPECT_NEAR(wide.area->high, 7.7 / 5.0265, 1e-9);
  EXPECT_NE(wide.runs[0].airframe.damping_m2, wide.runs[1].airframe.damping_m2);
  scenario.vehicle.reference_area_range_m2.clear();
  const Prediction narrow = predict(scenario, three_rows(), {.runs = 20}, look_away);
  EXPECT_NEAR(narrow.runs[0].airframe.damping_m2, narrow.runs[1].airframe.damping_m2, 1e-9);
  EXPECT_LT(wide.worst_speed->phase_margin_rad.p5, narrow.worst_speed->phase_margin_rad.p5 - text::radians(1.0));
}

TEST(Prediction, OneRunIsTheSameWhenItIsRepeatedAlone) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const TunnelResult tunnel = read_tunnel_result(scenario.tunnel_result.value(), {});
  const Options options{.runs = 3, .damping = {.low = 1.0, .high = 1.6}, .servo_lag_s = 0.03, .servo_delay_s = 0.01};
  const Prediction p = predict(scenario, tunnel, options, look_away);
  const RepeatedRun repeated = repeat_run(scenario, tunnel, options, 2);
  EXPECT_EQ(repeated.run.seed, p.runs[2].seed);
  EXPECT_EQ(repeated.run.airframe.damping_m2, p.runs[2].airframe.damping_m2);
  EXPECT_EQ(repeated.run.largest_hold_error_rad, p.runs[2].largest_hold_error_rad);
  EXPECT_EQ(repeated.run.roll_angle_rad, p.runs[2].roll_angle_rad);
  EXPECT_EQ(repeated.run.verdict, p.runs[2].verdict);
  EXPECT_FALSE(repeated.flight.log.empty());
  EXPECT_EQ(figures(repeated.flight.notes.front()).at(0), "2") << "the run";
  EXPECT_EQ(figures(repeated.flight.notes.front()).at(1), "1") << "the seed";
}

TEST(Prediction, RepeatsWhatTheFlightsRemark) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  EXPECT_TRUE(predict(scenario, three_rows(), {.runs = 2}, look_away).flight_notes.empty());
  scenario.guide.tilt_rad = text::radians(8.0);
  const Prediction leaning = predict(scenario, three_rows(), {.runs = 2}, look_away);
  ASSERT_EQ(leaning.flight_notes.size(), 1U);
  EXPECT_EQ(figures(leaning.flight_notes[0]).at(0), "8") << leaning.flight_notes[0];
  EXPECT_NE(leaning.flight_notes[0].find("guide"), std::string::npos) << leaning.flight_notes[0];
}

TEST(Prediction, SaysWhereItHasNoSpread) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  TunnelResult tunnel = three_rows();
  const auto missing = [&](std::size_t runs) {
    return missing_spread(predict(scenario, tunnel, {.runs = runs}, look_away));
  };
  const std::string one_airframe = missing(2);
  EXPECT_EQ(figures(one_airframe), (Numbers{"0.1", "2"}));  // degrees of the offset, % of damping and torque
  EXPECT_NE(one_airframe.find("steps.csv"), std::string::npos) << one_airframe;
  const Decision d = decide(predict(scenario, tunnel, {.runs = 2}, look_away), {});
  EXPECT_TRUE(d.text.ends_with(". " + one_airframe)) << d.text;
  // As the noise of a simulated tunnel leaves them.
  tunnel.steps[1].damping_m2 = 19.2;
  tunnel.steps[2].offset_begin_rad += text::radians(0.02);
  EXPECT_EQ(missing(2), one_airframe);
  tunnel.steps[1].damping_m2 = 20.0;
  const std::string one_offset = missing(2);
  EXPECT_EQ(figures(one_offset), Numbers{"0.1"});
  const std::string one_run = missing(1);
  EXPECT_FALSE(one_run.empty());
  EXPECT_EQ(figures(one_run), Numbers{});
  tunnel.steps[1].offset_end_rad = -0.05;
  EXPECT_EQ(missing(2), "");
}

TEST(Prediction, OfATunnelRunIsRefused) {
  const sim::Scenario tunnel = input::load_scenario("tunnel_steps", {});
  try {
    require_launch(tunnel);
    FAIL() << "not refused";
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), text::ErrorKind::bad_configuration);
    EXPECT_NE(std::string{error.what()}.find("tunnel_steps: environment.surroundings"), std::string::npos);
  }
}

}  // namespace
}  // namespace fantail::predict
