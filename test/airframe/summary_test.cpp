// SPDX-License-Identifier: MIT
#include "airframe/summary.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "json/value.hpp"

namespace fantail::airframe {
namespace {

sim::Vehicle vehicle(const std::string& name) {
  return input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, name).string()));
}

const Line& line(const Summary& summary, const std::string& what) {
  const auto found = std::ranges::find(summary.lines, what, &Line::what);
  EXPECT_NE(found, summary.lines.end()) << what;
  return *found;
}

/// The first remark with this word; empty: none.
std::string remark(const Summary& summary, const std::string& word) {
  const auto has_it = [&](const std::string& remark) { return remark.find(word) != std::string::npos; };
  const auto found = std::ranges::find_if(summary.remarks, has_it);
  return found == summary.remarks.end() ? std::string{} : *found;
}

// The publication prints 3.0, 3.47 and 3.99 kg, and roll inertias of 0.00311, 0.00361 and 0.00393 kg m2.
TEST(ShippedShapes, WeighWhatIsPublishedAndTurnAboutAsHard) {
  struct Row {
    const char* name;
    double mass_kg;
    double roll_inertia_kg_m2;
    double length_m;
  };
  for (const Row& row : {Row{"smokey", 3.0, 0.00311, 1.52}, Row{"tasha3_launch1", 3.47, 0.00361, 1.51},
                         Row{"tasha3_launch2", 3.99, 0.00393, 1.51}, Row{"tasha3_tunnel", 3.99, 0.00393, 1.51}}) {
    const sim::Vehicle rocket = vehicle(row.name);
    const Summary summary = summarize(rocket);
    EXPECT_NEAR(line(summary, "mass at lift-off").computed->value, row.mass_kg, 0.001) << row.name;
    EXPECT_NEAR(line(summary, "roll inertia at lift-off").computed->value / row.roll_inertia_kg_m2, 1.0, 0.05);
    EXPECT_EQ(rocket.geometry->length_m, row.length_m);
    EXPECT_EQ(summary.stability, Stability::stable) << summary.sentence;
  }
}

TEST(Stability, IsOfTheSmallerOfTheTwoMargins) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  rocket.airframe->at_liftoff.centre_of_gravity_m = 0.8;
  rocket.airframe->after_burnout.centre_of_gravity_m = 0.85;
  const Summary summary = summarize(rocket);
  EXPECT_NE(summary.sentence.find("after burn-out"), std::string::npos) << summary.sentence;
}

TEST(Stability, IsUnsureWhereTheMethodsErrorReachesTheCentreOfGravityAndRefusedBehindIt) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  rocket.geometry->masses.clear();
  const double pressure_m = summarize(rocket).build_up.centre_of_pressure_m.value;
  const auto with_gravity_at = [&](double share) {
    rocket.airframe->at_liftoff.centre_of_gravity_m = share * pressure_m;
    rocket.airframe->after_burnout.centre_of_gravity_m = 0.5;
    return summarize(rocket);
  };
  // Value, lowest and highest by the error of the method.
  const auto lowest_margin = [](const Summary& summary) { return std::stod(figures(summary.sentence).at(1)); };
  EXPECT_EQ(with_gravity_at(0.80).stability, Stability::stable);
  EXPECT_EQ(with_gravity_at(0.96).stability, Stability::marginal);  // less than a calibre
  EXPECT_NE(with_gravity_at(0.96).sentence.find("usual"), std::string::npos);
  EXPECT_GT(lowest_margin(with_gravity_at(0.96)), 0.0);
  EXPECT_EQ(with_gravity_at(0.98).stability, Stability::marginal);
  EXPECT_EQ(with_gravity_at(1.02).stability, Stability::marginal);
  for (const double unsure : {0.98, 1.02}) {
    EXPECT_EQ(with_gravity_at(unsure).sentence.find("usual"), std::string::npos);
    EXPECT_LT(lowest_margin(with_gravity_at(unsure)), 0.0);
  }
  EXPECT_EQ(with_gravity_at(1.04).stability, Stability::unstable);
}

// Where they differ beyond the method's error, nobody may read the shape's margin alone. Of the file it is
// (0.5 - 0.9) / 0.08 = -5 calibres, with 0.99 m 1.12 at lift-off, with 1.12 m 2.75.
TEST(Stability, OfTheFilesOwnCentreOfPressureIsInTheHeadlineWhereTheShapeContradicts) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  const auto with_pressure_at = [&](double position_m) {
    rocket.airframe->centre_of_pressure_m = position_m;
    return summarize(rocket);
  };
  const Summary in_front = with_pressure_at(0.5);
  EXPECT_EQ(in_front.stability, Stability::unstable);
  EXPECT_EQ(figures(in_front.sentence).at(0), "-5.00") << in_front.sentence;
  EXPECT_NE(in_front.sentence.find("doubtful"), std::string::npos) << in_front.sentence;
  EXPECT_EQ(answer(rocket, in_front, {}).verdict.answer, result::Answer::no);
  EXPECT_EQ(json::parse(result::json(answer(rocket, in_front, {})))["stability"], "unstable");
  const Summary far_behind = with_pressure_at(1.12);
  EXPECT_EQ(far_behind.stability, Stability::doubtful);
  EXPECT_EQ(figures(far_behind.sentence).at(0), "2.75") << far_behind.sentence;
  EXPECT_NE(far_behind.sentence.find("lift-off"), std::string::npos) << far_behind.sentence;
  EXPECT_EQ(answer(rocket, far_behind, {}).verdict.answer, result::Answer::undecided);
  EXPECT_EQ(with_pressure_at(0.99).stability, Stability::stable);
  rocket.geometry->masses.clear();
  rocket.airframe->at_liftoff.centre_of_gravity_m = 1.1;  // behind all that the shape gives
  const Summary by_shape = with_pressure_at(1.3);
  EXPECT_EQ(by_shape.stability, Stability::unstable);
  EXPECT_NE(by_shape.sentence.find("doubtful"), std::string::npos) << by_shape.sentence;
  const Summary by_both = with_pressure_at(0.5);
  EXPECT_EQ(by_both.stability, Stability::unstable);
  EXPECT_EQ(by_both.sentence.find("doubtful"), std::string::npos) << by_both.sentence;
}

TEST(Stability, IsNotJudgedWithoutACentreOfGravity) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  rocket.airframe.reset();
  rocket.geometry->masses.clear();
  const Summary summary = summarize(rocket);
  EXPECT_EQ(summary.stability, Stability::unknown);
  EXPECT_FALSE(summary.centre_of_gravity_m);
  EXPECT_EQ(side_view(*rocket.geometry, summary, 880.0).find("centre of gravity"), std::string::npos);
}

// 5.524 kg of 3.764 are 47 % more, 2.880 of them 23 % less; without the case the rest is 31 % more than the parts.
TEST(Stability, IsDoubtfulWhereThePartsDoNotWeighWhatTheVehicleDoes) {
  const sim::Vehicle agrees = vehicle("tasha3_launch2");
  const std::string as_it_stands = summarize(agrees).sentence;
  sim::Vehicle heavier = agrees;
  heavier.mass_kg = 5.75;
  sim::Vehicle without_case = agrees;
  without_case.geometry->masses.pop_back();
  for (const auto& [rocket, said] :
       {std::pair{heavier, Numbers{"3.764", "5.524", "47"}}, {without_case, Numbers{"2.880", "3.764", "31"}}}) {
    const Summary summary = summarize(rocket);
    EXPECT_EQ(summary.stability, Stability::doubtful);
    ASSERT_EQ(summary.doubts.size(), 1U);
    EXPECT_EQ(figures(summary.doubts[0]), said);
    EXPECT_TRUE(summary.sentence.starts_with("Doubtful: " + summary.doubts[0] + ".")) << summary.sentence;
    EXPECT_TRUE(summary.sentence.ends_with(as_it_stands)) << summary.sentence;
    const result::Document found = answer(rocket, summary, {});
    EXPECT_EQ(found.verdict.heading, "Doubtful");
    EXPECT_EQ(found.verdict.answer, result::Answer::undecided);
  }
  sim::Vehicle nearly = agrees;
  nearly.mass_kg += 0.07;  // 1.9 % of what is left after the burn
  EXPECT_EQ(summarize(nearly).stability, Stability::stable);
}

// The propellant lies in the tail: what is known after burn-out is the larger margin.
TEST(Stability, IsDoubtfulWhereTheBalanceAtLiftOffIsUnknown) {
  sim::Vehicle rocket = vehicle("smokey");
  rocket.airframe.reset();
  EXPECT_EQ(summarize(rocket).stability, Stability::stable);
  rocket.geometry->propellant.reset();
  const Summary summary = summarize(rocket);
  EXPECT_EQ(summary.stability, Stability::doubtful) << summary.sentence;
  EXPECT_TRUE(summary.sentence.starts_with("Doubtful: the centre of gravity at lift-off")) << summary.sentence;
}

// 0.907 m and 0.698 kg m2 at lift-off, 0.880 m and 0.647 kg m2 after burn-out, and 0.00409 kg m2 by the parts; a
// calibre is 0.08 m.
TEST(Stability, IsDoubtfulWhereTheFileContradictsItsShapeOrItsParts) {
  using Change = std::function<void(sim::Vehicle&)>;
  struct Row {
    const char* what;
    Change beyond;
    Change within;
    Numbers said;
  };
  for (const Row& row : {
           Row{"the length",
               [](auto& v) { v.airframe->length_m = 5.0; },
               [](auto& v) { v.airframe->length_m += 0.0009; },
               {"5", "1.51"}},
           {"the diameter",
            [](auto& v) { v.airframe->diameter_m = 0.3; },
            [](auto& v) { v.airframe->diameter_m -= 0.0009; },
            {"0.3", "0.08"}},
           {"the centre of gravity at lift-off",
            [](auto& v) { v.airframe->at_liftoff.centre_of_gravity_m = 0.885; },
            [](auto& v) { v.airframe->at_liftoff.centre_of_gravity_m = 0.895; },
            {"0.885", "0.9073"}},
           {"the centre of gravity after burn-out",
            [](auto& v) { v.airframe->after_burnout.centre_of_gravity_m = 0.85; },
            [](auto& v) { v.airframe->after_burnout.centre_of_gravity_m = 0.89; },
            {"0.85", "0.8801"}},
           {"the transverse inertia at lift-off",
            [](auto& v) { v.airframe->at_liftoff.transverse_inertia_kg_m2 = 5.0; },
            [](auto& v) { v.airframe->at_liftoff.transverse_inertia_kg_m2 = 0.4; },
            {"5", "0.6977"}},
           {"the transverse inertia after burn-out",
            [](auto& v) { v.airframe->after_burnout.transverse_inertia_kg_m2 = 0.3; },
            [](auto& v) { v.airframe->after_burnout.transverse_inertia_kg_m2 = 0.9; },
            {"0.3", "0.6474"}},
           {"the roll inertia at lift-off",
            [](auto& v) { v.roll_plant.inertia_kg_m2 = 1.0; },
            [](auto& v) { v.roll_plant.inertia_kg_m2 = 0.006; },
            {"1", "0.004092"}},
           {"the roll inertia after burn-out",
            [](auto& v) { v.airframe->roll_inertia_after_burnout_kg_m2 = 0.001; },
            [](auto& v) { v.airframe->roll_inertia_after_burnout_kg_m2 = 0.003; },
            {"0.001", "0.004041"}},
       }) {
    sim::Vehicle rocket = vehicle("tasha3_launch2");
    row.beyond(rocket);
    const Summary summary = summarize(rocket);
    EXPECT_EQ(summary.stability, Stability::doubtful) << row.what;
    ASSERT_EQ(summary.doubts.size(), 1U) << row.what;
    EXPECT_TRUE(summary.doubts[0].starts_with(row.what)) << summary.doubts[0];
    EXPECT_EQ(figures(summary.doubts[0]), row.said) << summary.doubts[0];
    EXPECT_TRUE(summary.sentence.starts_with("Doubtful: " + summary.doubts[0] + ".")) << summary.sentence;
    EXPECT_EQ(answer(rocket, summary, {}).verdict.answer, result::Answer::undecided) << row.what;
    sim::Vehicle nearly = vehicle("tasha3_launch2");
    row.within(nearly);
    EXPECT_EQ(summarize(nearly).stability, Stability::stable) << row.what;
  }
}

TEST(Stability, HasEachReasonOfADoubtBehindOneWord) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  rocket.mass_kg = 5.75;
  rocket.airframe->centre_of_pressure_m = 1.12;
  const std::string sentence = summarize(rocket).sentence;
  EXPECT_TRUE(sentence.starts_with("Doubtful: ")) << sentence;
  EXPECT_EQ(sentence.find("oubtful", 9), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("2.75"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("more. The file's centre of pressure"), std::string::npos) << sentence;
}

TEST(Remarks, NameWhatContradicts) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  rocket.airframe->centre_of_pressure_m = 1.4;
  EXPECT_EQ(figures(remark(summarize(rocket), "centre of pressure")).at(0), "1.4");
  rocket.geometry->canards.reset();
  EXPECT_NE(remark(summarize(rocket), "[canard_fins]"), "");
}

TEST(Remarks, GiveTheOffsetOfCantedFinsInCanardAngles) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  rocket.geometry->fins->cant_rad = -1.0 * sim::radians_per_degree;
  const Summary summary = summarize(rocket);
  const auto fins = model::fin_forces(*rocket.geometry->fins, 0.04);
  const auto canards = model::fin_forces(*rocket.geometry->canards, 0.04);
  EXPECT_NEAR(summary.build_up.cant_as_canards->value, fins.roll_torque_m3 / canards.roll_torque_m3, 1e-12);
  const Numbers said = figures(remark(summary, "cant"));
  EXPECT_TRUE(said.at(0) == "-1" && said.at(1).starts_with("-")) << remark(summary, "cant");
}

// Behind canards that may have no torque left: no angle of theirs is surely enough.
TEST(Remarks, GiveTheCanardsOfAFinCantNoUpperEndWhereTheirTorqueMayBeZero) {
  sim::Vehicle rocket = vehicle("tasha3_launch2");
  ASSERT_EQ(summarize(rocket).build_up.roll_torque_m3->low, 0.0);
  for (const auto& [cant_deg, said] : {std::pair{1.0, "or more"}, std::pair{-1.0, "or less"}}) {
    rocket.geometry->fins->cant_rad = cant_deg * sim::radians_per_degree;
    const Summary summary = summarize(rocket);
    EXPECT_NE(remark(summary, "cant").find(said), std::string::npos) << cant_deg;
    const result::Document found = answer(rocket, summary, {});
    EXPECT_NE(result::text(found).find(range_text(*summary.build_up.cant_as_canards, 2)), std::string::npos);
    EXPECT_NE(result::json(found).find("\"high\": null"), std::string::npos);
  }
  EXPECT_EQ(range_text({.value = 2.0, .low = 1.0, .high = 4.0}, 1), "1.0 to 4.0");
}

}  // namespace
}  // namespace fantail::airframe
