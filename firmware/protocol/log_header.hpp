// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace fantail::protocol {

// The header of a flight log says everything that is needed to understand the rest of it, and comes again every few
// seconds:
//   0  u16      format version: 1, or 2 where two gyros fly
//   2  u16      length of the plan block
//   4  u32      number of the flight
//   8  u32      number of the power-up
//  12  u32      StateLayout::hash() of the checkpoints
//  16  3 * f32  scale of the IMU's rate (rad/s a count) and specific force, of the second accelerometer (m/s2 a count)
//  28  4 * 32 bytes  text, filled up with zeros: firmware version, git hash, vehicle, sensors
// 156  f32      version 2 only: scale of the second gyro's rate (rad/s a count)
//   n  plan block
//   n  the schema (log_schema.hpp), up to the end

inline constexpr std::uint16_t log_format_version = 1;
inline constexpr std::size_t log_text_size = 32;
inline constexpr std::size_t log_header_fixed_size = 156;
inline constexpr std::uint16_t log_format_version_of_two_gyros = 2;
inline constexpr std::size_t second_rate_scale_size = 4;

struct LogHeader {
  std::uint16_t format_version = log_format_version;
  std::uint32_t flight = 0;    ///< distinguishes flights: the place in flash where it begins
  std::uint32_t power_up = 0;  ///< 0: not counted
  std::uint32_t state_layout = 0;
  float rate_scale_rad_s = 0.0F;
  float specific_force_scale_m_s2 = 0.0F;
  float accelerometer_scale_m_s2 = 0.0F;
  std::optional<float> second_rate_scale_rad_s{};  ///< where two gyros fly
  std::string_view firmware_version{};             ///< longer texts are cut off
  std::string_view git_hash{};
  std::string_view vehicle{};
  std::string_view sensors{};
  std::span<const std::byte> plan_block{};  ///< plan_block.hpp
  std::string_view schema{};
  std::string_view rest_of_schema{};  ///< to be written behind it; read, it is part of it
};

/// Everything before the plan block, except for the fields of two gyros.
[[nodiscard]] std::array<std::byte, log_header_fixed_size> encode(const LogHeader& header);
/// That, where it has a second gyro's scale.
[[nodiscard]] std::array<std::byte, second_rate_scale_size> encode_second_rate_scale(const LogHeader& header);

/// Views into the payload. Empty when it is too short for what it says; a plan block and a schema of a later version
/// are handed out as they are.
[[nodiscard]] std::optional<LogHeader> decode_log_header(std::span<const std::byte> payload);

}  // namespace fantail::protocol
