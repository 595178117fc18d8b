// SPDX-License-Identifier: MIT

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

const std::string names_of_scenarios =
    "kestrel kestrel_euroc tasha3_launch1 tasha3_launch2 tasha3_launch2_euroc tasha3_launch2_integral "
    "tasha3_launch2_irec tunnel_flow tunnel_stability tunnel_steps tunnel_swirl_with tunnel_swirl_without";
const std::string names_of_plans =
    "kestrel kestrel_euroc tasha3_launch1 tasha3_launch2 tasha3_launch2_euroc tasha3_launch2_integral "
    "tasha3_launch2_irec tunnel_free tunnel_stability tunnel_steps";
const std::string first_lines = "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n";

std::string shipped(const std::string& file) { return content(std::string{FANTAIL_TEST_SOURCE} + "/sim/" + file); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(UnknownScenario, IsRefusedWithTheShippedNamesAndASuggestion) {
  Refusal({}, {"fly", "tasha_launch2"}, 66,
          {"unknown scenario \"tasha_launch2\"", "did you mean tasha3_launch2?", names_of_scenarios});
  Refusal({}, {"fly", "wholly-other"}, 66, {"unknown scenario \"wholly-other\"", names_of_scenarios});
}

TEST(EmptyWord, IsRefusedWhereverItStands) {
  Refusal({}, {"fly", ""}, 64, {"SCENARIO: it is empty"});
  Refusal({}, {"fly", "--image", ""}, 64, {"--image: it is empty"});
  Refusal({}, {"campaign", "hardover", ""}, 64, {"SCENARIO: it is empty"});
  Refusal({}, {"log", "export", "", "--to", "csv"}, 64, {"LOG: it is empty"});
  Refusal({}, {"identify", ""}, 64, {"it is empty"});
  Refusal({}, {"bench", "limits", "--can", ""}, 64, {"--can: it is empty"});
}

TEST(UnknownPlan, IsRefusedWithTheShippedNamesAndASuggestion) {
  Refusal({}, {"plan", "check", "tunel_steps"}, 66, {"did you mean tunnel_steps?", names_of_plans});
}

TEST(MissingPath, IsRefused) {
  Refusal({}, {"fly", "no/such.toml"}, 66, {"no/such.toml"});
  Refusal({}, {"plan", "show", "./none"}, 66, {"./none"});
  Refusal({{"folder.toml/file", ""}}, {"fly", "folder.toml"}, 66, {"folder.toml"});
  for (const Words& words : {Words{"fly", "/dev/zero"},
                             {"plan", "check", "/dev/zero"},
                             {"new", "x", "--from", "/dev/zero"},
                             {"predict", "tasha3_launch2", "--tunnel", "/dev/zero"},
                             {"identify", "/dev/zero", "--vehicle", "tasha3_launch2"},
                             {"log", "info", "/dev/zero"},
                             {"report", "/dev/zero"}}) {
    Refusal({}, words, 66, {"/dev/zero: is a device, not a file; copy the data you need into a file"});
  }
  Refusal({}, {"identify", "/nonexistent"}, 66, {"/nonexistent: no such file"});
  Refusal({}, {"tunnel", "stability", "/nonexistent"}, 66, {"/nonexistent: no such file"});
}

TEST(MissingPart, IsRefusedWhereItIsNamed) {
  Refusal({{"s.toml", "plan = \"tasha3_launch2\"\nvehicle = \"tasha3_launch\"\n"}}, {"fly", "s.toml"}, 66,
          {"s.toml:2: ", "unknown vehicle \"tasha3_launch\"", "did you mean tasha3_launch1?", "smokey"});
  Refusal({{"s.toml", "vehicle = \"my/rocket.toml\"\nplan = \"tasha3_launch2\"\n"}}, {"fly", "s.toml"}, 66,
          {"s.toml:1: ", "my/rocket.toml"});
  Refusal({{"s.toml", "vehicle = \"smokey\"\n\nplan = \"nope\"\n"}}, {"fly", "s.toml"}, 66,
          {"s.toml:3: ", "unknown flight plan \"nope\""});
  Refusal({}, {"fly", "--set", "motor.file=i151_canonical"}, 66,
          {"--set motor.file=i151_canonical: ", "unknown motor", "did you mean i150_canonical?"});
  const std::string vehicle = replaced(shipped("vehicles/smokey.toml"), "i150_canonical", "gone.eng");
  Refusal({{"s.toml", "vehicle = \"v.toml\"\nplan = \"tasha3_launch2\"\n"}, {"v.toml", vehicle}}, {"fly", "s.toml"}, 66,
          {"v.toml:80: ", "gone.eng"});
}

TEST(ScenarioWithoutAVehicle, IsRefused) {
  Refusal({{"s.toml", "plan = \"tasha3_launch2\"\n"}}, {"fly", "s.toml"}, 78, {"s.toml", "vehicle is missing"});
  Refusal({{"s.toml", ""}}, {"fly", "s.toml"}, 78, {"s.toml", "is missing"});
}

TEST(BrokenToml, IsRefusedWithLineAndColumn) {
  Refusal({{"s.toml", first_lines + "seed = = 4\n"}}, {"fly", "s.toml"}, 65, {"s.toml:3:8: not valid TOML"});
  Refusal({{"s.toml", "vehicle = \"open\n"}}, {"fly", "s.toml"}, 65, {"s.toml:1:"});
  Refusal({{"s.toml", first_lines + "[timing]\npad_time_s = 5\npad_time_s = 6\n"}}, {"fly", "s.toml"}, 65,
          {"s.toml:5:"});
  Refusal({{"s.toml", std::string{"\xFF\xFE\0\0", 4}}}, {"fly", "s.toml"}, 65, {"s.toml:1:"});
  Refusal({{"p.toml", "[run\n"}}, {"plan", "check", "p.toml"}, 65, {"p.toml:1:"});
  Refusal({{"s.toml", "vehicle = \"v.toml\"\nplan = \"tasha3_launch2\"\n"}, {"v.toml", "\n[body"}}, {"fly", "s.toml"},
          65, {"v.toml:2:"});
}

TEST(UnknownKey, IsRefusedWithItsLineAndASuggestion) {
  Refusal({{"s.toml", first_lines + "[timing]\npad_tim_s = 3\n"}}, {"fly", "s.toml"}, 78,
          {"s.toml:4: unknown key timing.pad_tim_s; did you mean timing.pad_time_s?"});
  Refusal({{"s.toml", first_lines + "sed = 3\n"}}, {"fly", "s.toml"}, 78,
          {"s.toml:3: unknown key sed; did you mean seed?"});
  Refusal({{"s.toml", first_lines + "[enviroment]\n"}}, {"fly", "s.toml"}, 78,
          {"s.toml:3: unknown section [enviroment]; did you mean environment?"});
  Refusal({}, {"fly", "--set", "body.mass=3"}, 78,
          {"--set body.mass=3: unknown key body.mass; did you mean body.mass_kg?"});
  Refusal({}, {"fly", "--set", "bdy.mass_kg=3"}, 78, {"--set bdy.mass_kg=3: unknown section bdy; did you mean body?"});
}

TEST(OutOfRange, IsRefusedWithValueAndRange) {
  Refusal(
      {{"s.toml", "vehicle = \"smokey\"\nplan = \"p.toml\"\n"}, {"p.toml", "[controller]\nproportional_gain = -1\n"}},
      {"fly", "s.toml"}, 78, {"p.toml:2: controller.proportional_gain = -1 is out of range; allowed: 0 to 10"});
  Refusal(
      {}, {"fly", "--set", "controller.proportional_gain=99"}, 78,
      {"--set controller.proportional_gain=99: controller.proportional_gain = 99 is out of range; allowed: 0 to 10"});
  Refusal({}, {"fly", "--set", "timing.arm_time_s=12"}, 78, {"--set timing.arm_time_s=12", "10"});
  Refusal({}, {"fly", "--set", "timing.pad_time_s=1"}, 78, {"--set timing.pad_time_s=1", "arm_time_s"});
}

TEST(NotANumber, IsRefusedWhereverItStands) {
  for (const std::string value : {"nan", "inf", "-inf", "+nan"}) {
    Refusal({{"s.toml", first_lines + "[timing]\npad_time_s = " + value + "\n"}}, {"fly", "s.toml"}, 78,
            {"s.toml:4: timing.pad_time_s = "});
    Refusal({{"s.toml", first_lines + "[disturbance]\ntimes_s = [0]\nangles_deg = [" + value + "]\n"}},
            {"fly", "s.toml"}, 78, {"s.toml:5: disturbance.angles_deg = "});
    Refusal({}, {"fly", "--set", "body.drag_area_m2=" + value}, 78, {"--set body.drag_area_m2=" + value});
    const std::string motor = replaced(shipped("motors/i150_canonical.eng"), "0.70 173", "0.70 " + value);
    Refusal({{"m.eng", motor}}, {"fly", "--set", "motor.file=m.eng"}, 65, {"m.eng:9: thrust \"" + value});
  }
}

TEST(ThrustCurve, ThatGoesBackInTimeIsRefused) {
  const std::string motor = replaced(shipped("motors/i150_canonical.eng"), "0.70 173", "0.04 173");
  Refusal({{"m.eng", motor}}, {"fly", "--set", "motor.file=m.eng"}, 65,
          {"m.eng:9: time 0.04 s comes after 0.05 s; allowed: increasing times"});
}

TEST(Motor, WithMorePropellantThanTheRocketIsRefused) {
  Refusal({}, {"fly", "--set", "body.mass_kg=0.2"}, 78, {"--set body.mass_kg=0.2", "0.226", "propellant"});
  const std::string vehicle = replaced(shipped("vehicles/smokey.toml"), "mass_kg = 3.0", "mass_kg = 0.226");
  Refusal({{"s.toml", "vehicle = \"v.toml\"\nplan = \"tasha3_launch2\"\n"}, {"v.toml", vehicle}}, {"fly", "s.toml"}, 78,
          {"v.toml:13: body.mass_kg = 0.226", "propellant"});
}

// Numbers that are allowed one by one and make no rocket together; and what a model further down would refuse.
TEST(Combination, ThatNoModelCanFlyIsRefusedByTheFile) {
  Refusal({}, {"fly", "--set", "servo.pulse_per_degree_us=0"}, 78, {"--set servo.pulse_per_degree_us=0", "zero"});
  Refusal({}, {"fly", "--set", "servo.pulse_per_degree_us=1e-320"}, 78, {"--set servo.pulse_per_degree_us", "zero"});
  Refusal({}, {"fly", "gimbal", "--set", "gimbal.turn_times_s=[12, 13, 20, 24, 28, 32]"}, 78,
          {"gimbal.turn_times_s", "begins before the previous one has ended"});
  Refusal({}, {"fly", "gimbal", "--set", "gimbal.turn_times_s=[12, 16]"}, 78,
          {"gimbal.turn_times_s", "allowed: the same number of each"});
  Refusal({}, {"fly", "gimbal", "--set", "environment.surroundings=tunnel"}, 78,
          {"environment.surroundings must be \"gimbal\""});
  Refusal({}, {"fly", "gimbal", "--set", "gimbal.friction_n_m=-1"}, 78, {"gimbal.friction_n_m", "0 to 10"});
  Refusal({}, {"fly", "tunnel_steps", "--set", "environment.surroundings=flight"}, 78,
          {"environment.surroundings must be \"tunnel\""});
  const std::string motor = "big 1 1 0 0.1 0.2 maker\n1 1e9\n2 0\n";
  Refusal({{"m.eng", motor}}, {"fly", "--set", "motor.file=m.eng"}, 78, {"--set motor.file=m.eng", "N s"});
  const std::string slow = "long 1 1 0 0.1 0.2 maker\n1 1\n1e9 0\n";
  Refusal({{"m.eng", slow}}, {"fly", "--set", "motor.file=m.eng"}, 78, {"--set motor.file=m.eng", "600 s"});
}

TEST(Override, MustReadSectionKeyValue) {
  for (const std::string text : {"a=b", "a.b", "=", ".=", "a.=1", ".b=1", "a.b=", "body.mass_kg"}) {
    Refusal({}, {"fly", "--set", text}, 78, {"--set " + text + ": expected section.key=value"});
  }
}

}  // namespace
}  // namespace fantail::test
