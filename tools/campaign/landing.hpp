// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "page/chart.hpp"
#include "result/document.hpp"

namespace fantail::campaign {

/// From the foot of the guide.
struct OverGround {
  double east_m = 0.0;
  double north_m = 0.0;
};

/// Where one more landing lies with 95 % probability, if landings are normally distributed: Hotelling's region of
/// prediction, which is wider the fewer landings it is made of.
struct Ellipse {
  OverGround centre{};
  double half_length_m = 0.0;  ///< along its long axis
  double half_width_m = 0.0;
  double bearing_rad = 0.0;  ///< of the long axis, from north over east, 0 to pi

  [[nodiscard]] bool holds(const OverGround& at) const;
  /// Its line, or with `margin_m` the one that lies that far outside of it everywhere; the first point comes again.
  [[nodiscard]] std::vector<OverGround> line(double margin_m = 0.0) const;
};

inline constexpr std::size_t fewest_landings = 10;
/// Empty for fewer landings.
[[nodiscard]] std::optional<Ellipse> ellipse_of_next(std::span<const OverGround> landings);

/// Where the first runs come down under their parachutes, flown again to the ground.
struct Landings {
  std::size_t runs = 0;  ///< flown again
  std::vector<OverGround> landed{};
  std::optional<Ellipse> ellipse{};
  std::size_t inside = 0;               ///< the ellipse, of `landed`
  std::optional<OverGround> healthy{};  ///< the scenario as it stands, without a draw
  /// Largest distance from there at which it lands with one canard at a stop (hardover/study.hpp).
  std::optional<double> failed_away_m{};
  std::size_t failed_flights = 0;
  std::size_t failed_without_landing = 0;  ///< of these
  double failed_step_s = 0.0;              ///< between the instants at which a canard fails
  std::string why_no_failed{};             ///< a clause; empty: they were flown
};

/// Empty for a campaign that does not fly in six degrees of freedom, or without a parachute. `look` is called a few
/// times a second; what it throws ends it.
[[nodiscard]] std::optional<Landings> landings_of(const Campaign& campaign, const FlownCampaign& flown,
                                                  unsigned threads, const std::function<void()>& look);

// Its part of the page.

[[nodiscard]] page::Chart landing_map(const Landings& landings);
[[nodiscard]] std::vector<std::string> landing_sentences(const Landings& landings);
[[nodiscard]] result::Figures landing_figures(const Landings& landings);
[[nodiscard]] result::Listed listed_landing();

}  // namespace fantail::campaign
