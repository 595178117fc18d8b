// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>
#include <vector>

#include "protocol/bus_codec.hpp"

namespace fantail::protocol {

/// Remainder of a division of polynomials, one bit after the other: CRC-8/AUTOSAR as its definition reads.
inline std::uint8_t naive_crc8(const std::vector<std::uint8_t>& bytes) {
  unsigned remainder = 0xFF;
  for (const unsigned byte : bytes) {
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned out = ((remainder >> 7U) ^ (byte >> static_cast<unsigned>(bit))) & 1U;
      remainder = (remainder << 1U) & 0xFFU;
      remainder ^= out * 0x2FU;
    }
  }
  return static_cast<std::uint8_t>(remainder ^ 0xFFU);
}

/// The one that is open.
inline constexpr std::uint16_t open_session = 0xA55E;

/// A frame put together bit by bit, without the codec: bit n is bit n % 8 of byte n / 8.
class FrameBuilder {
 public:
  explicit FrameBuilder(std::uint16_t id) : frame_{.id = id, .length = 8} {}

  FrameBuilder& put(unsigned start, unsigned length, std::int64_t value) {
    for (unsigned i = 0; i < length; ++i) {
      const unsigned bit = start + i;
      const auto mask = static_cast<std::uint8_t>(1U << (bit % 8U));
      const bool set = ((static_cast<std::uint64_t>(value) >> i) & 1U) != 0U;
      std::uint8_t& byte = frame_.data[bit / 8U];
      byte = static_cast<std::uint8_t>(set ? byte | mask : byte & ~mask);
    }
    return *this;
  }

  [[nodiscard]] BusFrame plain() const { return frame_; }
  [[nodiscard]] BusFrame with_crc() const {
    std::vector<std::uint8_t> covered{static_cast<std::uint8_t>(frame_.id & 0xFFU),
                                      static_cast<std::uint8_t>(frame_.id >> 8U)};
    if (frame_.id == 0x010) {
      covered.insert(covered.end(), {open_session & 0xFFU, open_session >> 8U});
    }
    covered.insert(covered.end(), frame_.data.begin(), frame_.data.begin() + 7);
    BusFrame frame = frame_;
    frame.data[7] = naive_crc8(covered);
    return frame;
  }
  /// As this kind of frame is sent.
  [[nodiscard]] BusFrame done() const {
    const bool has_crc = frame_.id <= 0x040 || frame_.id == 0x050 || frame_.id == 0x100 || frame_.id == 0x101;
    return has_crc ? with_crc() : plain();
  }

 private:
  BusFrame frame_;
};

template <typename Message>
BusFrame encode_any(const Message& message, std::uint8_t counter) {
  if constexpr (requires { encode(message, counter, open_session); }) {
    return encode(message, counter, open_session);
  } else if constexpr (requires { encode(message, counter); }) {
    return encode(message, counter);
  } else {
    return encode(message);
  }
}

/// What the frame becomes when it is decoded and encoded again; or why it was refused.
inline std::variant<BusFrame, Rejection> there_and_back(const BusFrame& frame) {
  const auto again = [](const auto& decoded) -> std::variant<BusFrame, Rejection> {
    if (!decoded.message) {
      return decoded.rejection;
    }
    return std::visit([&](const auto& message) { return encode_any(message, decoded.counter.value_or(0)); },
                      *decoded.message);
  };
  return frame.id < 0x100 ? again(decode_from_bench(frame, open_session)) : again(decode_from_avionics(frame));
}

}  // namespace fantail::protocol
