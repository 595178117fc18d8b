// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fantail::core {

inline constexpr float pi = 3.14159265358979F;

/// A plane angle, kept in radians. Never wrapped: a rocket that has turned three times has a roll angle of 6 pi.
class Angle {
 public:
  constexpr Angle() = default;
  [[nodiscard]] static constexpr Angle from_radians(float value) { return Angle{value}; }
  [[nodiscard]] static constexpr Angle from_degrees(float value) { return Angle{value * (pi / 180.0F)}; }

  [[nodiscard]] constexpr float radians() const { return radians_; }
  [[nodiscard]] constexpr float degrees() const { return radians_ * (180.0F / pi); }

  constexpr Angle operator-() const { return Angle{-radians_}; }
  constexpr Angle& operator+=(Angle other) {
    radians_ += other.radians_;
    return *this;
  }
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle{a.radians_ + b.radians_}; }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle{a.radians_ - b.radians_}; }
  friend constexpr Angle operator*(float factor, Angle a) { return Angle{factor * a.radians_}; }
  friend constexpr Angle operator/(Angle a, float divisor) { return Angle{a.radians_ / divisor}; }
  // Written out: a defaulted <=> of a float first sorts out which of four orderings it is, on every comparison.
  friend constexpr bool operator==(Angle a, Angle b) { return a.radians_ == b.radians_; }
  friend constexpr bool operator<(Angle a, Angle b) { return a.radians_ < b.radians_; }
  friend constexpr bool operator>(Angle a, Angle b) { return a.radians_ > b.radians_; }
  friend constexpr bool operator<=(Angle a, Angle b) { return a.radians_ <= b.radians_; }
  friend constexpr bool operator>=(Angle a, Angle b) { return a.radians_ >= b.radians_; }

 private:
  constexpr explicit Angle(float radians) : radians_{radians} {}
  float radians_ = 0.0F;
};

[[nodiscard]] constexpr Angle abs(Angle a) { return Angle::from_radians(std::abs(a.radians())); }

/// The angle nearest to `a` within [-limit, limit]; limit >= 0. A NaN stays a NaN: whoever commands must have refused
/// it.
[[nodiscard]] constexpr Angle clamp(Angle a, Angle limit) {
  if (abs(a) > limit) {
    return a > Angle{} ? limit : -limit;
  }
  return a;
}

/// From one angle to another that is not smaller.
struct AngleRange {
  Angle lowest;
  Angle highest;
};

[[nodiscard]] constexpr Angle clamp(Angle a, const AngleRange& range) {
  return a < range.lowest ? range.lowest : a > range.highest ? range.highest : a;
}

namespace literals {
constexpr Angle operator""_deg(long double value) { return Angle::from_degrees(static_cast<float>(value)); }
constexpr Angle operator""_deg(unsigned long long value) { return Angle::from_degrees(static_cast<float>(value)); }
constexpr Angle operator""_rad(long double value) { return Angle::from_radians(static_cast<float>(value)); }
}  // namespace literals

}  // namespace fantail::core
