// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <string>

#include "airframe/model/body.hpp"
#include "airframe/model/build_up.hpp"
#include "airframe/openrocket/document.hpp"
#include "design_files.hpp"
#include "figures.hpp"
#include "small_design.hpp"

namespace fantail::airframe::openrocket {
namespace {

using Read = DesignFiles;

TEST_F(Read, TheSameDesignPlainGzippedAndZipped) {
  const std::string xml = design(nose + tube(fins("Tail", 3, "0")));
  for (const auto& file : {plain(xml), gzipped(xml), zipped(xml)}) {
    const Design read = read_design(file);
    EXPECT_EQ(read.name, "Test & Co");
    EXPECT_DOUBLE_EQ(read.geometry.length_m, 1.5);
    EXPECT_DOUBLE_EQ(read.geometry.diameter_m, 0.1);
    EXPECT_EQ(read.geometry.nose_shape, sim::Geometry::NoseShape::cone);
    ASSERT_TRUE(read.geometry.fins);
    EXPECT_EQ(read.geometry.fins->count, 3);
    EXPECT_NEAR(read.geometry.fins->position_m, 1.4, 1e-12);
    EXPECT_NEAR(read.geometry.fins->cant_rad, 1.5 * pi / 180.0, 1e-12);
    EXPECT_TRUE(read.not_used.empty());
  }
}

TEST_F(Read, LettersThatAreNotUtf8AreLatin1AndThatIsSaid) {
  const auto called = [&](const std::string& name, const std::string& head = "") {
    std::string xml = design(nose + tube(fins("Tail", 3, "0")));
    return read_design(plain(head + xml.replace(xml.find("Test &amp; Co"), 13, name)));
  };
  const std::string declared = "<?xml version='1.0' encoding='ISO-8859-1'?>";
  for (const Design& latin : {called("Caf\xE9"), called("Caf\xE9", declared)}) {
    EXPECT_EQ(latin.name, "Caf\xC3\xA9");
    ASSERT_FALSE(latin.assumed.empty());
    EXPECT_TRUE(says(latin.assumed[0], "Latin-1")) << latin.assumed[0];
  }
  EXPECT_EQ(called("Caf\xC3\xA9").name, "Caf\xC3\xA9");
  EXPECT_TRUE(called("Caf\xC3\xA9").assumed.empty());
}

TEST_F(Read, WeighsByMaterialAndSize) {
  const Design read = read_design(plain(design(nose + tube(fins("Tail", 3, "0")))));
  const double cone_kg = 1000.0 * pi * 0.05 * 0.05 * 0.3 / 3.0;
  EXPECT_NEAR(part(read, "Nose").mass_kg / cone_kg, 1.0, 1e-5);
  EXPECT_NEAR(part(read, "Nose").position_m, 0.75 * 0.3, 1e-5);
  EXPECT_NEAR(part(read, "Nose").radius_of_gyration_m, 0.05 * std::sqrt(0.3), 1e-5);  // 3/10 m r^2
  const double tube_kg = 800.0 * pi * (0.05 * 0.05 - 0.048 * 0.048) * 1.2;
  EXPECT_NEAR(part(read, "Tube").mass_kg / tube_kg, 1.0, 1e-9);
  EXPECT_NEAR(part(read, "Tube").position_m, 0.9, 1e-9);
  EXPECT_NEAR(part(read, "Tube").length_m, 1.2, 1e-5);
  EXPECT_NEAR(part(read, "Tail").mass_kg, 3 * 0.1 * 0.08 * 0.004 * 1000.0, 1e-12);
  EXPECT_NEAR(part(read, "Tail").position_m, 1.4 + 0.01 + 0.05, 1e-9);  // half the sweep behind the root's middle
}

TEST_F(Read, PlacesPartsFromTopMiddleBottomAndAbsolutely) {
  const auto mass = [](const std::string& name, const std::string& offset) {
    return "<masscomponent><name>" + name + "</name>" + offset +
           "<packedlength>0.1</packedlength><packedradius>0.02</packedradius><mass>0.5</mass></masscomponent>";
  };
  const Design read = read_design(plain(design(
      nose + tube(mass("top", "<axialoffset method='top'>0.2</axialoffset>") +
                  mass("middle", "<axialoffset method='middle'>0.1</axialoffset>") +
                  mass("bottom", "<position type='bottom'>-0.1</position>") +  // as older versions have it
                  mass("absolute", "<axialoffset method='absolute'>0.7</axialoffset>") + fins("Tail", 4, "0")))));
  EXPECT_NEAR(part(read, "top").position_m, 0.3 + 0.2 + 0.05, 1e-12);
  EXPECT_NEAR(part(read, "middle").position_m, 0.3 + 0.6 + 0.1, 1e-12);
  EXPECT_NEAR(part(read, "bottom").position_m, 1.5 - 0.1 - 0.05, 1e-12);
  EXPECT_NEAR(part(read, "absolute").position_m, 0.75, 1e-12);
}

TEST_F(Read, OverridesReplaceMassAndCentreAloneOrWithChildren) {
  const std::string ballast =
      "<masscomponent><name>ballast</name><packedlength>0</packedlength><mass>1</mass></masscomponent>";
  const Design alone =
      read_design(plain(design(nose + tube(ballast, "<overridemass>2</overridemass><overridecg>0.4</overridecg>"))));
  EXPECT_DOUBLE_EQ(part(alone, "Tube").mass_kg, 2.0);
  EXPECT_DOUBLE_EQ(part(alone, "Tube").position_m, 0.7);
  EXPECT_DOUBLE_EQ(part(alone, "ballast").mass_kg, 1.0);
  const Design all = read_design(plain(design(
      nose +
      tube(ballast, "<overridemass>3</overridemass><overridesubcomponentsmass>true</overridesubcomponentsmass>"))));
  EXPECT_NEAR(part(all, "Tube").mass_kg + part(all, "ballast").mass_kg, 3.0, 1e-12);
  EXPECT_NEAR(part(all, "ballast").mass_kg / part(all, "Tube").mass_kg,
              1.0 / (800.0 * pi * (0.05 * 0.05 - 0.048 * 0.048) * 1.2), 1e-4);
}

TEST_F(Read, EveryElementIsReadKnownOrNamed) {
  const Design known = read_design(plain(design(
      nose + tube(fins("Tail", 3, "0"), "<appearance/><comment>mine</comment><preset/><finish>normal</finish>"))));
  EXPECT_TRUE(known.left_out.empty());
  const Design unknown = read_design(plain(design(nose + tube(fins("Tail", 3, "0"), "<bend>0.1</bend>"))));
  ASSERT_EQ(unknown.left_out.size(), 1U);
  EXPECT_TRUE(says(unknown.left_out[0].what, "bodytube \"Tube\": <bend>")) << unknown.left_out[0].what;
  EXPECT_TRUE(unknown.left_out[0].is_force);
}

TEST_F(Read, AFirstStageThatIsALoadOnALaterMotorIsRefused) {
  const std::string mount = "<motormount><motor configid='a'><designation>I1</designation></motor></motormount>";
  std::string xml = design(nose + tube(""));
  xml.insert(xml.find("</stage>") + 8, "<stage><name>Booster</name><subcomponents>" +
                                           tube(fins("Tail", 3, "0"), mount) + "</subcomponents></stage>");
  EXPECT_TRUE(
      says(refusal(plain(xml)), "its first stage \"Sustainer\" has no motor mount, and the stage \"Booster\" has"))
      << refusal(plain(xml));
}

TEST_F(Read, EveryChangeOfDiameterIsThereAndTheWidestIsTheCalibre) {
  const std::string wider =
      "<transition><name>T</name><material type='bulk' density='1000'>x</material><length>0.1</length>"
      "<thickness>0.002</thickness><shape>conical</shape><foreradius>0.05</foreradius><aftradius>0.08</aftradius>"
      "</transition><bodytube><name>Wide</name><length>0.3</length><thickness>0.002</thickness><radius>0.08</radius>"
      "</bodytube><bodytube><name>Narrow</name><length>0.2</length><thickness>0.002</thickness><radius>0.06</radius>"
      "</bodytube>";
  const Design read = read_design(plain(design(nose + tube("") + wider)));
  ASSERT_EQ(read.geometry.transitions.size(), 2U);
  EXPECT_DOUBLE_EQ(read.geometry.transitions[0].aft_diameter_m, 0.16);
  EXPECT_NEAR(read.geometry.transitions[1].position_m, 1.9, 1e-12);
  EXPECT_DOUBLE_EQ(model::largest_diameter_m(read.geometry), 0.16);
  EXPECT_NEAR(model::radius_m(read.geometry, 1.8), 0.08, 1e-12);
  EXPECT_NEAR(model::radius_m(read.geometry, 2.0), 0.06, 1e-12);
  const model::BodyForces forces = model::body_forces(read.geometry);
  ASSERT_EQ(forces.transitions.size(), 2U);
  EXPECT_NEAR(forces.transitions[1].slope_area_m2, 2.0 * pi * (0.06 * 0.06 - 0.08 * 0.08), 1e-12);
  EXPECT_TRUE(says(read.assumed.at(0), "\"Narrow\"") && says(read.assumed.at(0), "the step")) << read.assumed.at(0);
}

TEST_F(Read, EllipticalAndFreeformFinsKeepAreaSpanAndMiddle) {
  const std::string common =
      "<instancecount>3</instancecount><axialoffset method='bottom'>0</axialoffset><thickness>0.003</thickness>";
  const Design elliptical =
      read_design(plain(design(nose + tube("<ellipticalfinset><name>E</name>" + common +
                                           "<rootchord>0.1</rootchord><height>0.06</height></ellipticalfinset>"))));
  const auto& e = *elliptical.geometry.fins;
  EXPECT_NEAR(0.5 * e.span_m * (e.root_chord_m + e.tip_chord_m), 0.25 * pi * 0.1 * 0.06, 1e-12);
  EXPECT_NEAR(e.sweep_m + 0.5 * e.tip_chord_m, 0.05, 1e-9);  // as much in front as behind
  // A swept trapezoid as points comes back as itself.
  const Design freeform = read_design(
      plain(design(nose + tube("<freeformfinset><name>F</name>" + common +
                               "<finpoints><point x='0' y='0'/><point x='0.07' y='0.06'/><point x='0.12' y='0.06'/>"
                               "<point x='0.1' y='0'/></finpoints></freeformfinset>"))));
  const auto& f = *freeform.geometry.fins;
  EXPECT_NEAR(f.root_chord_m, 0.1, 1e-12);
  EXPECT_NEAR(f.tip_chord_m, 0.05, 1e-12);
  EXPECT_NEAR(f.span_m, 0.06, 1e-12);
  EXPECT_NEAR(f.sweep_m, 0.07, 1e-12);
  EXPECT_TRUE(says(freeform.assumed.at(0), "freeform") && says(freeform.assumed.at(0), "trapezoid"));
}

TEST_F(Read, ANoseBetweenTwoShapesIsTheNearerOne) {
  const auto shape = [&](const std::string& kind, const std::string& parameter) {
    std::string xml = nose;
    xml.replace(xml.find("conical</shape>"), 15, kind + "</shape><shapeparameter>" + parameter + "</shapeparameter>");
    return read_design(plain(design(xml + tube(""))));
  };
  using Shape = sim::Geometry::NoseShape;
  EXPECT_EQ(shape("ogive", "1.0").geometry.nose_shape, Shape::ogive);
  EXPECT_TRUE(shape("ogive", "1.0").assumed.empty());
  EXPECT_EQ(shape("ogive", "0.0").geometry.nose_shape, Shape::cone);
  EXPECT_TRUE(shape("ogive", "0.0").assumed.empty());
  EXPECT_EQ(shape("parabolic", "0.75").geometry.nose_shape, Shape::parabola);
  const std::string in_between = shape("parabolic", "0.75").assumed.at(0);
  EXPECT_TRUE(says(in_between, "\"Nose\"") && figures(in_between) == std::vector<std::string>{"0.75"}) << in_between;
  EXPECT_EQ(shape("haack", "0.333").assumed.size(), 1U);
  EXPECT_EQ(shape("power", "0.5").geometry.nose_shape, Shape::ogive);
  const std::string another = shape("power", "0.5").assumed.at(0);
  EXPECT_TRUE(says(another, "\"Nose\"") && says(another, "\"power\"") && says(another, "ogive")) << another;
}

TEST_F(Read, TheMotorSitsWhereItsMountHoldsIt) {
  const Design read = read_design(plain(design(
      nose +
      tube("<innertube><name>Mount</name><axialoffset method='bottom'>0</axialoffset><length>0.3</length>"
           "<outerradius>0.03</outerradius><thickness>0.001</thickness><motormount><overhang>0.01</overhang>"
           "<motor configid='a'><designation>I150</designation><diameter>0.054</diameter><length>0.25</length></motor>"
           "<motor configid='b'><designation>J99</designation><diameter>0.054</diameter><length>0.2</length></motor>"
           "</motormount></innertube>" +
           fins("Tail", 3, "0")))));
  ASSERT_TRUE(read.motor);
  EXPECT_NEAR(read.motor->end_m, 1.51, 1e-12);
  ASSERT_EQ(read.motor->motors.size(), 2U);
  EXPECT_EQ(read.motor->motors[0].designation, "I150");
  EXPECT_DOUBLE_EQ(read.motor->motors[0].length_m, 0.25);
  EXPECT_EQ(read.motor->motors[1].designation, "J99");
  EXPECT_DOUBLE_EQ(read.motor->motors[1].length_m, 0.2);
}

TEST_F(Read, WhatIsNoDesignIsRefused) {
  EXPECT_EQ(refusal(path("none.ork")), "none.ork: no such file");
  EXPECT_NE(refusal(plain("hello")).find("plain.ork: is not XML: "), std::string::npos);
  EXPECT_EQ(refusal(plain("<rocksim/>")), "plain.ork: is not an OpenRocket design: its XML has no <openrocket>");
  EXPECT_EQ(refusal(plain("")).substr(0, 10), "plain.ork:");
  EXPECT_EQ(refusal(plain(design(""))), "plain.ork: its first stage has no body tube");
  EXPECT_EQ(refusal(plain(design(nose))), "plain.ork: its first stage has no body tube");
  EXPECT_EQ(refusal(plain(design(tube("")))),
            "plain.ork: bodytube \"Tube\": the first component of the stage; allowed: a nose cone");
  EXPECT_EQ(refusal(zipped("x", "readme.txt")),
            "archive.ork: is a zip archive without a design: none of its entries ends with .ork");
  EXPECT_EQ(refusal(plain("PK\x03\x04 nothing else")),
            "plain.ork: is a zip archive that cannot be opened: it is damaged");
  EXPECT_NE(refusal(plain("<!DOCTYPE a [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>" + design(nose)))
                .find("declares a document type or entities"),
            std::string::npos);
}

TEST_F(Read, AGzippedFileThatWasCutOffIsNoDesign) {
  const std::string xml = design(nose + tube(fins("Tail", 3, "0")));
  const auto whole = std::filesystem::file_size(gzipped(xml));
  for (const std::uintmax_t lost : {8U, 9U, 60U}) {  // 8 are the trailer: all of the XML is still there
    const std::filesystem::path file = gzipped(xml);
    std::filesystem::resize_file(file, whole - lost);
    EXPECT_EQ(refusal(file), "packed.ork: cannot be unpacked: it ends too early");
  }
}

TEST_F(Read, OfAParachuteTheMassIsReadAndTheRestSaidToBeLeftOut) {
  const Design read = read_design(plain(design(
      nose +
      tube("<parachute><name>Main</name><packedlength>0.1</packedlength>"
           "<packedradius>0.03</packedradius><diameter>1.2</diameter><overridemass>0.2</overridemass></parachute>"))));
  EXPECT_DOUBLE_EQ(part(read, "Main").mass_kg, 0.2);
  ASSERT_EQ(read.not_used.size(), 1U);
  EXPECT_TRUE(says(read.not_used[0], "\"Main\"") && says(read.not_used[0], "[recovery]")) << read.not_used[0];
}

TEST_F(Read, AnotherDocumentVersionIsRefusedOrNamed) {
  for (const char* odd : {"1.-5", "1.0e0", "1.nan"}) {
    EXPECT_NE(refusal(plain(design(nose + tube(""), odd))).find("has the document version"), std::string::npos) << odd;
  }
  EXPECT_EQ(refusal(plain(design(nose + tube(""), "2.0"))),
            "plain.ork: has the document version \"2.0\"; allowed: 1.0 to 1.10");
  EXPECT_NE(refusal(plain(design(nose + tube(""), "new"))).find("has the document version \"new\""), std::string::npos);
  const Design newer = read_design(plain(design(nose + tube(""), "1.11")));
  EXPECT_EQ(figures(newer.not_used.at(0)), (std::vector<std::string>{"1.11", "1.10"}));
}

TEST_F(Read, NumbersThatMakeNoSenseAreRefusedByComponent) {
  const auto wrong = [&](const std::string& from, const std::string& to) {
    std::string xml = design(nose + tube(fins("Tail", 3, "0")));
    return refusal(plain(xml.replace(xml.find(from), from.size(), to)));
  };
  EXPECT_EQ(wrong("<length>1.2", "<length>-1.2"),
            "plain.ork: bodytube \"Tube\": length = \"-1.2\"; allowed: 0.0005 to 30");
  EXPECT_EQ(wrong("<length>1.2", "<length>NaN"),
            "plain.ork: bodytube \"Tube\": length = \"NaN\"; allowed: 0.0005 to 30");
  EXPECT_EQ(wrong("<height>0.08</height>", ""), "plain.ork: trapezoidfinset \"Tail\": height is missing");
  EXPECT_EQ(wrong("<instancecount>3", "<instancecount>30"),
            "plain.ork: trapezoidfinset \"Tail\": instancecount = \"30\"; allowed: 1 to 8");
}

TEST_F(Read, AnEncryptedEntryAndABombAreRefused) {
  EXPECT_EQ(refusal(zipped(design(nose + tube("")), "rocket.ork", "secret")),
            "archive.ork: its entry rocket.ork is encrypted; save it without a password");
  const std::string bomb(most_bytes + 1, ' ');
  EXPECT_EQ(refusal(zipped(bomb)), "archive.ork: its design has more than 64 MB unpacked; allowed: at most that");
  EXPECT_LT(std::filesystem::file_size(path("archive.ork")), most_bytes / 500);
  EXPECT_EQ(refusal(gzipped(bomb)), "packed.ork: its design has more than 64 MB unpacked; allowed: at most that");
}

}  // namespace
}  // namespace fantail::airframe::openrocket
