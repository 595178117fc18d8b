// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>

#include "dormancy/motor.hpp"
#include "random_stream.hpp"

namespace fantail::dormancy {

inline constexpr double g = 9.80665;
inline constexpr double guide_m = 4.0;

struct Rocket {
  Motor motor;
  double burn_s;
  double thrust_m_s2;  ///< peak thrust over mass on the pad
  double rise_s;
  double propellant;  ///< share of the mass on the pad
  double drag_per_m;  ///< rho CdA / 2 over mass on the pad
  double tilt_rad;    ///< of the guide
  double roll_rad_s;  ///< at 100 m/s; it grows with the speed
  double second;      ///< a second burn: its thrust and its length, as a share of the first; 0: none

  /// What its plan calls the burn time: of the published curves, one after the other.
  [[nodiscard]] double published_burn_s() const {
    return burn_s * (second > 0.0 ? 1.0 + second * motor.published() : motor.published());
  }
};

enum class Story : unsigned char {
  plain,
  chuff,        ///< a short push, a pause on the pad, and then the burn
  misfire,      ///< pushes, but never leaves the guide
  relight,      ///< thrust pauses in the burn
  second_burn,  ///< always, and only, of a rocket that has one
};
inline constexpr std::size_t stories = 5;
[[nodiscard]] std::string_view name(Story story);

/// What this flight's motor does.
struct Burn {
  Story story = Story::plain;
  double burn_s;        ///< of this motor: the published one, give or take
  double thrust;        ///< times that of the rocket
  double from = 0.0;    ///< relight: share of the burn at which it pauses
  double push = 0.0;    ///< chuff and misfire: share of the peak ...
  double push_s = 0.0;  ///< ... for so long
  double pause_s = 0.0;
  double oscillation = 0.0;  ///< amplitude, as a share of the thrust
  double oscillation_rad_s = 0.0;
};

/// The truth, in double precision: a rocket on a rail, then in a gravity turn, in the standard atmosphere. Nothing of
/// the product is used.
class Ascent {
 public:
  Ascent(const Rocket& rocket, const Burn& burn) : rocket_{&rocket}, burn_{burn}, tilt_rad_{rocket.tilt_rad} {}

  void advance(double step_s);

  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] double axial_m_s2() const { return axial_m_s2_; }    ///< specific force
  [[nodiscard]] double across_m_s2() const { return across_m_s2_; }  ///< likewise, upward across the axis
  [[nodiscard]] double tilt_rad() const { return tilt_rad_; }
  [[nodiscard]] double tilt_rate_rad_s() const { return tilt_rate_rad_s_; }
  [[nodiscard]] double roll_rate_rad_s() const { return rocket_->roll_rad_s * speed_m_s_ / 100.0; }
  [[nodiscard]] double speed_m_s() const { return speed_m_s_; }
  [[nodiscard]] double height_m() const { return height_m_; }
  [[nodiscard]] double pressure() const { return pressure_; }  ///< (v / (1 m/s))^2, times density over that at the pad
  [[nodiscard]] double thrust() const { return thrust_; }      ///< share of the peak, without oscillation
  [[nodiscard]] bool is_free() const { return distance_m_ > guide_m; }
  [[nodiscard]] bool is_over() const { return is_free() && speed_m_s_ * std::cos(tilt_rad_) < 3.0; }
  /// No thrust above 2 % of the peak comes after this.
  [[nodiscard]] double last_thrust_s() const;
  /// Relight and second burn: when the pause before the last thrust ends.
  [[nodiscard]] double pause_end_s() const;

 private:
  [[nodiscard]] double thrust_at(double time_s) const;

  const Rocket* rocket_;
  Burn burn_;
  double time_s_ = 0.0;
  double burnt_ = 0.0;  ///< impulse over that of the motor
  double thrust_ = 0.0;
  double speed_m_s_ = 0.0;
  double distance_m_ = 0.0;
  double height_m_ = 0.0;
  double pressure_ = 0.0;
  double tilt_rad_;
  double tilt_rate_rad_s_ = 0.0;
  double axial_m_s2_ = 0.0;
  double across_m_s2_ = 0.0;
};

/// A rocket whose top speed is 60 to 260 m/s, and what its flight comes to.
struct Planned {
  Rocket rocket;
  double top_m_s;
  double apogee_m;
};
[[nodiscard]] Planned draw_rocket(core::RandomStream& random);
[[nodiscard]] Burn draw_burn(const Rocket& rocket, Story story, core::RandomStream& random);

}  // namespace fantail::dormancy
