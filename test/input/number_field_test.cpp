// SPDX-License-Identifier: MIT
#include "input/number_field.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "text/error.hpp"

namespace fantail::input {
namespace {

std::string refusal(const std::string& name) {
  try {
    (void)number_field(ScenarioFiles::load("tasha3_launch2"), name);
  } catch (const text::Error& error) {
    return error.what();
  }
  return "it was found";
}

TEST(NumberField, IsFoundInScenarioVehicleAndPlanWithUnitRangeAndValue) {
  const ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  const NumberField inertia = number_field(files, "body.roll_inertia_kg_m2");
  EXPECT_EQ(inertia.values, std::vector{0.00393});
  EXPECT_EQ(inertia.unit, "kg m2");
  const NumberField tilt = number_field(files, "launch_guide.tilt_deg");
  EXPECT_EQ(tilt.unit, "deg");
  EXPECT_EQ(tilt.range.maximum, 15.0);
  const NumberField gain = number_field(files, "controller.proportional_gain");
  EXPECT_EQ(gain.values, std::vector{0.5}) << "of the plan";
  EXPECT_EQ(gain.name(), "controller.proportional_gain");
}

TEST(NumberField, HasTheUsualValueWhereItsFileIsSilent) {
  const ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  EXPECT_EQ(number_field(files, "timing.pad_time_s").values, std::vector{10.0});
  EXPECT_EQ(number_field(files, "recording.threshold_g").values, std::vector{2.0});
  const NumberField trim = number_field(files, "canard_mounting.trim_deg");
  EXPECT_EQ(trim.values, std::vector(4, 0.0)) << "one a canard";
  EXPECT_EQ(trim.with({1, 2, 3, 4}).value, "[1, 2, 3, 4]");
}

TEST(NumberField, KeepsAListAListAndEveryDigit) {
  ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  const NumberField offset = number_field(files, "disturbance.angles_deg");
  EXPECT_EQ(offset.values, std::vector{-4.9});
  EXPECT_EQ(offset.with({-1.0 / 3.0}).value, "[-0.3333333333333333]");
  files.apply(offset.with({-2.0}));
  EXPECT_NEAR(files.read().disturbance.front().angle_rad, -0.034906585, 1e-9);
  const NumberField inertia = number_field(files, "body.roll_inertia_kg_m2");
  for (const double value : {0.1 + 0.2, 0.00393, 1e-5 / 3.0}) {
    files.apply(inertia.with({value}));
    EXPECT_EQ(files.read().vehicle.roll_plant.inertia_kg_m2, value);
  }
}

TEST(NumberField, IsRefusedWithWhatIsWrongWithItsName) {
  EXPECT_EQ(refusal("mass_kg"), "\"mass_kg\" is no field; allowed: section.key, as in body.mass_kg");
  EXPECT_EQ(refusal("bodi.mass_kg"), "unknown section bodi; did you mean body?");
  EXPECT_EQ(refusal("body.mass"), "unknown key body.mass; did you mean body.mass_kg?");
  EXPECT_EQ(refusal("flight.motion"),
            "flight.motion is no number that can be spread; allowed: a number that is not a whole one by its kind");
  EXPECT_NE(refusal("airframe.nozzle_position_m").find("and none is usual"), std::string::npos)
      << refusal("airframe.nozzle_position_m");
}

TEST(ScenarioFiles, AreReadAgainWithOtherValuesAndSayWhatAFreshReadingSays) {
  ScenarioFiles files = ScenarioFiles::load("tasha3_launch2");
  const double usual = files.read().vehicle.mass_kg;
  const Override heavier = parse_override("body.mass_kg=4.5");
  files.apply(heavier);
  EXPECT_EQ(files.read().vehicle.mass_kg, load_scenario("tasha3_launch2", std::vector{heavier}).vehicle.mass_kg);
  files.apply(parse_override("body.mass_kg=3.99"));
  EXPECT_EQ(files.read().vehicle.mass_kg, usual);
}

}  // namespace
}  // namespace fantail::input
