// SPDX-License-Identifier: MIT

#include <array>
#include <future>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

TEST(Airframe, SaysTheSameInTextPageAndJson) {
  const Folder folder;
  const Outcome said = fantail({"airframe", "tasha3_launch2", "--out", folder / "a"});
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(folder.listing(), (Words{"a", "a/airframe.html", "a/airframe.json"}));
  const json::Value figures = json::parse(content(folder.path() / "a/airframe.json"));
  EXPECT_EQ(figures["stability"], "stable");
  EXPECT_NE(said.out.find(figures["sentence"].text()), std::string::npos);
  const std::string page = content(folder.path() / "a/airframe.html");
  EXPECT_NE(page.find("The static margin is 1.43 calibres at lift-off"), std::string::npos);  // then an escape
  EXPECT_NE(page.find("<svg"), std::string::npos);
  const Outcome printed = fantail({"airframe", "tasha3_launch2", "--json", "--out", folder / "b"});
  EXPECT_EQ(json::parse(printed.out), figures);
}

TEST(Airframe, WritesAChangedVehicleElsewhere) {
  const Folder folder;
  const Outcome said = fantail({"airframe", "smokey", "--set", "fins.span_m=0.07"}, {.working_folder = folder.path()});
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_NE(said.out.find("out/airframe/smokey+fins.span_m=0.07/airframe.html"), std::string::npos) << said.out;
}

TEST(Airframe, RefusesAVehicleWithoutAShape) {
  Refusal({}, {"airframe", "tasha3_bench"}, 78, {"tasha3_bench.toml", "has no section [shape]"});
  Refusal({}, {"airframe", "tasha3_launch2", "--set", "fins.span_m=-1"}, 78, {"fins.span_m = -1 is out of range"});
  Refusal({}, {"airframe", "smoky"}, 66, {"did you mean smokey?"});
}

TEST(NewRocket, FliesFromTheFilesThatAreMade) {
  const Folder folder;
  const Outcome made = fantail({"new", "my rocket", "--from", "tasha3_launch2"}, {.working_folder = folder.path()});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("fantail rules irec 'my rocket/scenario.toml' (most ranges ask for [dormancy] and "
                          "run.abort_input in plan.toml)\n"),
            std::string::npos)
      << made.out;
  EXPECT_EQ(folder.listing(),
            (Words{"my rocket", "my rocket/plan.toml", "my rocket/scenario.toml", "my rocket/vehicle.toml"}));
  const Outcome flown = fantail({"fly", "my rocket/scenario.toml"}, {.working_folder = folder.path()});
  EXPECT_EQ(flown.exit_code, 0) << flown.err;
  EXPECT_EQ(flown.err, "");
}

// 3000 N for a second make 4 kg some 600 m/s fast, and the shipped motor makes them 82.
TEST(NewRocket, SaysWhereItsMotorTakesItOutOfTheModel) {
  const Folder folder;
  std::ofstream{folder.path() / "fast.eng"} << "fast 54 200 0 0.6 1.0 x\n0.02 3000\n1 3000\n1.05 0\n";
  const Outcome fast =
      fantail({"new", "fast", "--from", "tasha3_launch2", "--motor", "fast.eng"}, {.working_folder = folder.path()});
  EXPECT_EQ(fast.exit_code, 0) << fast.err;
  EXPECT_NE(fast.out.find("Outside the model: up to Mach 1."), std::string::npos) << fast.out;
  const Outcome slow = fantail({"new", "slow", "--from", "tasha3_launch2"}, {.working_folder = folder.path()});
  EXPECT_EQ(slow.out.find("Outside the model"), std::string::npos) << slow.out;
}

// What new says of a first flight is what fly says of it.
TEST(NewRocket, SaysTheVerdictOnItsFirstFlight) {
  const Folder folder;
  const Outcome made = fantail({"new", "mine", "--from", "tasha3_launch2"}, {.working_folder = folder.path()});
  const Outcome flown = fantail({"fly", "mine/scenario.toml", "--json"}, {.working_folder = folder.path()});
  const json::Value said = json::parse(flown.out);
  EXPECT_EQ(said["outcome"], "held");
  EXPECT_NE(made.out.find("First flight: Held: " + said["sentence"].text()), std::string::npos) << made.out;
}

// Its parts weigh 3.764 kg. Computed from them, the propellant that moves the balance of 5.75 kg lay behind the tail.
TEST(NewRocket, IsNotMadeOfPartsThatCannotBalanceItsMass) {
  const Folder shapes;
  ASSERT_EQ(fantail({"new", "first", "--from", "tasha3_launch2"}, {.working_folder = shapes.path()}).exit_code, 0);
  std::string edited = content(shapes.path() / "first/vehicle.toml");
  const std::size_t mass = edited.find("\nmass_kg = 3.99\n");
  ASSERT_NE(mass, std::string::npos);
  edited.replace(mass, 16, "\nmass_kg = 5.75\n");
  Refusal({{"edited.toml", edited}}, {"new", "mine", "--from", "edited.toml", "--motor", "i150_canonical"}, 78,
          {"edited.toml: cannot be made into a vehicle: the parts in [masses] weigh 3.764 kg", "5.524 kg, 47 % more",
           "centre_of_gravity_after_burnout_m"});
}

// 3.99 kg with 226 g of propellant.
TEST(NewRocket, WeighsAsMuchMoreAsItsNewMotorsPropellant) {
  const Folder folder;
  std::ofstream{folder.path() / "big.eng"} << "big 54 200 0 0.326 0.6 x\n0.05 200\n3 200\n3.1 0\n";
  const Outcome made =
      fantail({"new", "mine", "--from", "tasha3_launch2", "--motor", "big.eng"}, {.working_folder = folder.path()});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(content(folder.path() / "mine/vehicle.toml").find("\nmass_kg = 4.09\n"), std::string::npos);
  EXPECT_NE(made.out.find("with this motor's propellant instead of its own"), std::string::npos) << made.out;
  EXPECT_EQ(made.out.find("parts are missing"), std::string::npos) << made.out;
}

// Whoever came second once replaced the rocket of the first, and both were told of theirs.
TEST(NewRocket, OfOneNameIsMadeOnceByTwoAtOnce) {
  const Folder folder;
  const auto make = [&folder](const char* source) {
    return std::async(std::launch::async, [&folder, source] {
      return fantail({"new", "mine", "--from", source}, {.working_folder = folder.path()});
    });
  };
  std::array both{make("tasha3_launch2"), make("smokey")};
  const std::array ended{both[0].get(), both[1].get()};
  const bool first_has_it = ended[0].exit_code == 0;
  const Outcome& refused = ended.at(first_has_it ? 1 : 0);
  EXPECT_EQ(ended.at(first_has_it ? 0 : 1).exit_code, 0);
  EXPECT_EQ(refused.exit_code, 64);
  EXPECT_NE(refused.err.find("mine already exists"), std::string::npos) << refused.err;
  EXPECT_NE(
      content(folder.path() / "mine/vehicle.toml").find(first_has_it ? "from tasha3_launch2.toml" : "from smokey.toml"),
      std::string::npos);
}

// A team's own source: what it computes itself need not be there, and what the shape says nothing of is kept.
TEST(NewRocket, KeepsParachuteServosAndSensorsOfASourceWithoutARollModelAndNamesWhatItLeaves) {
  const Folder folder;
  ASSERT_EQ(fantail({"new", "first", "--from", "kestrel"}, {.working_folder = folder.path()}).exit_code, 0);
  std::string source = content(folder.path() / "first/vehicle.toml");
  const std::size_t air = source.find("[aerodynamics]");
  source.erase(air, source.find("[shape]") - air);
  source.erase(source.find("roll_inertia_kg_m2"), std::string_view{"roll_inertia_kg_m2 = 0.0694766\n"}.size());
  source.insert(source.find("mass_kg"), "drag_mach = [0, 0.8, 1]\ndrag_factor = [1, 1.1, 2]\n");
  source += "lag_s = 0.03\n\n[canard_mounting]\ndirection = [\"reversed\", \"normal\", \"normal\", \"normal\"]\n";
  source += "\n[imu]\nto_nose = \"+y\"\nalong_y = \"-x\"\nfull_scale_deg_s = 1000\n";
  std::ofstream{folder.path() / "own.toml"} << source;
  const Outcome made = fantail({"new", "mine", "--from", "own.toml"}, {.working_folder = folder.path()});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string vehicle = content(folder.path() / "mine/vehicle.toml");
  for (const char* kept :
       {"drag_mach = [0, 0.8, 1]\ndrag_factor = [1, 1.1, 2]\n", "[recovery]\ndrag_area_m2 = 0.55\ndelay_s = 1\n",
        "[servo]\nlag_s = 0.03\ntorque_n_m = 1.5\n", "[imu]\nfull_scale_deg_s = 1000\n",
        "roll_inertia_kg_m2 = 0.0694766\n", "torque_m = 0.16338 "}) {
    EXPECT_NE(vehicle.find(kept), std::string::npos) << kept << vehicle;
  }
  EXPECT_NE(made.out.find("Not taken over: canard_mounting.direction, imu.to_nose, imu.along_y."), std::string::npos)
      << made.out;
  EXPECT_NE(made.out.find("a servo lag of 30 ms"), std::string::npos) << made.out;
}

// What it wrote itself is no reason for a warning.
TEST(NewRocket, HasAPlanThatPlanCheckTakesWithoutAWarning) {
  const Folder folder;
  for (const char* source : {"tasha3_launch2", "smokey", "kestrel"}) {
    ASSERT_EQ(fantail({"new", source, "--from", source}, {.working_folder = folder.path()}).exit_code, 0);
    const Outcome checked =
        fantail({"plan", "check", source + std::string{"/scenario.toml"}}, {.working_folder = folder.path()});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_EQ(checked.out.find("warning"), std::string::npos) << checked.out;
  }
}

TEST(NewRocket, MayLieInAnotherFolderAndIsNamedAfterTheLastOne) {
  const Folder folder;
  folder.write("here/notes.txt", "dear");
  const Outcome made =
      fantail({"new", "../rockets/mine/", "--from", "smokey"}, {.working_folder = folder.path() / "here"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(content(folder.path() / "rockets/mine/vehicle.toml").find("name = \"mine\""), std::string::npos);
  EXPECT_NE(made.out.find("fantail fly ../rockets/mine/scenario.toml\n"), std::string::npos) << made.out;
  Refusal({}, {"new", "/", "--from", "smokey"}, 64, {"\"/\" names no new folder"});
}

TEST(NewRocket, NeverTouchesWhatIsThere) {
  Refusal({{"mine/notes.txt", "dear"}}, {"new", "mine", "--from", "tasha3_launch2"}, 64, {"mine already exists"});
  Refusal({}, {"new", "mine", "--from", "tasha3_bench"}, 78, {"has no section [shape]"});
  Refusal({}, {"new", "mine"}, 64, {"--from"});
}

}  // namespace
}  // namespace fantail::test
