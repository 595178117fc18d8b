// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace fantail::dormancy {

enum class Family : unsigned char {
  neutral,
  regressive,
  progressive,
  boost_sustain,
  tail,           ///< 2 to 5 % of the peak for the last tenth to third
  unlisted_tail,  ///< the same, and the plan's burn time ends before it
  steep_end,      ///< within 0.4 % of the burn
  erosive_spike,
  hump,
  fading,
};
inline constexpr std::size_t families = 10;
inline constexpr std::size_t variants = 8;
[[nodiscard]] std::string_view name(Family family);

/// One of 80 thrust curves of our own, as public ones look. Thrust is a share of its peak, and time a share of the
/// burn.
class Motor {
 public:
  Motor(Family family, std::size_t variant);

  /// Zero outside of 0 to 1.
  [[nodiscard]] double thrust(double time) const;

  [[nodiscard]] double mean() const { return mean_; }  ///< of the thrust
  /// The last thrust above 2 % of the peak.
  [[nodiscard]] double last_thrust() const { return last_thrust_; }
  /// The plan's burn time: that of the published curve.
  [[nodiscard]] double published() const { return published_; }
  [[nodiscard]] Family family() const { return family_; }

 private:
  [[nodiscard]] double shape(double time) const;

  Family family_;
  double v_;  ///< of the variant: 0 to 1
  double end_;
  double peak_ = 1.0;
  double mean_ = 0.0;
  double last_thrust_ = 0.0;
  double published_ = 0.0;
};

}  // namespace fantail::dormancy
