// SPDX-License-Identifier: MIT
#include "page/map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hardover/study.hpp"

namespace fantail::hardover {

namespace {

constexpr double lone_map_width = 560.0;

struct OverGround {
  std::optional<double> east_m;
  std::optional<double> north_m;
};

OverGround apogee_of(const Effect& effect) { return {effect.apogee_east_m, effect.apogee_north_m}; }
OverGround landing_of(const Effect& effect) { return {effect.landing_east_m, effect.landing_north_m}; }

void add(page::Series& series, const OverGround& at) {
  if (at.east_m && at.north_m) {
    series.x.push_back(*at.east_m);
    series.y.push_back(*at.north_m);
  }
}

/// Around the healthy rocket's place, as far as a failed canard takes it from there.
page::Series circle(const OverGround& of_healthy, const std::optional<double>& radius_m) {
  page::Series line{.name = "as far as a failed canard takes it", .role = page::Role::limit};
  constexpr int points = 90;
  for (int i = 0; radius_m && of_healthy.east_m && of_healthy.north_m && i <= points; ++i) {
    const double turn_rad = 2.0 * std::numbers::pi * i / points;
    add(line,
        {*of_healthy.east_m + *radius_m * std::sin(turn_rad), *of_healthy.north_m + *radius_m * std::cos(turn_rad)});
  }
  return line;
}

page::Chart map_of(const Study& study, const char* label, OverGround (*place_of)(const Effect&),
                   const OverGround& of_healthy, const std::optional<double>& reach_of_failure_m) {
  const auto points = [](const char* name, page::Role role, page::Mark mark = page::Mark::points) {
    return page::Series{.name = name, .role = role, .mark = mark};
  };
  const bool two_stops = study.options.failure == Failure::hard_over;
  page::Series positive = points(two_stops ? "at the positive stop" : "pulses cut", page::Role::measured);
  page::Series negative = points("at the negative stop", page::Role::model);
  page::Series healthy = points("healthy rocket", page::Role::second_model, page::Mark::ring);
  page::Series guide = points("launch guide", page::Role::reference, page::Mark::cross);
  for (const Effect& effect : study.effects) {
    add(effect.stop_rad < 0.0 ? negative : positive, place_of(effect));
  }
  add(healthy, of_healthy);
  add(guide, {0.0, 0.0});
  const double width = study.has_parachute ? page::half_page : lone_map_width;  // two stand beside each other
  std::vector<page::Series> series{circle(of_healthy, reach_of_failure_m), positive, negative, healthy, guide};
  std::erase_if(series, [](const page::Series& one) { return one.x.empty(); });
  page::Chart map{.label = label,
                  .x_label = "to the east / m",
                  .y_label = "to the north / m",
                  .width = width,
                  .height = width + 45.0,  // for the legend and the ticks: the frame is about square
                  .series = std::move(series)};
  page::give_one_scale(map);
  return map;
}

}  // namespace

page::Chart apogee_map(const Study& study) {
  return map_of(study, "Where the apogee lies over ground, seen from above", apogee_of,
                {study.sound_apogee_east_m, study.sound_apogee_north_m}, {});
}

std::optional<page::Chart> landing_map(const Study& study) {
  if (std::ranges::none_of(study.effects, [](const Effect& effect) { return effect.landing_east_m.has_value(); })) {
    return {};
  }
  return map_of(study, "Where the rocket lands, seen from above", landing_of,
                {study.sound_landing_east_m, study.sound_landing_north_m}, study.worst().landing_away_m);
}

}  // namespace fantail::hardover
