// SPDX-License-Identifier: MIT
#include <string>

#include "design_files.hpp"
#include "figures.hpp"

namespace fantail::airframe::openrocket {
namespace {

const std::string rocket =
    "<rocket><name>T</name><subcomponents><stage><name>S</name><subcomponents><nosecone><name>N</name>"
    "<length>0.3</length><thickness>0.002</thickness><shape>conical</shape><aftradius>0.05</aftradius></nosecone>"
    "<bodytube><name>B</name><length>1</length><thickness>0.001</thickness><radius>0.05</radius></bodytube>"
    "</subcomponents></stage></subcomponents></rocket>";

const std::string by_name =
    "Time,Vertical velocity,Mass,CP location,CG location,Stability margin calibers,Angle of attack,Mach number";
const std::string by_key = "time,velocity_z,mass,cp_location,cg_location,stability,aoa,mach_number";

// CP and margin are not numbers on the guide; at the smallest angle of attack the rocket is too fast, or falls.
const std::string series =
    "<datapoint>0,0,3.5,NaN,1.10,NaN,NaN,0</datapoint>"
    "<datapoint>0.2,20,3.4,1.30,1.09,2.1,0.07,0.06</datapoint>"
    "<datapoint>0.5,50,3.3,1.38,1.08,3.0,0.02,0.15</datapoint>"
    "<datapoint>1.0,80,3.2,1.36,1.07,2.9,0.03,0.24</datapoint>"
    "<datapoint>1.5,220,3.1,1.50,1.06,4.4,0.001,0.65</datapoint>"
    "<datapoint>9.0,-5,3.0,1.60,1.05,5.5,0.0,0.01</datapoint>";

std::string flight(const std::string& status, const std::string& types, const std::string& points = series) {
  return "<simulation status='" + status + "'><name>Flight " + status +
         "</name><conditions><configid>one</configid></conditions><flightdata maxaltitude='900'>"
         "<databranch name='S' types='" +
         types + "'>" + points + "</databranch></flightdata></simulation>";
}

class StoredFlights : public DesignFiles {
 protected:
  Design with(const std::string& simulations) {
    return read_design(
        plain("<openrocket version='1.8'>" + rocket + "<simulations>" + simulations + "</simulations></openrocket>"));
  }
  std::vector<StoredFlight> stored(const std::string& simulations) { return with(simulations).flights; }
};

TEST_F(StoredFlights, GiveMassAndCentreOfGravityAtLiftOffAndTheCentreOfPressureOfTheSlowAscent) {
  for (const std::string& types : {by_name, by_key}) {
    const auto flights = stored(flight("uptodate", types));
    ASSERT_EQ(flights.size(), 1U) << types;
    EXPECT_EQ(flights[0].name, "Flight uptodate");
    EXPECT_EQ(flights[0].configuration, "one");
    EXPECT_DOUBLE_EQ(*flights[0].mass_kg, 3.5);
    EXPECT_DOUBLE_EQ(*flights[0].centre_of_gravity_m, 1.10);
    EXPECT_DOUBLE_EQ(*flights[0].centre_of_pressure_m, 1.38);
    EXPECT_DOUBLE_EQ(flights[0].angle_of_attack_rad, 0.02);
    EXPECT_DOUBLE_EQ(*flights[0].margin_calibres, 3.0);
  }
}

TEST_F(StoredFlights, ThatDoNotBelongToTheDesignAsItIsAreLeftOut) {
  for (const char* status : {"outdated", "notsimulated", "cantrun", "aborted", ""}) {
    EXPECT_TRUE(stored(flight(status, by_name)).empty()) << status;
  }
  EXPECT_EQ(stored(flight("outdated", by_name) + flight("loaded", by_name)).at(0).name, "Flight loaded");
}

TEST_F(StoredFlights, WithoutNumbersAreLeftOut) {
  EXPECT_TRUE(stored("").empty());
  EXPECT_TRUE(stored("<simulation status='uptodate'><flightdata maxaltitude='900'/></simulation>").empty());
  EXPECT_TRUE(stored(flight("uptodate", "Zeit,Masse")).empty());
  EXPECT_TRUE(stored(flight("uptodate", by_name, "")).empty());
  EXPECT_TRUE(stored(flight("uptodate", by_name, "<datapoint>0,0</datapoint><datapoint>x,,</datapoint>")).empty());
  const auto only_mass = stored(flight("uptodate", "Mass", "<datapoint>2.5E0</datapoint>"));
  ASSERT_EQ(only_mass.size(), 1U);
  EXPECT_DOUBLE_EQ(*only_mass[0].mass_kg, 2.5);
  EXPECT_FALSE(only_mass[0].centre_of_pressure_m);
}

TEST_F(StoredFlights, OfZerosOrOtherNumbersThatNoRocketHasAreLeftOutWithAWord) {
  for (const auto& [numbers, what, value] :
       {std::tuple{"0,0,0,0,0,0,0,0", "mass", "0"}, std::tuple{"0,0,-2,1.3,1.1,2,0,0", "mass", "-2"},
        std::tuple{"0,0,3,1.3,0,2,0,0", "centre of gravity", "0"},
        std::tuple{"0,0,3,99,1,2,0,0", "centre of pressure", "99"}}) {
    const Design design = with(flight("uptodate", by_name, std::string{"<datapoint>"} + numbers + "</datapoint>"));
    EXPECT_TRUE(design.flights.empty()) << numbers;
    ASSERT_EQ(design.not_used.size(), 1U) << numbers;
    EXPECT_TRUE(design.not_used[0].starts_with("Simulation \"Flight uptodate\"")) << design.not_used[0];
    EXPECT_NE(design.not_used[0].find(what), std::string::npos) << design.not_used[0];
    EXPECT_EQ(figures(design.not_used[0]), std::vector<std::string>{value});
  }
}

TEST_F(StoredFlights, AtLargeAnglesOfAttackSayNothingOfTheCentreOfPressure) {
  const auto flights = stored(flight("uptodate", by_name, "<datapoint>0,9,3,1.2,1.0,2,0.2,0.1</datapoint>"));
  ASSERT_EQ(flights.size(), 1U);
  EXPECT_FALSE(flights[0].centre_of_pressure_m);
  EXPECT_TRUE(flights[0].mass_kg);
}

TEST(MotorNames, AreTheSameByClassAndMeanThrust) {
  const MotorPlace place{.motors = {{.configuration = "a", .designation = "1115-I150WH-14A", .length_m = 0.2},
                                    {.configuration = "b", .designation = "J99", .length_m = 0.3},
                                    {.configuration = "c", .designation = "i150"}}};
  ASSERT_EQ(place.called("I150").size(), 2U);
  EXPECT_EQ(place.called("I150").front().configuration, "a");
  EXPECT_EQ(place.called("Cesaroni_J99-9").size(), 1U);
  EXPECT_TRUE(place.called("I15").empty());
  EXPECT_TRUE(place.called("K150").empty());
}

}  // namespace
}  // namespace fantail::airframe::openrocket
