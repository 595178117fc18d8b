// SPDX-License-Identifier: MIT
#include <algorithm>

#include "campaign/campaign.hpp"
#include "campaign/results.hpp"
#include "fly/fly_scenario.hpp"

namespace fantail::campaign {
namespace {

constexpr std::size_t most_runs_of_band = 50;  // a band of 5 to 95 % needs no more, and each is flown again
constexpr double step_s = 0.05;
constexpr double least_share = 0.5;  // where fewer still fly, their quantiles are those of another group

struct Track {
  std::vector<double> roll_rad{};
  std::vector<std::optional<double>> reference_rad{};  ///< empty outside control
};

/// The true roll from lift-off (in the tunnel from control start) until control ends, at apogee at the latest, every
/// step_s.
Track track_of(const sim::Scenario& scenario) {
  Track track;
  std::optional<double> zero_s;
  (void)fly::fly_without_rows(scenario, [&](const flight::Row& row, const flight::Flight& so_far) {
    if (!zero_s) {
      zero_s =
          scenario.surroundings == sim::Surroundings::tunnel ? so_far.events.control_start_s : so_far.events.liftoff_s;
    }
    if (!zero_s || !row.truth || so_far.events.apogee_s || so_far.events.control_end_s) {
      return;
    }
    if (row.time_s - *zero_s >= step_s * static_cast<double>(track.roll_rad.size()) - 1e-9) {
      track.roll_rad.push_back(row.truth->roll_angle_rad);
      track.reference_rad.push_back(row.phase == core::Phase::controlling ? std::optional{row.reference_rad}
                                                                          : std::nullopt);
    }
  });
  return track;
}

/// That of the first run that is under control there.
std::optional<double> reference_rad(const std::vector<Track>& tracks, std::size_t place) {
  for (const Track& track : tracks) {
    if (place < track.reference_rad.size() && track.reference_rad[place]) {
      return track.reference_rad[place];
    }
  }
  return {};
}

}  // namespace

RollBand roll_band_of(const Campaign& campaign, const FlownCampaign& flown, const std::function<void()>& look) {
  RollBand band;
  std::vector<Track> tracks;
  for (const FlownRun& run : flown.runs) {
    if (tracks.size() == most_runs_of_band) {
      break;
    }
    if (run.outcome == "refused") {
      continue;
    }
    look();
    const sim::Scenario scenario = repeat_run(campaign, run.run).scenario;
    band.in_tunnel = scenario.surroundings == sim::Surroundings::tunnel;
    if (Track track = track_of(scenario); !track.roll_rad.empty()) {
      tracks.push_back(std::move(track));
    }
  }
  band.runs = tracks.size();
  std::vector<std::span<const double>> angles;
  for (const Track& track : tracks) {
    angles.emplace_back(track.roll_rad);
  }
  for (const Quantiles& roll_rad : quantiles_over(angles, least_share)) {
    const std::size_t place = band.instants.size();
    band.instants.push_back({.time_s = step_s * static_cast<double>(place),
                             .roll_rad = roll_rad,
                             .reference_rad = reference_rad(tracks, place)});
  }
  return band;
}

}  // namespace fantail::campaign
