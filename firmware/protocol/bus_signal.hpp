// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "protocol/bus_messages.hpp"
#include "protocol/generated/canard_bus.h"

namespace fantail::protocol {

// Inside the codec only. The scale of a signal stands in the database and nowhere else: whatever needs it here asks the
// generated functions.

/// A signal with a scale: its generated functions, and the raw values that it may have.
template <auto generated_encode, auto generated_decode, std::int16_t lowest, std::int16_t highest>
class Scaled {
 public:
  /// To the nearest raw value, a half away from zero (as far as single precision can tell a half). Clamped first: the
  /// generated function would run into undefined behaviour, and what it packs would wrap. Not a number gives zero.
  [[nodiscard]] std::int16_t raw(float value) const {
    if (value >= highest_value_) {
      return highest;
    }
    if (value <= lowest_value_) {
      return lowest;
    }
    // Neither above nor below nor equal to itself.
    if (value != value) {  // NOLINT(misc-redundant-expression)
      return 0;
    }
    // The generated function cuts off the fraction.
    return generated_encode(value < 0.0F ? value - half_ : value + half_);
  }
  static float value(std::int16_t raw) { return generated_decode(raw); }

 private:
  // Asked once, for however many values follow.
  float highest_value_ = generated_decode(highest);
  float lowest_value_ = generated_decode(lowest);
  float half_ = 0.5F * generated_decode(1);
};

// Signals of the same kind have the same scale in every message; a test reads that from the database.
using CanardAngle =
    Scaled<canard_bus_command_report_canard_1_encode, canard_bus_command_report_canard_1_decode, -2047, 2047>;
using CanardLimit = Scaled<canard_bus_limit_report_canard_1_encode, canard_bus_limit_report_canard_1_decode, 0, 2047>;
using RollCommand =
    Scaled<canard_bus_status_report_roll_command_encode, canard_bus_status_report_roll_command_decode, -2047, 2047>;
using GyroBias =
    Scaled<canard_bus_status_report_gyro_bias_encode, canard_bus_status_report_gyro_bias_decode, -2047, 2047>;
using RollAngle =
    Scaled<canard_bus_motion_report_roll_angle_encode, canard_bus_motion_report_roll_angle_decode, -32767, 32767>;
using RollRate =
    Scaled<canard_bus_motion_report_roll_rate_encode, canard_bus_motion_report_roll_rate_decode, -32767, 32767>;
using Height = Scaled<canard_bus_motion_report_height_encode, canard_bus_motion_report_height_decode, -32767, 32767>;
using Speed = Scaled<canard_bus_motion_report_speed_encode, canard_bus_motion_report_speed_decode, -32767, 32767>;
using BodyRate = Scaled<canard_bus_gyro_report_x_encode, canard_bus_gyro_report_x_decode, -32767, 32767>;
using SpecificForce =
    Scaled<canard_bus_accelerometer_report_x_encode, canard_bus_accelerometer_report_x_decode, -32767, 32767>;

/// Where the four angles of a message lie, and the bits that say which of them are there.
template <typename Raw>
struct FourAngles {
  std::array<std::int16_t Raw::*, core::canard_count> angle{&Raw::canard_1, &Raw::canard_2, &Raw::canard_3,
                                                            &Raw::canard_4};
  std::array<std::uint8_t Raw::*, core::canard_count> given{};

  [[nodiscard]] std::optional<PerCanard> angles(const Raw& raw) const {
    PerCanard result{};
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const std::int16_t value = raw.*angle[i];
      if (!canard_bus_command_report_canard_1_is_in_range(value)) {
        return std::nullopt;
      }
      if (raw.*given[i] != 0) {
        result[i] = core::Angle::from_degrees(CanardAngle::value(value));
      }
    }
    return result;
  }
};

}  // namespace fantail::protocol
