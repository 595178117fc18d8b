// SPDX-License-Identifier: MIT
// Flights that RocketPy computed (test/validation), flown here with the same rocket.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

std::ifstream file(const std::string& name) {
  return std::ifstream{std::string{FANTAIL_TEST_SOURCE} + "/test/validation/" + name};
}

std::vector<input::Override> rocket() {
  std::vector<input::Override> all;
  std::ifstream in = file("peer_rocket.txt");
  for (std::string line; std::getline(in, line);) {
    all.push_back(input::parse_override(line));
  }
  return all;
}

using Figures = std::map<std::string, double>;

std::vector<Figures> peer_flights() {
  std::ifstream in = file("peer_flights.csv");
  std::string line;
  std::getline(in, line);
  std::vector<std::string> names;
  std::istringstream header{line};
  for (std::string name; std::getline(header, name, ',');) {
    names.push_back(name);
  }
  std::vector<Figures> flights;
  while (std::getline(in, line)) {
    std::istringstream row{line};
    Figures& flight = flights.emplace_back();
    for (const std::string& name : names) {
      std::string cell;
      std::getline(row, cell, ',');
      flight[name] = std::stod(cell);
    }
  }
  return flights;
}

TEST(PeerFlight, MovesAsRocketPysRocketDoes) {
  const std::vector<Figures> flights = peer_flights();
  ASSERT_GE(flights.size(), 8U);
  for (const Figures& peer : flights) {
    std::vector<input::Override> changes = rocket();
    ASSERT_GE(changes.size(), 10U);
    for (const auto& [key, name] : {std::pair{"launch_guide.tilt_deg", "guide_tilt_deg"},
                                    {"launch_guide.azimuth_deg", "guide_azimuth_deg"},
                                    {"wind.speed_m_s", "wind_m_s"},
                                    {"wind.from_deg", "wind_from_deg"}}) {
      changes.push_back(input::parse_override(std::string{key} + "=" + std::to_string(peer.at(name))));
    }
    const flight::Flight flight = fly::fly_scenario(input::load_scenario("tasha3_launch2", changes));
    const flight::PathPoint* top = flight::point_at(flight.path, flight.events.apogee_s.value());
    ASSERT_NE(top, nullptr);
    double top_speed_m_s = 0.0;
    for (const flight::PathPoint& point : flight.path) {
      top_speed_m_s = std::max(top_speed_m_s, std::hypot(point.north_m_s, point.east_m_s, point.up_m_s));
    }
    // What is left in wind: RocketPy's lift goes with the angle of attack, ours with its sine.
    const bool calm = peer.at("wind_m_s") == 0.0;
    const std::string flown = "tilt " + std::to_string(peer.at("guide_tilt_deg")) + " deg, wind " +
                              std::to_string(peer.at("wind_m_s")) + " m/s";
    EXPECT_NEAR(top->height_m, peer.at("apogee_m"), (calm ? 0.0005 : 0.002) * peer.at("apogee_m")) << flown;
    EXPECT_NEAR(top_speed_m_s, peer.at("top_speed_m_s"), 0.0005 * peer.at("top_speed_m_s")) << flown;
    EXPECT_NEAR(top->north_m, peer.at("north_m"), calm ? 0.3 : 1.0) << flown;
    EXPECT_NEAR(top->east_m, peer.at("east_m"), calm ? 0.3 : 1.0) << flown;
    EXPECT_NEAR(text::degrees(top->tilt_rad), peer.at("tilt_at_apogee_deg"), calm ? 0.2 : 0.6) << flown;
  }
}

}  // namespace
}  // namespace fantail::sil
