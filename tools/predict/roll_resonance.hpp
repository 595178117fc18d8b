// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/analysis.hpp"
#include "predict/run.hpp"
#include "sim/scenario.hpp"

// A rocket that rolls as fast as it swings in pitch is in resonance: its misalignments turn with the body and
// push in step with the swing, the angle of attack grows several times, and the roll may lock in to the swing.
//
// Source: C. P. Hoult and H. Tran, Sounding Rocket Fin Design to Mitigate Roll Lock-In: it usually begins when the
// natural frequency of pitch and yaw equals the roll rate.
namespace fantail::predict {

/// The steady roll rate of a fin angle u is v beta u / alpha, the pitch frequency k v: whether they meet does not
/// depend on the speed, so that a rocket can stay in resonance through all of its flight.
struct RollResonance {
  /// k, from lift-off to after burn-out, the smaller one first.
  double least_frequency_1_m = 0.0;
  double most_frequency_1_m = 0.0;
  campaign::Quantiles resonant_rad{};  ///< over the runs: fin angle that rolls it as fast as it swings; p5 at the least
                                       ///< frequency of a flight, p95 at the most
  std::size_t near = 0;  ///< runs that would stay near the resonance without control, because of their fin offset
  std::size_t past = 0;  ///< runs that would spin up through it
  std::size_t with_canards = 0;  ///< runs that come near it with all canards at their limit in the sense of the offset
  std::size_t runs = 0;
};

/// Empty for a vehicle without airframe, for one that is not stable, and without runs.
[[nodiscard]] std::optional<RollResonance> roll_resonance(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                                          double canard_reach_rad);

/// A clause: in how many runs.
[[nodiscard]] std::string caution(const RollResonance& resonance);

/// For who reads the verdict alone: in how many runs, and what to do.
[[nodiscard]] std::string in_short(const RollResonance& resonance, double canard_reach_rad);

/// The warning; empty where nothing comes near it.
[[nodiscard]] std::string warning(const RollResonance& resonance, double canard_reach_rad);

}  // namespace fantail::predict
