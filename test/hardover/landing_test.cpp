// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "studies.hpp"
#include "test.hpp"

namespace fantail::hardover {
namespace {

// Full of air it sinks with sqrt(2 m g / (rho CdA)) and goes with the wind, which comes from the north.
TEST(Hardover, UnderAParachuteARocketLandsFromItsApogeeAsFarDownwindAsTheWindGoesMeanwhile) {
  const std::vector<std::string> changes{"wind.speed_m_s=3", "recovery.drag_area_m2=0.8"};
  const Study found = study(changes, {.step_s = 6.0, .coupler_m = {}, .threads = 2});
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
  const double mass_kg = scenario.vehicle.mass_kg - scenario.vehicle.motor.propellant_kg();
  const double density_kg_m3 = scenario.atmosphere.density_kg_m3(200.0);
  const double sinks_m_s = std::sqrt(2.0 * mass_kg * 9.80665 / (density_kg_m3 * (0.8 + scenario.vehicle.drag_area_m2)));
  const double drift_m = found.sound_apogee_north_m - found.sound_landing_north_m.value();
  EXPECT_NEAR(drift_m, 3.0 * found.sound_apogee_m / sinks_m_s, 0.08 * drift_m);
  constexpr double carried_m = 25.0;  // by its speed at apogee, where it was turned early
  for (const Effect& one : found.effects) {
    EXPECT_NEAR(one.apogee_north_m - one.landing_north_m.value(), 3.0 * one.apogee_m / sinks_m_s, carried_m)
        << one.from_s;
    EXPECT_NEAR(one.landing_away_m.value(),
                std::hypot(*one.landing_east_m - *found.sound_landing_east_m,
                           *one.landing_north_m - *found.sound_landing_north_m),
                1e-9);
  }
  EXPECT_NE(text_of(found).find("under the parachute"), std::string::npos) << text_of(found);
  const page::Chart map = landing_map(found).value();
  EXPECT_EQ(map.series.back().x.size(), 1U) << "the guide";
  const page::Series& circle = map.series.front();
  for (std::size_t i = 0; i < circle.x.size(); ++i) {
    EXPECT_NEAR(std::hypot(circle.x[i] - *found.sound_landing_east_m, circle.y[i] - *found.sound_landing_north_m),
                found.worst().landing_away_m.value(), 1e-6);
  }
  const std::string drawn = page::svg(map);
  for (const char* const lone : {"second\" data-name=\"healthy rocket", "reference\" data-name=\"launch guide"}) {
    EXPECT_GT(drawn.find(lone), drawn.find("data-name=\"at the negative stop")) << lone << " is drawn on top";
  }
  EXPECT_NEAR(map.x_range->high - map.x_range->low, map.y_range->high - map.y_range->low, 1e-9);
}

// From then on it falls freely (g t^2 / 2) before the parachute holds it; the wind carries it only under the parachute.
TEST(Hardover, HoweverLateTheParachuteOpensEachFlightGoesOnToTheGround) {
  for (const double delay_s : {0.99, 1.0, 3.0}) {
    const std::vector<std::string> changes{"wind.speed_m_s=3", "recovery.drag_area_m2=0.8",
                                           fmt::format("recovery.delay_s={}", delay_s)};
    const Study found = study(changes, {.step_s = 6.0, .coupler_m = {}, .threads = 2});
    const sim::Scenario scenario = input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
    const double mass_kg = scenario.vehicle.mass_kg - scenario.vehicle.motor.propellant_kg();
    const double density_kg_m3 = scenario.atmosphere.density_kg_m3(200.0);
    const double sinks_m_s =
        std::sqrt(2.0 * mass_kg * 9.80665 / (density_kg_m3 * (0.8 + scenario.vehicle.drag_area_m2)));
    const double held_m = found.sound_apogee_m - 0.5 * 9.80665 * delay_s * delay_s;
    const double drift_m = found.sound_apogee_north_m - found.sound_landing_north_m.value();
    EXPECT_NEAR(drift_m, 3.0 * held_m / sinks_m_s, 0.1 * drift_m) << delay_s;
    double farthest_m = 0.0;
    for (const Effect& one : found.effects) {
      EXPECT_EQ(one.landing_from_guide_m.value(), std::hypot(one.landing_east_m.value(), one.landing_north_m.value()));
      farthest_m = std::max(farthest_m, *one.landing_from_guide_m);
    }
    EXPECT_EQ(found.worst().landing_from_guide_m, farthest_m);
    EXPECT_EQ(text_of(found).find("no landing point"), std::string::npos) << text_of(found);
    EXPECT_NE(page_of(found).find("Apogee and landing"), std::string::npos);
  }
}

TEST(Hardover, HowLongTheRunOfTheScenarioGoesOnAfterApogeeChangesNothing) {
  const Options few{.step_s = 6.0, .coupler_m = {}, .threads = 2};
  const Study usual = study({"wind.speed_m_s=3", "recovery.drag_area_m2=0.8"}, few);
  for (const char* const end : {"timing.time_after_end_s=0", "timing.time_after_end_s=300"}) {
    EXPECT_EQ(json_of(study({"wind.speed_m_s=3", "recovery.drag_area_m2=0.8", end}, few)), json_of(usual)) << end;
  }
}

TEST(Hardover, WithoutAParachuteNoLandingPointIsInventedAndThatIsSaid) {
  for (const std::vector<std::string>& changes :
       {std::vector<std::string>{}, {"recovery.drag_area_m2=0"}, {"recovery.delay_s=60"}}) {
    const Study found = study(changes, {.step_s = 9.0, .coupler_m = {}, .threads = 2});
    EXPECT_FALSE(found.sound_landing_east_m);
    EXPECT_FALSE(landing_map(found).has_value());
    EXPECT_EQ(page_of(found).find("Apogee and landing"), std::string::npos);
    const std::string text = text_of(found);
    EXPECT_EQ(text.find("landing shift"), std::string::npos) << text;
    EXPECT_EQ(text.find("and the landing point"), std::string::npos) << text;
    EXPECT_NE(text.find(found.has_parachute ? "flights have no landing point" : "Landing points are not known"),
              std::string::npos)
        << text;
  }
}

}  // namespace
}  // namespace fantail::hardover
