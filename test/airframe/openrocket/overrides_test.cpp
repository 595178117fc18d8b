// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "airframe/model/body.hpp"
#include "design_files.hpp"
#include "figures.hpp"

namespace fantail::airframe::openrocket {
namespace {

// Nose and tube weigh nothing; 1 kg lies 0.8 m and 1 kg 1.2 m behind the tip, so all weighs 2 kg at 1 m.
const std::string nose =
    "<nosecone><name>Nose</name><length>0.3</length><thickness>0.002</thickness><shape>conical</shape>"
    "<aftradius>0.05</aftradius></nosecone>";

std::string point(const std::string& name, double kg, double behind_tubes_front_m) {
  return "<masscomponent><name>" + name + "</name><axialoffset method='top'>" + std::to_string(behind_tubes_front_m) +
         "</axialoffset><packedlength>0</packedlength><packedradius>0</packedradius><mass>" + std::to_string(kg) +
         "</mass></masscomponent>";
}

std::string tube(const std::string& overrides, const std::string& inside = point("A", 1, 0.5) + point("B", 1, 0.9)) {
  return "<bodytube><name>Tube</name>" + overrides + "<length>1.2</length><thickness>0.001</thickness><radius>0.05" +
         "</radius><subcomponents>" + inside + "</subcomponents></bodytube>";
}

std::string around(const std::string& rocket, const std::string& stage, const std::string& components) {
  return "<openrocket version='1.8'><rocket><name>T</name>" + rocket + "<subcomponents><stage><name>S</name>" + stage +
         "<subcomponents>" + components + "</subcomponents></stage></subcomponents></rocket></openrocket>";
}

const std::string with_all_once = "<overridesubcomponents>true</overridesubcomponents>";
const std::string mass_with_all = "<overridesubcomponentsmass>true</overridesubcomponentsmass>";
const std::string centre_with_all = "<overridesubcomponentscg>true</overridesubcomponentscg>";

class Overrides : public DesignFiles {
 protected:
  model::MassSum sum(const std::string& xml) { return model::sum_of(read_design(plain(xml)).geometry.masses); }
};

TEST_F(Overrides, OfAStageReplaceMassAndCentreOfAllThatIsInIt) {
  for (const std::string& how : {with_all_once, mass_with_all + centre_with_all}) {
    const auto all =
        sum(around("", "<overridemass>5</overridemass><overridecg>0.95</overridecg>" + how, nose + tube("")));
    EXPECT_NEAR(all.mass_kg, 5.0, 1e-12) << how;
    EXPECT_NEAR(all.centre_of_gravity_m, 0.95, 1e-12) << how;
    EXPECT_NEAR(all.transverse_inertia_kg_m2, 5.0 * 0.2 * 0.2, 1e-9) << how;  // each half 0.2 m from the middle
  }
}

TEST_F(Overrides, OfAStagesCentreAloneKeepTheMass) {
  const auto all = sum(around("", "<overridecg>0.7</overridecg>" + centre_with_all, nose + tube("")));
  EXPECT_NEAR(all.mass_kg, 2.0, 1e-12);
  EXPECT_NEAR(all.centre_of_gravity_m, 0.7, 1e-12);
}

TEST_F(Overrides, OfAStagesMassAloneKeepTheCentre) {
  for (const std::string& how : {with_all_once, mass_with_all}) {
    const auto all = sum(around("", "<overridemass>3</overridemass>" + how, nose + tube("")));
    EXPECT_NEAR(all.mass_kg, 3.0, 1e-12);
    EXPECT_NEAR(all.centre_of_gravity_m, 1.0, 1e-12);
  }
}

TEST_F(Overrides, OfARocketOfOneStageReplaceThoseOfTheStage) {
  const auto all = sum(around("<overridemass>4</overridemass><overridecg>0.6</overridecg>" + with_all_once,
                              "<overridemass>3</overridemass>" + with_all_once, nose + tube("")));
  EXPECT_NEAR(all.mass_kg, 4.0, 1e-12);
  EXPECT_NEAR(all.centre_of_gravity_m, 0.6, 1e-12);
}

TEST_F(Overrides, OfATubeWithItsPartsCountFromItsFront) {
  for (const std::string& how : {with_all_once, mass_with_all + centre_with_all}) {
    const auto all =
        sum(around("", "", nose + tube("<overridemass>2.5</overridemass><overridecg>0.6</overridecg>" + how)));
    EXPECT_NEAR(all.mass_kg, 2.5, 1e-12);
    EXPECT_NEAR(all.centre_of_gravity_m, 0.3 + 0.6, 1e-12);
  }
}

TEST_F(Overrides, WithoutThePartsInsideLeaveThoseWhereTheyAre) {
  const auto all = sum(around("", "", nose + tube("<overridemass>2</overridemass><overridecg>0.1</overridecg>")));
  EXPECT_NEAR(all.mass_kg, 4.0, 1e-12);
  EXPECT_NEAR(all.centre_of_gravity_m, (2.0 * 0.4 + 2.0 * 1.0) / 4.0, 1e-12);
}

TEST_F(Overrides, ThatVersionsOfOpenRocketReadDifferentlyAreRefused) {
  const auto said = [&](const std::string& overrides) {
    return refusal(plain(around("", "", nose + tube(overrides))));
  };
  for (const std::string& one : {mass_with_all, centre_with_all}) {
    EXPECT_NE(
        said("<overridemass>2</overridemass><overridecg>0.1</overridecg>" + one)
            .find("bodytube \"Tube\": overrides mass or centre of gravity with the parts inside it, and the other "
                  "without them"),
        std::string::npos)
        << one;
  }
  EXPECT_EQ(said("<overridemass>2</overridemass><overridesubcomponents>perhaps</overridesubcomponents>"),
            "plain.ork: bodytube \"Tube\": overridesubcomponents = \"perhaps\"; allowed: true or false");
}

TEST_F(Overrides, OfAStageWithoutItsComponentsAreRefusedAsItHasNoMassOfItsOwn) {
  for (const char* override : {"<overridemass>2</overridemass>", "<overridecg>1</overridecg>"}) {
    EXPECT_NE(refusal(plain(around("", override, nose + tube(""))))
                  .find("stage \"S\": overrides mass or centre of gravity without its components"),
              std::string::npos);
  }
  EXPECT_NE(refusal(plain(around("", "<overridemass>2</overridemass>" + with_all_once, nose + tube("", ""))))
                .find("overrides the mass of parts that weigh nothing"),
            std::string::npos);
}

// 23.09 leaves the centre of gravity where the parts have it, later versions put it where the tube alone has it.
TEST_F(Overrides, OfAMassAloneAreDoubtedWhereVersionsDisagreeOnItsPlace) {
  const std::string heavy = "<material type='bulk' density='1000'>x</material>";
  const Design two = read_design(
      plain(around("", "", nose + tube("<overridemass>3</overridemass>" + mass_with_all + heavy, point("A", 1, 0.1)))));
  ASSERT_EQ(two.left_out.size(), 1U);
  EXPECT_NE(two.left_out[0].what.find("Versions"), std::string::npos);
  EXPECT_NE(two.left_out[0].what.find("0.900 m"), std::string::npos);  // the middle of the tube
  EXPECT_TRUE(read_design(plain(around("", "", nose + tube("<overridemass>3</overridemass>" + mass_with_all))))
                  .left_out.empty());
}

TEST_F(Overrides, OfAWholeMakeUpForWhatIsUncertainInside) {
  const std::string heavy = "<material type='bulk' density='1000'>x</material>";
  const auto left_out = [&](const std::string& overrides) {
    return read_design(
               plain(around("", overrides,
                            nose + tube("<overridemass>3</overridemass>" + mass_with_all + heavy, point("A", 1, 0.1)))))
        .left_out;
  };
  ASSERT_EQ(left_out("").size(), 1U);
  EXPECT_FALSE(left_out("")[0].is_force);
  EXPECT_TRUE(left_out("<overridemass>3</overridemass><overridecg>1</overridecg>" + with_all_once).empty());
}

TEST_F(Overrides, OfDragAreSaidToBeLeftOut) {
  const Design read = read_design(plain(around("", "", nose + tube("<overridecd>0.3</overridecd>"))));
  ASSERT_EQ(read.not_used.size(), 1U);
  EXPECT_TRUE(read.not_used[0].starts_with("bodytube \"Tube\"")) << read.not_used[0];
  EXPECT_NE(read.not_used[0].find("drag"), std::string::npos) << read.not_used[0];
}

TEST_F(Overrides, AndPlacesOutsideOfTheRocketAreRefusedAndNeverMoved) {
  EXPECT_EQ(refusal(plain(around("", "", nose + tube("", point("Ballast", 1, 1.7))))),
            "plain.ork: \"Ballast\": its centre of gravity is 2 m behind the tip of the nose, but the rocket is 1.5 m "
            "long. Move it inside, or leave it out");
  EXPECT_NE(refusal(plain(around("", "<overridemass>2</overridemass><overridecg>-0.1</overridecg>" + with_all_once,
                                 nose + tube(""))))
                .find("\"S\": its centre of gravity is -0.1 m behind"),
            std::string::npos);
}

// As a rod it would be 0.69 m long and end 0.1 m behind the tail.
TEST_F(Overrides, NearTheTailKeepTheInertiaOfWhatIsInside) {
  const auto all =
      sum(around("", "<overridemass>5</overridemass><overridecg>1.25</overridecg>" + with_all_once, nose + tube("")));
  EXPECT_NEAR(all.mass_kg, 5.0, 1e-12);
  EXPECT_NEAR(all.centre_of_gravity_m, 1.25, 1e-12);
  EXPECT_NEAR(all.transverse_inertia_kg_m2, 5.0 * 0.2 * 0.2, 1e-9);
}

// Two halves 1 m apart have 2 x 1 kg x (0.5 m)^2 about their middle; the long one adds 1 kg x (2 m)^2 / 12, of which
// (0.8 m)^2 / 12 stay: up to a diameter behind the tail.
TEST_F(Overrides, AndPartsThatReachOutOfTheRocketAreShortenedWithAWord) {
  const auto assumed = [&](double length_m) {
    const std::string rod = "<masscomponent><name>Rod</name><axialoffset method='bottom'>" +
                            std::to_string(0.5 * length_m - 0.3) + "</axialoffset><packedlength>" +
                            std::to_string(length_m) +
                            "</packedlength><packedradius>0</packedradius><mass>1</mass></masscomponent>";
    return read_design(plain(around("", "", nose + tube("", point("A", 1, -0.1) + rod)))).assumed;
  };
  ASSERT_EQ(assumed(2.0).size(), 1U);
  const double drawn = 0.5 + 4.0 / 12.0;
  const double kept = 0.5 + 0.64 / 12.0;
  const std::string percent = std::to_string(100.0 * (1.0 - kept / drawn)).substr(0, 4);
  EXPECT_TRUE(std::ranges::any_of(figures(assumed(2.0)[0]), [&](const auto& n) { return n.starts_with(percent); }))
      << assumed(2.0)[0];
  EXPECT_TRUE(assumed(0.6).empty());
}

}  // namespace
}  // namespace fantail::airframe::openrocket
