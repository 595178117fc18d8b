// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

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

/// Of a frame that belongs to a bench session and does not name it.
using SessionOfFrame = std::optional<std::uint16_t>;

/// Over the identifier too, so that the bytes of one message are not taken for another's, and over the session, so that
/// those of one bench are not taken for another's. Then come the first seven bytes of the frame.
inline Crc8Autosar protection_begun(std::uint16_t id, SessionOfFrame session) {
  Crc8Autosar crc;
  crc.add(id);
  crc.add(id >> 8U);
  if (session) {
    crc.add(*session);
    crc.add(*session >> 8U);
  }
  return crc;
}

/// The CRC itself is the last byte of each frame that has one.
inline std::uint8_t protection_of(const BusFrame& frame, SessionOfFrame session) {
  Crc8Autosar crc = protection_begun(frame.id, session);
  for (const std::uint8_t byte : std::span{frame.data}.first<7>()) {
    crc.add(byte);
  }
  return crc.result();
}

template <typename Frame>
BusFrame protect(typename Frame::Raw raw, std::uint8_t counter, SessionOfFrame session = {}) {
  raw.counter = counter & 0x0FU;
  BusFrame frame = Frame::pack(raw);
  frame.data.back() = protection_of(frame, session);
  return frame;
}

/// Refuses a wrong length, then a wrong CRC, then values. `strict` also refuses bits that no signal of the database
/// covers unless they are zero; a bench that listens to newer avionics lets them pass. `read` makes a message of the
/// raw signals, or nothing when one of them is out of its range.
template <typename Message, typename Frame, bool strict, typename Read>
Decoded<Message> decode_as(const BusFrame& frame, Read read, SessionOfFrame session = {}) {
  Decoded<Message> decoded{};
  if (frame.length != Frame::length) {
    decoded.rejection = Rejection::wrong_length;
    return decoded;
  }
  if constexpr (Frame::is_protected) {
    if (frame.data.back() != protection_of(frame, session)) {
      decoded.rejection = Rejection::wrong_crc;
      return decoded;
    }
  }
  const typename Frame::Raw raw = Frame::unpack(frame);
  if (!strict || Frame::pack(raw).data == frame.data) {
    decoded.message = read(raw);
  }
  if (!decoded.message) {
    decoded.rejection = Rejection::out_of_range;
  } else if constexpr (Frame::is_protected) {
    decoded.counter = raw.counter;
  }
  return decoded;
}

}  // namespace fantail::protocol
