// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace fantail::core {

/// The float nearest to pi.
inline constexpr float pi = 3.14159265358979F;

/// A plane angle, kept in radians. Never wrapped: a rocket that has turned three times has a roll angle of 6 pi.
class Angle {
 public:
  constexpr Angle() = default;
  /// Takes every value as it is, a NaN too: who takes an angle from outside checks it with is_finite().
  [[nodiscard]] static constexpr Angle from_radians(float value) { return Angle{value}; }
  /// `value` times pi / 180, as floats: degrees() may differ from `value` in the last bits.
  [[nodiscard]] static constexpr Angle from_degrees(float value) { return Angle{value * (pi / 180.0F)}; }

  /// What is kept, without any rounding.
  [[nodiscard]] constexpr float radians() const { return radians_; }
  /// For people and files; all laws reckon in radians.
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

/// Without its sign. A NaN stays a NaN.
[[nodiscard]] constexpr Angle abs(Angle a) { return Angle::from_radians(std::abs(a.radians())); }

/// The angle nearest to `a` within [-limit, limit]; limit >= 0. A NaN stays a NaN: whoever commands must have refused
/// it.
[[nodiscard]] constexpr Angle clamp(Angle a, Angle limit) {
  if (abs(a) > limit) {
    return a > Angle{} ? limit : -limit;
  }
  return a;
}

/// From `lowest` to `highest`, both within it. Nothing checks that `highest` is not the smaller one.
struct AngleRange {
  Angle lowest;
  Angle highest;
};

/// The angle nearest to `a` within the range. A NaN stays a NaN, as above.
[[nodiscard]] constexpr Angle clamp(Angle a, const AngleRange& range) {
  return a < range.lowest ? range.lowest : a > range.highest ? range.highest : a;
}

namespace literals {
/// For constants in code: `9_deg`, `0.5_deg`.
constexpr Angle operator""_deg(long double value) { return Angle::from_degrees(static_cast<float>(value)); }
constexpr Angle operator""_deg(unsigned long long value) { return Angle::from_degrees(static_cast<float>(value)); }
/// `0.5_rad`. A whole number needs its point: there is no `1_rad`.
constexpr Angle operator""_rad(long double value) { return Angle::from_radians(static_cast<float>(value)); }
}  // namespace literals

}  // namespace fantail::core
