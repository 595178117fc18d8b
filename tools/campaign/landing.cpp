// SPDX-License-Identifier: MIT
#include "campaign/landing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "campaign/setup.hpp"
#include "fly/to_ground.hpp"
#include "hardover/study.hpp"
#include "runs/runner.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

constexpr std::size_t most_runs = 50;     // each is flown again, and to the ground
constexpr double instants_of_ascent = 6;  // at which a canard fails: 48 flights and more

/// The square of how many standard deviations the region reaches: p = 2 of n landings, where the quantile of F(2, n-2)
/// has a closed form.
double squared_reach(double n) {
  constexpr double outside = 0.05;
  return (n * n - 1.0) / n * (std::pow(outside, -2.0 / (n - 2.0)) - 1.0);
}

OverGround over_ground(const sim::Vector3& at_m) { return {.east_m = -at_m.y, .north_m = at_m.x}; }

void fly_with_a_failed_canard(Landings& landings, const sim::Scenario& scenario, unsigned threads,
                              const std::function<void()>& look) {
  fly::ToGround sound{scenario};
  double ascent_s = 0.0;
  while (sound.tick()) {
    ascent_s = sound.is_ascent() ? sound.after_ignition_s(sound.world().now()) : ascent_s;
  }
  landings.healthy = sound.landing_m() ? std::optional{over_ground(*sound.landing_m())} : std::nullopt;
  try {
    const hardover::Study study = hardover::fly(scenario, {.step_s = ascent_s / instants_of_ascent, .threads = threads},
                                                [&](auto, auto) { look(); });
    landings.failed_flights = study.effects.size();
    landings.failed_step_s = study.options.step_s;
    for (const hardover::Effect& effect : study.effects) {
      landings.failed_away_m = std::max(landings.failed_away_m, effect.landing_away_m);
      landings.failed_without_landing += effect.landing_east_m ? 0 : 1;
    }
  } catch (const text::Error& error) {
    if (error.kind() != text::ErrorKind::bad_configuration) {
      throw;
    }
    landings.why_no_failed = error.what();
  }
}

}  // namespace

bool Ellipse::holds(const OverGround& at) const {
  const double east_m = at.east_m - centre.east_m;
  const double north_m = at.north_m - centre.north_m;
  const double along_m = north_m * std::cos(bearing_rad) + east_m * std::sin(bearing_rad);
  const double across_m = east_m * std::cos(bearing_rad) - north_m * std::sin(bearing_rad);
  return std::hypot(along_m / half_length_m, across_m / half_width_m) <= 1.0;
}

std::vector<OverGround> Ellipse::line(double margin_m) const {
  constexpr int points = 90;
  std::vector<OverGround> all;
  for (int i = 0; i <= points; ++i) {
    const double turn_rad = 2.0 * std::numbers::pi * i / points;
    const double cosine = std::cos(turn_rad);
    const double sine = std::sin(turn_rad);
    const double normal = std::hypot(cosine * half_width_m, sine * half_length_m);
    const double along_m = half_length_m * cosine + margin_m * cosine * half_width_m / normal;
    const double across_m = half_width_m * sine + margin_m * sine * half_length_m / normal;
    all.push_back({.east_m = centre.east_m + along_m * std::sin(bearing_rad) + across_m * std::cos(bearing_rad),
                   .north_m = centre.north_m + along_m * std::cos(bearing_rad) - across_m * std::sin(bearing_rad)});
  }
  return all;
}

std::optional<Ellipse> ellipse_of_next(std::span<const OverGround> landings) {
  if (landings.size() < fewest_landings) {
    return {};
  }
  const auto n = static_cast<double>(landings.size());
  Ellipse ellipse;
  for (const OverGround& at : landings) {
    ellipse.centre.east_m += at.east_m / n;
    ellipse.centre.north_m += at.north_m / n;
  }
  double east_m2 = 0.0;
  double north_m2 = 0.0;
  double both_m2 = 0.0;
  for (const OverGround& at : landings) {
    const double east_m = at.east_m - ellipse.centre.east_m;
    const double north_m = at.north_m - ellipse.centre.north_m;
    east_m2 += east_m * east_m / (n - 1.0);
    north_m2 += north_m * north_m / (n - 1.0);
    both_m2 += east_m * north_m / (n - 1.0);
  }
  // Eigenvalues and the first eigenvector of the covariance matrix.
  const double middle_m2 = 0.5 * (east_m2 + north_m2);
  const double apart_m2 = std::hypot(0.5 * (north_m2 - east_m2), both_m2);
  const double bearing_rad = 0.5 * std::atan2(2.0 * both_m2, north_m2 - east_m2);
  constexpr double least_m = 1e-3;  // landings that lie all in one line, or in one place
  ellipse.bearing_rad = bearing_rad < 0.0 ? bearing_rad + std::numbers::pi : bearing_rad;
  ellipse.half_length_m = std::max(least_m, std::sqrt(squared_reach(n) * (middle_m2 + apart_m2)));
  ellipse.half_width_m = std::max(least_m, std::sqrt(squared_reach(n) * std::max(0.0, middle_m2 - apart_m2)));
  return ellipse;
}

std::optional<Landings> landings_of(const Campaign& campaign, const FlownCampaign& flown, unsigned threads,
                                    const std::function<void()>& look) {
  const sim::Scenario scenario = files_of(campaign).read();
  if (scenario.surroundings != sim::Surroundings::flight || scenario.motion != sim::FlightMotion::six_dof ||
      scenario.path || !fly::has_parachute(scenario.vehicle)) {
    return {};
  }
  std::vector<std::uint64_t> again;
  for (const FlownRun& run : flown.runs) {
    if (again.size() < most_runs && run.outcome != "refused") {
      again.push_back(run.run);
    }
  }
  std::vector<std::optional<sim::Vector3>> at_m(again.size());
  runs::parallel_for(
      again.size(), threads, [&](std::size_t i) { at_m[i] = fly::landing_m(repeat_run(campaign, again[i]).scenario); },
      [&](std::size_t) { look(); });
  Landings landings{.runs = again.size()};
  for (const auto& one : at_m) {
    if (one) {
      landings.landed.push_back(over_ground(*one));
    }
  }
  landings.ellipse = ellipse_of_next(landings.landed);
  if (landings.ellipse) {
    landings.inside = static_cast<std::size_t>(
        std::ranges::count_if(landings.landed, [&](const OverGround& at) { return landings.ellipse->holds(at); }));
  }
  fly_with_a_failed_canard(landings, scenario, threads, look);
  return landings;
}

}  // namespace fantail::campaign
