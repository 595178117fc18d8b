// SPDX-License-Identifier: MIT
#include <string>

#include "airframe/model/build_up.hpp"
#include "design_files.hpp"
#include "figures.hpp"
#include "small_design.hpp"

namespace fantail::airframe::openrocket {
namespace {

using FinChoice = DesignFiles;

// Nothing holds the rocket in the plane of the two.
TEST_F(FinChoice, TwoFinsAloneAreFurtherFinsAndTheMarginIsThatOfTheWorstPlane) {
  const Design read = read_design(plain(design(nose + tube(fins("Tail", 2, "0")))));
  EXPECT_FALSE(read.geometry.fins);
  ASSERT_EQ(read.geometry.more_fins.size(), 1U);
  EXPECT_EQ(read.geometry.more_fins[0].name, "Tail");
  EXPECT_EQ(read.geometry.more_fins[0].set.count, 2);
  sim::Vehicle vehicle;
  vehicle.geometry = read.geometry;
  const model::BuildUp b = model::build_up(vehicle);
  ASSERT_TRUE(b.worst_centre_of_pressure_m);
  EXPECT_NEAR(b.worst_centre_of_pressure_m->value, 2.0 / 3.0 * 0.3, 1e-6);  // of the cone alone
  EXPECT_GT(b.centre_of_pressure_m.value, 0.9);
}

TEST_F(FinChoice, FourFinsInFrontAreCanardsAndOthersAreFurtherFins) {
  const Design read = read_design(
      plain(design(nose + tube(fins("Tail", 4, "0") + fins("Front", 4, "-1.0") + fins("Middle", 3, "-0.4")))));
  ASSERT_TRUE(read.geometry.canards);
  EXPECT_NEAR(read.geometry.canards->position_m, 0.4, 1e-12);
  ASSERT_EQ(read.geometry.more_fins.size(), 1U);
  EXPECT_EQ(read.geometry.more_fins[0].name, "Middle");
  EXPECT_TRUE(read.not_used.empty());
  EXPECT_TRUE(read.left_out.empty());
  ASSERT_EQ(read.assumed.size(), 1U);
  EXPECT_TRUE(says(read.assumed[0], "\"Front\"") && says(read.assumed[0], "canards")) << read.assumed[0];
}

TEST_F(FinChoice, TheOnlyFinsAreTheFinsWhereverTheyAre) {
  const Design read = read_design(plain(design(nose + tube(fins("Fins", 4, "-1.0")))));
  EXPECT_TRUE(read.geometry.fins);
  EXPECT_FALSE(read.geometry.canards);
}

TEST_F(FinChoice, CanardsAreChosenByNameAndRefusedWhereTheyCannotBe) {
  const auto file = plain(
      design(nose + tube(fins("Tail", 4, "0") + fins("A", 4, "-1.0") + fins("B", 4, "-0.8") + fins("C", 3, "-0.6"))));
  EXPECT_NEAR(read_design(file, "B").geometry.canards->position_m, 0.6, 1e-12);
  EXPECT_TRUE(read_design(file, "B").assumed.empty());
  const auto said = [&](const std::string& canards) {
    try {
      (void)read_design(file, canards);
    } catch (const text::Error& error) {
      return std::string{error.what()};
    }
    return std::string{"not refused"};
  };
  EXPECT_TRUE(says(said(""), "more than one set may be the canards") && says(said(""), "--canards NAME")) << said("");
  EXPECT_TRUE(says(said("D"), "no fins \"D\"") && says(said("D"), "\"A\" (4)")) << said("D");
  EXPECT_TRUE(says(said("C"), "the fins \"C\" are 3")) << said("C");
}

TEST_F(FinChoice, SingleFinsOfOneShapeEvenlyAroundAreASetAndOthersStayAlone) {
  const auto at = [](const std::string& name, const std::string& degrees) {
    std::string fin = fins(name, 1, "0");
    return fin.insert(fin.find("<thickness>"), "<angleoffset method='relative'>" + degrees + "</angleoffset>");
  };
  const Design three = read_design(
      plain(design(nose + tube(at("A", "0") + at("B", "240") + at("C", "-240") + fins("Rudder", 1, "-0.4")))));
  ASSERT_TRUE(three.geometry.fins);
  EXPECT_EQ(three.geometry.fins->count, 3);
  ASSERT_EQ(three.geometry.more_fins.size(), 1U);
  ASSERT_EQ(three.assumed.size(), 1U);
  EXPECT_TRUE(says(three.assumed[0], "\"Rudder\"") && says(three.assumed[0], "one side")) << three.assumed[0];
  const Design uneven = read_design(plain(design(nose + tube(at("A", "0") + at("B", "90") + at("C", "180")))));
  EXPECT_FALSE(uneven.geometry.fins);
  EXPECT_EQ(uneven.geometry.more_fins.size(), 3U);
}

}  // namespace
}  // namespace fantail::airframe::openrocket
