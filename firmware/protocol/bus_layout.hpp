// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "protocol/bus_codec.hpp"
#include "protocol/crc8.hpp"
#include "protocol/generated/canard_bus.h"

namespace fantail::protocol {

// Inside the codec only: one frame of the database, as the generated functions see it.
template <typename RawSignals, std::uint16_t identifier, auto generated_pack, auto generated_unpack>
struct Layout {
  using Raw = RawSignals;
  static constexpr std::uint16_t id = identifier;
  static constexpr std::uint8_t length = 8;
  static constexpr bool is_protected = requires(Raw raw) {
    raw.counter;
    raw.crc;
  };

  static BusFrame pack(const Raw& raw) {
    BusFrame frame{.id = id, .length = length};
    generated_pack(frame.data.data(), &raw, frame.data.size());
    return frame;
  }
  static Raw unpack(const BusFrame& frame) {
    Raw raw{};
    generated_unpack(&raw, frame.data.data(), frame.data.size());
    return raw;
  }
};

/// Over the identifier too, so that the bytes of one message are not taken for another's. The CRC itself is the last
/// byte of each frame that has one.
inline std::uint8_t protection_of(const BusFrame& frame) {
  std::array<std::uint8_t, 9> bytes{static_cast<std::uint8_t>(frame.id & 0xFFU),
                                    static_cast<std::uint8_t>(frame.id >> 8U)};
  std::copy_n(frame.data.begin(), 7, bytes.begin() + 2);
  return crc8_autosar(bytes);
}

template <typename Frame>
BusFrame protect(typename Frame::Raw raw, std::uint8_t counter) {
  raw.counter = counter & 0x0FU;
  BusFrame frame = Frame::pack(raw);
  frame.data.back() = protection_of(frame);
  return frame;
}

/// Refuses a wrong length, then a wrong CRC, then values. `strict` also refuses bits that no signal of the database
/// covers unless they are zero; a bench that listens to newer avionics lets them pass. `read` makes a message of the
/// raw signals, or nothing when one of them is out of its range.
template <typename Message, typename Frame, bool strict, typename Read>
Decoded<Message> decode_as(const BusFrame& frame, Read read) {
  if (frame.length != Frame::length) {
    return {.rejection = Rejection::wrong_length};
  }
  if constexpr (Frame::is_protected) {
    if (frame.data.back() != protection_of(frame)) {
      return {.rejection = Rejection::wrong_crc};
    }
  }
  const typename Frame::Raw raw = Frame::unpack(frame);
  if (strict && Frame::pack(raw).data != frame.data) {
    return {.rejection = Rejection::out_of_range};
  }
  const auto message = read(raw);
  if (!message) {
    return {.rejection = Rejection::out_of_range};
  }
  Decoded<Message> decoded{.message = *message};
  if constexpr (Frame::is_protected) {
    decoded.counter = raw.counter;
  }
  return decoded;
}

}  // namespace fantail::protocol
