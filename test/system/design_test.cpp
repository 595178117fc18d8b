// SPDX-License-Identifier: MIT

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

// A case of 0.3 kg and 0.2 kg of propellant, 0.25 m long.
constexpr const char* motor = "K9 38 250 0 0.2 0.5 x\n0.05 300\n2 300\n2.1 0\n";

std::string mounted(const std::string& configuration, const std::string& designation, const std::string& length_m) {
  return "<motor configid='" + configuration + "'><designation>" + designation +
         "</designation><diameter>0.038</diameter><length>" + length_m + "</length></motor>";
}

/// 1.5 m long, 0.1 m thick; without the motor it weighs 2 kg at 0.8 m, as nothing but one point of it weighs anything.
std::string design(const std::string& stage, const std::string& motors, const std::string& simulations) {
  return "<openrocket version='1.8'><rocket><name>Case</name><subcomponents><stage><name>S</name>" + stage +
         "<subcomponents><nosecone><name>N</name><length>0.3</length><thickness>0.002</thickness><shape>conical</shape>"
         "<aftradius>0.05</aftradius></nosecone><bodytube><name>B</name><length>1.2</length><thickness>0.001</"
         "thickness>"
         "<radius>0.05</radius><motormount><overhang>0</overhang>" +
         motors +
         "</motormount><subcomponents><masscomponent><name>Load</name><position type='top'>0.5</position>"
         "<packedlength>0</packedlength><packedradius>0</packedradius><mass>2</mass></masscomponent><trapezoidfinset>"
         "<name>Fins</name><fincount>4</fincount><position type='bottom'>0</position><thickness>0.003</thickness>"
         "<rootchord>0.15</rootchord><tipchord>0.08</tipchord><sweeplength>0.07</sweeplength><height>0.1</height>"
         "</trapezoidfinset></subcomponents></bodytube></subcomponents></stage></subcomponents></rocket><simulations>" +
         simulations + "</simulations></openrocket>";
}

std::string flight(const std::string& configuration, const std::string& numbers) {
  return "<simulation status='uptodate'><name>Calm</name><conditions><configid>" + configuration +
         "</configid></conditions><flightdata><databranch name='S' types='Mass,CG location,CP location,Angle of "
         "attack'>"
         "<datapoint>" +
         numbers + "</datapoint></databranch></flightdata></simulation>";
}

class Designs : public testing::Test {
 protected:
  /// What `new` says, and then `airframe` of the vehicle that it made.
  std::pair<std::string, std::string> said(const std::string& xml) {
    folder_.write("case.ork", xml);
    folder_.write("k9.eng", motor);
    std::filesystem::remove_all(folder_.path() / "made");
    const Surroundings here{.working_folder = folder_.path()};
    const Outcome made = fantail({"new", "made", "--from", "case.ork", "--motor", "k9.eng"}, here);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    const Outcome later = fantail({"airframe", "made/vehicle.toml"}, here);
    EXPECT_EQ(later.exit_code, 0) << later.err;
    return {made.out, later.out};
  }

  [[nodiscard]] double centre_of_gravity_m() const {
    const std::string vehicle = content(folder_.path() / "made/vehicle.toml");
    const std::string key = "\ncentre_of_gravity_m = ";
    return std::stod(vehicle.substr(vehicle.find(key) + key.size()));
  }

 private:
  Folder folder_;
};

const std::string k9 = mounted("a", "K9", "0.25");
constexpr double loaded_m = (2.0 * 0.8 + 0.5 * 1.375) / 2.5;

TEST_F(Designs, WithoutAStoredFlightAreStableButNotCompared) {
  const auto [made, later] = said(design("", k9, ""));
  EXPECT_NEAR(centre_of_gravity_m(), loaded_m, 1e-5);
  expect_said(made, {"not compared with its design: "});
  expect_said(later, {"not compared with its design: "});
}

TEST_F(Designs, AreDoubtedAloudWhereTheirStoredCentreOfGravityIsAnotherAndInTheVehicleToo) {
  const auto [made, later] = said(design("", k9, flight("a", "2.5,0.70,NaN,NaN")));
  for (const std::string& text : {made, later}) {
    expect_said(text,
                {"Doubtful: case.ork stores the centre of gravity at lift-off at 0.700 m, and this vehicle has it "
                 "at 0.915 m, 2.15 calibres away."});
  }
}

TEST_F(Designs, OverriddenAsAWholeHaveTheCentreThatWasWeighed) {
  (void)said(
      design("<overridemass>4</overridemass><overridecg>0.9</overridecg><overridesubcomponents>true"
             "</overridesubcomponents>",
             k9, ""));
  EXPECT_NEAR(centre_of_gravity_m(), (4.0 * 0.9 + 0.5 * 1.375) / 4.5, 1e-5);
}

TEST_F(Designs, WithMotorsOfSeveralLengthsHoldTheOneThatIsFlown) {
  for (const std::string& motors : {k9 + mounted("b", "L5", "0.6"), mounted("b", "L5", "0.6") + k9,
                                    mounted("b", "L5", "0.6")}) {  // the last: 250 mm by the motor's own file
    const auto [made, later] = said(design("", motors, ""));
    EXPECT_NEAR(centre_of_gravity_m(), loaded_m, 1e-5) << motors;
  }
}

// The second set, 0.3 m wide, is farther out than [fins] and the body together. Two hold one plane more than the other.
TEST_F(Designs, WithASecondSetOfWiderFinsAreReadWithItsForcesAndJudgedInTheWorstPlane) {
  std::string xml = design("", k9, "");
  const std::string wings =
      "<trapezoidfinset><name>Wings</name><fincount>2</fincount><material type='bulk' density='600'>m</material>"
      "<position type='bottom'>-0.3</position><thickness>0.003</thickness><rootchord>0.15</rootchord>"
      "<tipchord>0.08</tipchord><sweeplength>0.07</sweeplength><height>0.3</height></trapezoidfinset>";
  xml.insert(xml.find("<trapezoidfinset>"), wings);
  const auto [made, later] = said(xml);
  expect_said(made, {"calibres at lift-off, in the worst plane ("});
  EXPECT_EQ(made.find("Not used"), std::string::npos) << made;
}

TEST_F(Designs, AreNotComparedWithAFlightOnAnotherMotor) {
  const auto [made, later] = said(design("", k9 + mounted("b", "L5", "0.6"), flight("b", "4,0.9,1.1,0")));
  expect_said(made, {"case.ork stores no simulated flight with this motor that matches the design"});
}

TEST_F(Designs, WhoseMotorIsChangedAfterwardsAreNotComparedWithTheOldOne) {
  const Folder folder;
  folder.write("case.ork", design("", k9, flight("a", "2.5,0.9145,1.2,0")));
  folder.write("k9.eng", motor);
  folder.write("k8.eng", "K8 38 250 0 0.1 0.5 x\n0.05 300\n1 300\n1.1 0\n");
  const Surroundings here{.working_folder = folder.path()};
  EXPECT_EQ(fantail({"new", "made", "--from", "case.ork", "--motor", "k9.eng"}, here).exit_code, 0);
  const Outcome again = fantail({"new", "other", "--from", "made/vehicle.toml", "--motor", "k8.eng"}, here);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  expect_said(again.out, {"not compared with its design"});
}

}  // namespace
}  // namespace fantail::test
