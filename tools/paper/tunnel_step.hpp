// SPDX-License-Identifier: MIT
#pragma once

#include "identify/identification.hpp"
#include "paper/claim.hpp"
#include "paper/published_steps.hpp"
#include "paper/runs.hpp"

namespace fantail::paper {

/// A step of the roll reference at 22 m/s, flown by the real controller for five seconds without noise and servo lag,
/// and logged at 100 Hz as the published ones were.
struct TunnelStep {
  double alpha_m2 = 0.0;
  double beta_m = 0.0;
  double offset_begin_deg = 0.0;
  double offset_end_deg = 0.0;
  double from_deg = 0.0;  ///< roll angle at the begin, at rest
  double to_deg = 45.0;   ///< reference
};
[[nodiscard]] identify::model::Record fly_step(const TunnelStep& step, const sim::Scenario& tunnel);

/// What a reader sees of a step: how far it swings beyond where it ends, and how long it takes from a tenth to nine
/// tenths of its way.
struct StepShape {
  double overshoot_deg = 0.0;
  double rise_s = 0.0;
};
[[nodiscard]] StepShape shape_of(const identify::model::Record& record);

/// A row of Table 2, flown and identified on the published grid.
struct ReadBack {
  identify::model::Record record;
  identify::result::Identification found;
};
[[nodiscard]] ReadBack read_back(const PublishedStep& row, const sim::Scenario& tunnel);
[[nodiscard]] Claim compare(const PublishedStep& row, const ReadBack& ours);

}  // namespace fantail::paper
