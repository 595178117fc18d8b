// SPDX-License-Identifier: MIT
// What a flight's note says of the wind at its canards.

#include <cmath>

#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

using Changes = std::vector<std::string>;

flight::Flight windy(Changes changes) {
  changes.emplace_back("wind.speed_m_s=6");
  return fly::fly_scenario(input::load_scenario("tasha3_launch2", input::parse_overrides(changes)));
}

std::string wind_note(const flight::Flight& flight) {
  const auto found =
      std::ranges::find_if(flight.notes, [](const std::string& note) { return note.find("guide") != note.npos; });
  return found == flight.notes.end() ? "" : *found;
}

// Its canards stand at trim throughout, whatever the wind does to a rocket on its pad.
TEST(AngleOfAttack, OfAFlightWithoutControlIsNotToldAsOneUnderControl) {
  for (const char* motion : {"flight.motion=six_dof", "flight.motion=straight"}) {
    for (const Changes& why : {Changes{"dormancy.until=height", "dormancy.height_m=5000", motion},
                               Changes{"guide.minimum_speed_m_s=100", motion}}) {
      const std::string note = wind_note(windy(why));
      EXPECT_FALSE(note.empty());
      for (const char* word : {"under control", "of their own", " later"}) {
        EXPECT_FALSE(fantail::says(note, word)) << note;
      }
    }
  }
}

// It coasts from the gate on, and the slower it is, the more the wind turns it.
TEST(AngleOfAttack, BehindAGateCountsDownToTheSpeedOffTheGuide) {
  const flight::Flight flown = windy({"flight.motion=six_dof", "dormancy.until=burn_out", "dormancy.burn_time_s=3.2"});
  const auto speed_m_s = [](const flight::PathPoint& p) { return std::hypot(p.north_m_s, p.east_m_s, p.up_m_s); };
  const double exit_m_s = speed_m_s(*flight::point_at(flown.path, flown.events.guide_clear_s.value()));
  double largest_rad = 0.0;
  double at_start_rad = 0.0;
  for (const flight::PathPoint& point : flown.path) {
    if (point.time_s >= *flown.events.control_start_s && point.time_s <= *flown.events.control_end_s &&
        speed_m_s(point) >= exit_m_s) {
      at_start_rad = at_start_rad == 0.0 ? point.angle_of_attack_rad : at_start_rad;
      largest_rad = std::max(largest_rad, point.angle_of_attack_rad);
    }
  }
  EXPECT_GT(largest_rad, 1.5 * at_start_rad);
  EXPECT_NEAR(flown.extremes.angle_of_attack_rad.value(), largest_rad, 1e-12);
}

TEST(AngleOfAttack, UnderControlIsNoneFromAfterIt) {
  const flight::Flight flown =
      windy({"flight.motion=six_dof", "dormancy.until=burn_out", "dormancy.burn_time_s=3.2", "run.control_time_s=0.5"});
  const double at_s = std::stod(fantail::figures(wind_note(flown)).at(2));
  EXPECT_LE(at_s, flown.events.control_end_s.value() + 0.005) << wind_note(flown);
}

}  // namespace
}  // namespace fantail::sil
