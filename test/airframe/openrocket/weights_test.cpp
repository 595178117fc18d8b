// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <string>

#include "design_files.hpp"
#include "figures.hpp"
#include "small_design.hpp"

namespace fantail::airframe::openrocket {
namespace {

using Weights = DesignFiles;

// The tubes of a cluster weigh as many times, and its motors lie away from the axis.
TEST_F(Weights, AClusterHasAsManyTubesAndMotors) {
  const auto mount = [](const std::string& cluster) {
    return "<innertube><name>M</name><position type='bottom'>0</position><material type='bulk' "
           "density='700'>x</material>"
           "<length>0.3</length><outerradius>0.02</outerradius><thickness>0.001</thickness><clusterconfiguration>" +
           cluster +
           "</clusterconfiguration><clusterscale>1.1</clusterscale><motormount><overhang>0</overhang><motor "
           "configid='a'><designation>I1</designation><diameter>0.038</diameter><length>0.25</length></motor>"
           "</motormount></innertube>";
  };
  const Design one = read_design(plain(design(nose + tube(mount("single") + fins("Tail", 3, "0")))));
  const Design four = read_design(plain(design(nose + tube(mount("4-ring") + fins("Tail", 3, "0")))));
  EXPECT_NEAR(part(four, "M").mass_kg, 4.0 * part(one, "M").mass_kg, 1e-12);
  ASSERT_TRUE(four.motor);
  EXPECT_EQ(four.motor->count, 4);
  const double away_m = 1.1 * 0.04 / std::sqrt(2.0);  // half the diagonal of a square of neighbours
  EXPECT_NEAR(four.motor->ring_m, away_m, 1e-12);
  EXPECT_NEAR(part(four, "M").radius_of_gyration_m, std::hypot(part(one, "M").radius_of_gyration_m, away_m), 1e-9);
  EXPECT_TRUE(four.left_out.empty());
  EXPECT_TRUE(says(refusal(plain(design(nose + tube(mount("12-ring"))))), "its cluster is \"12-ring\""));
}

TEST_F(Weights, ShouldersTabsAndFilletsHaveTheirMass) {
  const auto transition = [](const std::string& shoulders) {
    return "<transition><name>T</name><material type='bulk' density='1050'>x</material><length>0.05</length>"
           "<thickness>0.002</thickness><shape>conical</shape><foreradius>0.05</foreradius><aftradius>0.04</"
           "aftradius>" +
           shoulders +
           "</transition><bodytube><name>Rear</name><length>0.3</length><thickness>0.001</thickness><radius>0.04</"
           "radius>"
           "</bodytube>";
  };
  const auto shoulder = [](const std::string& end, const std::string& radius_m) {
    return "<" + end + "shoulderradius>" + radius_m + "</" + end + "shoulderradius><" + end + "shoulderlength>0.05</" +
           end + "shoulderlength><" + end + "shoulderthickness>0.002</" + end + "shoulderthickness>";
  };
  const double without_kg = part(read_design(plain(design(nose + tube("") + transition("")))), "T").mass_kg;
  const auto ring_kg = [](double outer_m) {
    return 1050.0 * pi * (outer_m * outer_m - (outer_m - 0.002) * (outer_m - 0.002)) * 0.05;
  };
  const Design both =
      read_design(plain(design(nose + tube("") + transition(shoulder("fore", "0.048") + shoulder("aft", "0.038")))));
  EXPECT_NEAR(part(both, "T").mass_kg - without_kg, ring_kg(0.048) + ring_kg(0.038), 1e-9);
  const Design capped = read_design(plain(
      design(nose + tube("") + transition(shoulder("aft", "0.038") + "<aftshouldercapped>true</aftshouldercapped>"))));
  EXPECT_NEAR(part(capped, "T").mass_kg - without_kg, ring_kg(0.038) + 1050.0 * pi * 0.036 * 0.036 * 0.002, 1e-9);
  const auto fins_with = [](const std::string& more) {
    std::string set = fins("Tail", 3, "0");
    return set.insert(set.find("</trapezoidfinset>"), more);
  };
  const double bare_kg = part(read_design(plain(design(nose + tube(fins_with(""))))), "Tail").mass_kg;
  const Design tabs = read_design(plain(design(
      nose + tube(fins_with("<tabheight>0.03</tabheight><tablength>0.06</tablength><tabposition relativeto='end'>0"
                            "</tabposition>")))));
  EXPECT_NEAR(part(tabs, "Tail").mass_kg - bare_kg, 3 * 0.03 * 0.06 * 0.004 * 1000.0, 1e-12);
  EXPECT_NEAR(
      part(tabs, "Tail").position_m,
      (bare_kg * (1.4 + 0.06) + (part(tabs, "Tail").mass_kg - bare_kg) * (1.5 - 0.03)) / part(tabs, "Tail").mass_kg,
      1e-9);
  // Against a flat wall a fillet of radius r leaves (1 - pi/4) r^2 of a square; a body of 50 mm is nearly flat to 1 mm
  // (1.5 times their ratio).
  const Design fillets = read_design(plain(design(
      nose + tube(fins_with("<filletradius>0.001</filletradius><filletmaterial density='1850'>x</filletmaterial>")))));
  EXPECT_NEAR((part(fillets, "Tail").mass_kg - bare_kg) / (3 * 2 * (1.0 - pi / 4.0) * 1e-6 * 0.1 * 1850.0), 1.0, 0.04);
  EXPECT_TRUE(fillets.left_out.empty() && tabs.left_out.empty() && both.left_out.empty());
}

TEST_F(Weights, ARingSitsOnTheTubesBesideIt) {
  const std::string ring =
      "<centeringring><name>R</name><axialoffset method='bottom'>0</axialoffset><material type='bulk' density='1000'>x"
      "</material><length>0.01</length><outerradius>auto</outerradius><innerradius>auto</innerradius></centeringring>";
  const std::string inner =
      "<innertube><name>M</name><axialoffset method='bottom'>0</axialoffset><material type='bulk' density='700'>x"
      "</material><length>0.3</length><outerradius>0.02</outerradius><thickness>0.001</thickness></innertube>";
  const auto ring_kg = [&](const std::string& inside) {
    return part(read_design(plain(design(nose + tube(inside)))), "R").mass_kg;
  };
  EXPECT_NEAR(ring_kg(ring + inner), 1000.0 * pi * (0.048 * 0.048 - 0.02 * 0.02) * 0.01, 1e-9);
  EXPECT_NEAR(ring_kg(ring), 1000.0 * pi * 0.048 * 0.048 * 0.01, 1e-9);
}

}  // namespace
}  // namespace fantail::airframe::openrocket
