// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "predict/prediction.hpp"
#include "result/document.hpp"

namespace fantail::predict {

// A prediction before anybody has measured damping, torque and fin offset: for which of them is the roll held?

/// Computed from a shape, damping and torque are right within it.
inline constexpr double assumed_spread = 2.0;
/// From straight fins to the offset that takes all that the canards give, in each sense.
inline constexpr int assumed_offset_steps = 10;

/// One pair of damping and torque, flown with every fin offset.
struct AssumedAirframe {
  double damping_factor = 1.0;  ///< on the vehicle's
  double torque_factor = 1.0;
  double damping_m2 = 0.0;
  double torque_m = 0.0;
  std::optional<double> phase_margin_rad{};  ///< least of all speeds under control; empty: it cannot oscillate
  std::optional<double> held_to_rad{};       ///< with every offset tried up to it, of both senses; empty: with none
  std::optional<double> fails_at_rad{};      ///< the next that was tried; empty: the largest is held
  std::string why{};                         ///< of that, a clause
  std::vector<double> held_rad{};            ///< of those tried, in their order
  std::vector<double> failed_rad{};
};

struct AssumedFins {
  std::string scenario{};
  std::string vehicle{};
  std::string plan_name{};
  std::uint64_t seed = 0;
  Request request{};
  sim::Scenario flown{};
  double asked_phase_margin_rad = 0.0;
  double largest_offset_rad = 0.0;           ///< that was tried
  std::vector<AssumedAirframe> airframes{};  ///< the vehicle as it is, then the corners of the spread
  std::vector<Run> runs{};                   ///< those of each airframe together
  std::vector<std::string> flight_notes{};
  std::string tilt{};          ///< a clause: a point mass passes the tilt limit too early; empty: it does not
  std::string tilt_advice{};   ///< a sentence, or empty
  std::string beyond_model{};  ///< a clause on flights beyond a flight::ModelEnd; empty: there are none
  /// Fin offset over the cant of all fins, with the vehicle's own torque; empty: the vehicle has no shape.
  std::optional<double> offset_per_cant{};
};

/// How many flights assume_fins() flies.
[[nodiscard]] std::size_t assumed_flights();

/// Options::runs and Options::damping have no meaning here. `look` may throw to give up.
[[nodiscard]] AssumedFins assume_fins(const sim::Scenario& scenario, const Options& options,
                                      double asked_phase_margin_rad, const std::function<void(std::size_t done)>& look);

/// No: no fins that were tried meet what is asked. Else undecided: it depends on fins that are not measured, or the
/// flights are outside the model.
[[nodiscard]] result::Document answer(const AssumedFins& assumed, const result::Made& made);

/// For the manual.
[[nodiscard]] result::Listed listed_airframe_fields();

}  // namespace fantail::predict
