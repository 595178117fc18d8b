// SPDX-License-Identifier: MIT
#include "core/pad_movement.hpp"

#include <limits>

#include "core/angle.hpp"
#include "core/inputs.hpp"

namespace fantail::core {
namespace {

// As for the window of thrust that the estimator integrates: above 1 g by more than wind and hands make of it.
constexpr float least_push_m_s2 = 1.2F * standard_gravity_m_s2;
constexpr std::uint32_t blocks_of_push = 30;

// On a rail of up to 60 degrees the axis reads more than this; in free flight, upside down and on its side, less.
constexpr float least_support_m_s2 = 0.5F * standard_gravity_m_s2;

// Drag of a rocket near its apogee is less. A drop of 1.2 m lasts 0.5 s, and a flight that is over sooner than this has
// come to less than a metre above where its motor went out. What kicks a falling rocket, as an ejection charge does,
// takes one block off and does not begin the count anew.
constexpr float weightless_m_s2 = 0.4F * standard_gravity_m_s2;
constexpr std::uint32_t blocks_of_fall = 8;

// A logger or a radio that stops for some seconds is no flight; a flight to its parachute takes longer.
constexpr std::uint32_t blocks_of_silence = 50;

// Wind rocks a rail by some degrees either way. A bias that has drifted by 0.3 deg/s since it was taken makes 6
// degrees.
constexpr float largest_turn_rad = Angle::from_degrees(10.0F).radians();
constexpr float memory_of_turns_s = 20.0F;

std::uint32_t count(bool goes_on, std::uint32_t blocks) {
  if (!goes_on) {
    return 0;
  }
  return blocks < std::numeric_limits<std::uint32_t>::max() ? blocks + 1 : blocks;
}

}  // namespace

// Meets PHS-5.
void PadMovement::take(float length_s, const Vector3& rate_rad_s, const Vector3& specific_force_m_s2) {
  const Vector3& f = specific_force_m_s2;
  const float kept = 1.0F - length_s / memory_of_turns_s;
  turn_y_rad_ = kept * turn_y_rad_ + length_s * rate_rad_s.y;
  turn_z_rad_ = kept * turn_z_rad_ + length_s * rate_rad_s.z;
  const float turn_squared = turn_y_rad_ * turn_y_rad_ + turn_z_rad_ * turn_z_rad_;

  pushed_ = count(f.x > least_push_m_s2, pushed_);
  unsupported_ = count(f.x < least_support_m_s2, unsupported_);
  const bool weightless = f.x * f.x + f.y * f.y + f.z * f.z < weightless_m_s2 * weightless_m_s2;
  weightless_ = weightless ? count(true, weightless_) : weightless_ > 0 ? weightless_ - 1 : 0;
  missed_ = 0;

  const bool turned = pushed_ == 0 && turn_squared > largest_turn_rad * largest_turn_rad;
  moved_ = moved_ || turned || pushed_ >= blocks_of_push || !is_supported();
  fallen_ = fallen_ || weightless_ >= blocks_of_fall;
}

void PadMovement::miss() {
  pushed_ = unsupported_ = 0;
  missed_ = count(true, missed_);
  moved_ = moved_ || missed_ >= blocks_of_silence;
}

}  // namespace fantail::core
