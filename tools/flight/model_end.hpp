// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace fantail::flight {

/// Above this nothing in the simulation of roll holds: its coefficients are for slower air.
inline constexpr double model_ends_at_mach = 0.8;
/// At about this angle to the flow fins and canards stall, and the simulated forces grow on.
inline constexpr double model_ends_at_attack_rad = 15.0 * std::numbers::pi / 180.0;

/// What tells of a simulated flight whether the simulation of roll holds for it; empty: not known, or not there.
struct Extremes {
  std::optional<double> top_mach{};
  std::optional<double> static_margin_calibres{};  ///< the least of the flight, as the vehicle states its centres
  /// The largest under control, as fast as at its beginning or faster: slower air turns nothing.
  std::optional<double> angle_of_attack_rad{};
};

/// Where the simulation of roll ends.
enum class ModelEnd : std::uint8_t { mach, stability, attack };
inline constexpr std::array model_ends{ModelEnd::mach, ModelEnd::stability, ModelEnd::attack};

/// What is not known is not beyond.
[[nodiscard]] bool is_beyond(ModelEnd end, const Extremes& extremes);
[[nodiscard]] bool is_beyond_model(const Extremes& extremes);

/// Of several flights those that are nearest to the ends, or farthest beyond.
[[nodiscard]] Extremes worst_of(const std::vector<Extremes>& flights);

/// How far one flight, or the worst of some, is beyond the model, and where that ends, a clause for each end; empty:
/// nowhere.
[[nodiscard]] std::string how_far_beyond(const Extremes& worst);

/// "Outside the model: up to Mach 1.27, ... . ", to stand before a verdict; empty: `beyond`, of one of these two, is.
[[nodiscard]] std::string outside_model(const std::string& beyond);

/// Which flights of many are beyond, and how far: "20 of 60 runs are faster than Mach 0.8, up to Mach 1.27"; empty:
/// none.
[[nodiscard]] std::string which_are_beyond(const std::vector<Extremes>& runs);

/// "at most Mach 0.8", for each of the ends that a flight is beyond.
[[nodiscard]] std::string what_the_model_asks(const Extremes& worst);

}  // namespace fantail::flight
