// SPDX-License-Identifier: MIT

#include "input/messages.hpp"
#include "input/scenario_file.hpp"
#include "input/vehicle_file.hpp"
#include "scratch_file.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

sim::Vehicle vehicle(const std::vector<std::string>& changes) {
  return load_scenario("tasha3_launch2", parse_overrides(changes)).vehicle;
}

std::string refusal(const std::vector<std::string>& changes) {
  const Complaint refused = complaint([&] { (void)vehicle(changes); });
  EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
  return refused.message;
}

TEST(Geometry, IsReadEachIntoItsOwnField) {
  const sim::Geometry shape =
      *vehicle({"shape.nose=haack", "shape.transition_position_m=1", "shape.transition_length_m=0.1",
                "shape.transition_diameter_m=0.06", "fins.count=3", "fins.cant_deg=2", "canard_fins.thickness_m=0.002"})
           .geometry;
  EXPECT_EQ(shape.nose_shape, sim::Geometry::NoseShape::haack);
  EXPECT_DOUBLE_EQ(shape.diameter_m, 0.08);
  EXPECT_DOUBLE_EQ(shape.length_m, 1.51);
  EXPECT_DOUBLE_EQ(shape.nose_length_m, 0.24);
  EXPECT_DOUBLE_EQ(shape.transitions.at(0).position_m, 1.0);
  EXPECT_DOUBLE_EQ(shape.transitions.at(0).length_m, 0.1);
  EXPECT_DOUBLE_EQ(shape.transitions.at(0).aft_diameter_m, 0.06);
  EXPECT_EQ(shape.fins->count, 3);
  EXPECT_DOUBLE_EQ(shape.fins->cant_rad, 2.0 * sim::radians_per_degree);
  EXPECT_DOUBLE_EQ(shape.fins->root_chord_m, 0.18);
  EXPECT_DOUBLE_EQ(shape.fins->tip_chord_m, 0.12);
  EXPECT_DOUBLE_EQ(shape.fins->sweep_m, 0.12);
  EXPECT_DOUBLE_EQ(shape.canards->span_m, 0.028);
  EXPECT_DOUBLE_EQ(shape.canards->thickness_m, 0.002);
  EXPECT_DOUBLE_EQ(*shape.canard_hinge_m, 0.01);
  ASSERT_EQ(shape.masses.size(), 6U);
  EXPECT_EQ(shape.masses[4].name, "fins");
  EXPECT_DOUBLE_EQ(shape.masses[4].mass_kg, 0.28);
  EXPECT_DOUBLE_EQ(shape.masses[4].position_m, 1.42);
  EXPECT_DOUBLE_EQ(shape.masses[4].length_m, 0.18);
  EXPECT_DOUBLE_EQ(shape.masses[4].radius_of_gyration_m, 0.064);
  EXPECT_DOUBLE_EQ(shape.propellant->position_m, 1.36);
}

// Body 0.04 m, fins 0.09 m beyond it at most: no piece of a part is farther from the axis.
TEST(Geometry, APartThatReachesFartherOutThanTheRocketIsRefused) {
  const double span_m = vehicle({}).geometry->fins->span_m;
  const auto radii = [](double radius_m) {
    return "masses.radii_of_gyration_m=[0.024, 0.025, 0.025, 0.039, " + std::to_string(radius_m) + ", 0.022]";
  };
  EXPECT_NO_THROW((void)vehicle({radii(0.04 + span_m)}));
  const std::string said = refusal({radii(0.04 + span_m + 0.002)});
  EXPECT_NE(said.find("for \"fins\"; allowed: at most"), std::string::npos) << said;
  EXPECT_NE(said.find("the radius of the body there, 0.04, plus the longest span"), std::string::npos) << said;
  EXPECT_NO_THROW((void)vehicle({"masses.propellant_radius_of_gyration_m=0.04"}));
  EXPECT_NE(
      refusal({"masses.propellant_radius_of_gyration_m=0.05"})
          .find("masses.propellant_radius_of_gyration_m = 0.05; allowed: at most the radius of the body there, 0.04"),
      std::string::npos);
  // Behind a boat tail less has room.
  EXPECT_NE(refusal({"shape.transition_position_m=1.1", "shape.transition_length_m=0.05",
                     "shape.transition_diameter_m=0.05", "masses.propellant_radius_of_gyration_m=0.03"})
                .find("the radius of the body there, 0.025"),
            std::string::npos);
}

TEST(PlainNumber, HasNoRoundingNoiseAndAllThatAPersonWrites) {
  EXPECT_EQ(plain_number(0.1 + 0.05), "0.15");
  EXPECT_EQ(plain_number(1.51 - 0.18), "1.33");
  EXPECT_EQ(plain_number(1.0000000001), "1.0000000001");
  EXPECT_EQ(plain_number(1e9), "1e+09");
}

// Its parts are more fins than two sections hold.
TEST(Geometry, APartOfADesignMayBeAnotherSetOfFins) {
  const std::string radii = "masses.radii_of_gyration_m=[0.024, 0.025, 0.025, 0.039, 0.3, 0.022]";
  EXPECT_FALSE(refusal({radii}).empty());
  EXPECT_NO_THROW((void)vehicle({radii, "design.file=\"my.ork\""}));
}

TEST(Geometry, OfPartsOutsideTheRocketIsRefused) {
  EXPECT_NE(refusal({"fins.count=2"}).find("allowed: 3 to 8"), std::string::npos) << "two hold one plane only";
  EXPECT_EQ(refusal({"shape.nose_length_m=1.6"}),
            "--set shape.nose_length_m=1.6: shape.nose_length_m = 1.6; allowed: at most length_m, 1.51");
  EXPECT_EQ(refusal({"fins.position_m=1.4"}),
            "--set fins.position_m=1.4: fins.position_m = 1.4 puts the end of the root chord behind the tail; allowed: "
            "at most 1.33");
  EXPECT_EQ(refusal({"canard_fins.position_m=0.2"}),
            "--set canard_fins.position_m=0.2: canard_fins.position_m = 0.2 is on the nose; allowed: at least "
            "shape.nose_length_m = 0.24");
  EXPECT_NE(refusal({"canard_fins.position_m=1.4"})
                .find("canard_fins.position_m = 1.4: their roots overlap those of the fins; allowed: in front of or "
                      "behind 1.33 to 1.51 m"),
            std::string::npos)
      << refusal({"canard_fins.position_m=1.4"});
  EXPECT_EQ(refusal({"canard_fins.hinge_m=0.04"}),
            "--set canard_fins.hinge_m=0.04: canard_fins.hinge_m = 0.04; allowed: at most root_chord_m, 0.035");
  const std::string long_tube = refusal({"masses.lengths_m=[0.24, 0.4, 0.25, 1.5, 0.18, 0.3]"});
  EXPECT_EQ(long_tube.substr(long_tube.find("masses.")),
            "masses.positions_m = 0.87 for \"body tube\", 1.5 m long, reaches out of the rocket; "
            "allowed: a position that keeps it within 0 and 1.59, a diameter behind shape.length_m = 1.51");
  const std::string long_propellant = refusal({"masses.propellant_length_m=0.5"});
  EXPECT_NE(long_propellant.find("for the propellant, 0.5 m long, reaches out of the rocket; allowed: a position that "
                                 "keeps it within 0 and 1.59, a diameter behind shape.length_m = 1.51"),
            std::string::npos)
      << long_propellant;
  EXPECT_EQ(refusal({"shape.diameter_m=1.6"}),
            "--set shape.diameter_m=1.6: shape.diameter_m = 1.6; allowed: less than length_m = 1.51");
}

TEST(Geometry, OfATransitionNeedsAllOfIt) {
  EXPECT_NE(refusal({"shape.transition_position_m=1"}).find("shape.transition_length_m is missing"), std::string::npos);
  EXPECT_NE(
      refusal({"shape.transition_position_m=1", "shape.transition_length_m=0", "shape.transition_diameter_m=0.06"})
          .find("shape.transition_length_m = 0; allowed: above 0"),
      std::string::npos);
  const std::vector<std::string> rest{"shape.transition_length_m=0.1", "shape.transition_diameter_m=0.06"};
  const auto at = [&](const char* position_m) {
    std::vector<std::string> changes = rest;
    changes.push_back(std::string{"shape.transition_position_m="} + position_m);
    return refusal(changes);
  };
  EXPECT_NE(at("0.2").find("is too far forwards; allowed: at least shape.nose_length_m"), std::string::npos);
  EXPECT_NE(at("1.45").find("at most the distance to the tail"), std::string::npos);
}

TEST(Geometry, OfMoreTransitionsAndFinsIsInListsOfOneLength) {
  const std::vector<std::string> first{"shape.transition_position_m=1", "shape.transition_length_m=0.1",
                                       "shape.transition_diameter_m=0.06"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), first.begin(), first.end());
    return more;
  };
  const std::vector<std::string> second{"more_transitions.positions_m=[1.2]", "more_transitions.lengths_m=[0.05]"};
  const auto second_and = [&](const char* last) {
    std::vector<std::string> all = second;
    all.emplace_back(last);
    return with(all);
  };
  const sim::Geometry shape = *vehicle(second_and("more_transitions.diameters_m=[0.07]")).geometry;
  ASSERT_EQ(shape.transitions.size(), 2U);
  EXPECT_DOUBLE_EQ(shape.transitions[1].position_m, 1.2);
  EXPECT_DOUBLE_EQ(shape.transitions[1].aft_diameter_m, 0.07);
  EXPECT_NE(refusal(second_and("more_transitions.diameters_m=[0.07, 0.08]"))
                .find("diameters_m has 2 numbers; allowed: as many as positions_m, 1"),
            std::string::npos);
  EXPECT_NE(refusal(with({"more_transitions.positions_m=[1.05]", "more_transitions.lengths_m=[0.05]",
                          "more_transitions.diameters_m=[0.07]"}))
                .find("= 1.05 (number 1) is too far forwards; allowed: at least the end of the one before, 1.1"),
            std::string::npos);
  const std::vector<std::string> wings{"more_fins.names=[\"Wings\"]", "more_fins.positions_m=[0.9]",
                                       "more_fins.root_chords_m=[0.1]", "more_fins.tip_chords_m=[0.05]",
                                       "more_fins.spans_m=[0.2]"};
  std::vector<std::string> two = wings;
  two.emplace_back("more_fins.counts=[2]");
  const sim::Geometry winged = *vehicle(two).geometry;
  ASSERT_EQ(winged.more_fins.size(), 1U);
  EXPECT_EQ(winged.more_fins[0].set.count, 2);
  EXPECT_EQ(winged.more_fins[0].name, "Wings");
  EXPECT_NE(refusal(wings).find("counts"), std::string::npos);
  two.back() = "more_fins.counts=[2, 3]";
  EXPECT_NE(refusal(two).find("counts has 2 numbers; allowed: as many as names, 1"), std::string::npos);
}

TEST(Geometry, OfADesignNeedsTheNameOfItsFile) {
  EXPECT_NE(refusal({"design.mass_kg=3"}).find("design.file is missing"), std::string::npos);
}

TEST(Geometry, OfMassesNeedsOneNumberForEachName) {
  EXPECT_NE(refusal({"masses.masses_kg=[1, 2]"}).find("masses.masses_kg has 2 numbers; allowed: as many as names, 6"),
            std::string::npos);
  EXPECT_NE(refusal({"masses.names=[\"a\"]"}).find("masses.names has 1 names, and 6 masses are described"),
            std::string::npos);
}

TEST(Geometry, WithoutAShapeIsRefused) {
  const ScratchFile file{
      "[body]\nname = \"x\"\nmass_kg = 3\ndrag_area_m2 = 0.005\nroll_inertia_kg_m2 = 0.004\n[aerodynamics]\n"
      "reference_area_m2 = 5e-5\ndamping_m2 = 20\ntorque_m = 9\n[motor]\nfile = \"i150_canonical\"\n[fins]\n"
      "position_m = 1\nroot_chord_m = 0.1\ntip_chord_m = 0.1\nspan_m = 0.1\n"};
  const Complaint refused = complaint([&] { (void)read_vehicle(Document::load(file.path())); });
  EXPECT_NE(refused.message.find("fins.position_m needs the section [shape]"), std::string::npos) << refused.message;
}

}  // namespace
}  // namespace fantail::input
