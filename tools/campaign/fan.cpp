// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "campaign/campaign.hpp"
#include "campaign/results.hpp"
#include "fly/fly_scenario.hpp"
#include "text/degrees.hpp"

namespace fantail::campaign {
namespace {

constexpr std::size_t most_runs = 50;  // a band of 5 to 95 % needs no more, and each is flown again
constexpr double step_s = 0.05;
constexpr double fewest_share = 0.5;  // of the runs: where fewer still fly, their quantiles are of another group

using text::degrees;

struct Track {
  std::vector<double> roll_rad{};
  std::vector<double> reference_rad{};  ///< not a number outside control
};

/// The true roll from lift-off (in the tunnel from control start) to apogee, every step_s.
Track track_of(const sim::Scenario& scenario) {
  Track track;
  std::optional<double> zero_s;
  (void)fly::fly_without_rows(scenario, [&](const flight::Row& row, const flight::Flight& so_far) {
    if (!zero_s) {
      zero_s =
          scenario.surroundings == sim::Surroundings::tunnel ? so_far.events.control_start_s : so_far.events.liftoff_s;
    }
    if (!zero_s || !row.truth || so_far.events.apogee_s) {
      return;
    }
    if (row.time_s - *zero_s >= step_s * static_cast<double>(track.roll_rad.size()) - 1e-9) {
      track.roll_rad.push_back(row.truth->roll_angle_rad);
      track.reference_rad.push_back(row.phase == core::Phase::controlling ? row.reference_rad
                                                                          : std::numeric_limits<double>::quiet_NaN());
    }
  });
  return track;
}

}  // namespace

Fan fan_of(const Campaign& campaign, const FlownCampaign& flown, const std::function<void()>& look) {
  std::vector<Track> tracks;
  bool in_tunnel = false;
  for (const FlownRun& run : flown.runs) {
    if (tracks.size() == most_runs) {
      break;
    }
    if (run.outcome != "refused") {
      look();
      const sim::Scenario scenario = repeat_run(campaign, run.run).scenario;
      in_tunnel = scenario.surroundings == sim::Surroundings::tunnel;
      tracks.push_back(track_of(scenario));
    }
  }
  std::erase_if(tracks, [](const Track& track) { return track.roll_rad.empty(); });
  Fan fan{.runs = tracks.size(), .in_tunnel = in_tunnel};
  for (std::size_t i = 0;; ++i) {
    std::vector<double> roll;
    double reference_rad = std::numeric_limits<double>::quiet_NaN();
    for (const Track& track : tracks) {
      if (i < track.roll_rad.size()) {
        roll.push_back(track.roll_rad[i]);
        reference_rad = std::isfinite(reference_rad) ? reference_rad : track.reference_rad[i];
      }
    }
    if (roll.empty() || static_cast<double>(roll.size()) < fewest_share * static_cast<double>(tracks.size())) {
      return fan;
    }
    fan.time_s.push_back(step_s * static_cast<double>(i));
    fan.roll_rad.push_back(quantiles(std::move(roll)));
    fan.reference_rad.push_back(reference_rad);
  }
}

page::Chart fan_chart(const Fan& fan) {
  page::Series middle{.name = "middle of the runs", .role = page::Role::model, .x = fan.time_s};
  page::Series reference{.name = "reference", .role = page::Role::reference, .mark = page::Mark::step, .x = fan.time_s};
  page::Area band{.name = "5 to 95 % of the runs", .role = page::Role::model, .x = fan.time_s};
  for (std::size_t i = 0; i < fan.time_s.size(); ++i) {
    middle.y.push_back(degrees(fan.roll_rad[i].p50));
    band.low.push_back(degrees(fan.roll_rad[i].p5));
    band.high.push_back(degrees(fan.roll_rad[i].p95));
    reference.y.push_back(degrees(fan.reference_rad[i]));
  }
  return {.label = "Roll angle of the runs over time",
          .x_label = fan.in_tunnel ? "time after control start / s" : "time after lift-off / s",
          .y_label = "roll angle / deg",
          .series = {middle, reference},
          .areas = {band}};
}

}  // namespace fantail::campaign
