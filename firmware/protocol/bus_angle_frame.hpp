// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/bus_layout.hpp"
#include "protocol/bus_messages.hpp"
#include "protocol/crc8.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {

// Inside the codec only: the three frames of four canard angles. Two of them go out in every tick of a flight, and the
// generated functions, which build them bit by bit, took a seventh of it. A test holds every bit against theirs.
//    0  4 x i12  angle, 0.01 degree
//   48  4 x u1   whether it is there
//   52  u4       counter
//   56  u8       CRC-8

/// To the nearest raw value, a half away from zero (as far as single precision can tell a half), clamped to what the
/// signal may have; empty for what is not a number.
constexpr std::optional<std::int32_t> hundredths(float degrees) {
  constexpr float step = 0.01F;
  constexpr std::int32_t most = 2047;
  constexpr float most_degrees = static_cast<float>(most) * step;
  if (!(std::abs(degrees) < most_degrees)) {  // seldom
    if (degrees != degrees) {                 // NOLINT(misc-redundant-expression): of what is no number
      return std::nullopt;
    }
    return degrees < 0.0F ? -most : most;
  }
  return static_cast<std::int32_t>((degrees < 0.0F ? degrees - 0.5F * step : degrees + 0.5F * step) / step);
}

/// An angle that is absent, or not a number, is zero and not there. `crc`: protection_begun().
inline BusFrame angle_frame(std::uint16_t id, Crc8Autosar crc, const PerCanard& angles, std::uint8_t counter) {
  constexpr std::uint32_t twelve_bits = 0xFFF;
  std::uint64_t raw = 0;
  std::uint32_t there = 0;
  for (std::size_t i = core::canard_count; i-- > 0;) {  // the last one stands highest
    raw <<= 12U;
    there <<= 1U;
    if (const auto value = angles[i] ? hundredths(angles[i]->degrees()) : std::nullopt) {
      raw |= static_cast<std::uint32_t>(*value) & twelve_bits;
      there |= 1U;
    }
  }
  const auto low = static_cast<std::uint32_t>(raw);
  std::uint32_t high = static_cast<std::uint32_t>(raw >> 32U) | there << 16U | (counter & 0x0FU) << 20U;
  crc.add(low);  // not in a loop: GCC would read the shifts from memory
  crc.add(low >> 8U);
  crc.add(low >> 16U);
  crc.add(low >> 24U);
  crc.add(high);
  crc.add(high >> 8U);
  crc.add(high >> 16U);
  high |= static_cast<std::uint32_t>(crc.result()) << 24U;
  BusFrame frame{.id = id, .length = 8};
  const auto bytes = std::as_writable_bytes(std::span{frame.data});
  put<4>(bytes, 0, low);
  put<4>(bytes, 4, high);
  return frame;
}

inline BusFrame angle_frame(std::uint16_t id, const PerCanard& angles, std::uint8_t counter,
                            SessionOfFrame session = {}) {
  return angle_frame(id, protection_begun(id, session), angles, counter);
}

}  // namespace fantail::protocol
