// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/angle.hpp"
#include "core/inputs.hpp"

namespace fantail::protocol {

// From the bench PC: the only frames that can move something, each with a counter and a CRC-8.

using PerCanard = std::array<std::optional<core::Angle>, core::canard_count>;

/// Shaft angles, held until the next request or the end of the session; a canard that is not asked stays at its trim.
/// Its CRC-8 covers the number of the sender's session too, for which the frame has no room.
struct BenchRequest {
  PerCanard angle{};
};

enum class SessionAction : std::uint8_t {
  keep,   ///< the heartbeat of the bench
  open,   ///< also a heartbeat, once the session is open
  close,  ///< centre the canards now
};

struct BenchSession {
  SessionAction action = SessionAction::keep;
  std::uint16_t session = 0;  ///< drawn by the bench at random: one session is one sender's
};

enum class ArmAction : std::uint8_t { self_test, begin, confirm, start };

/// Arming: self_test; begin, which is answered with a nonce; confirm, with that nonce. `start` begins control in the
/// tunnel and carries the nonce that armed.
struct ArmRequest {
  ArmAction action = ArmAction::self_test;
  std::uint32_t nonce = 0;
};

/// A plan block is about to come, seven bytes a frame.
struct PlanBegin {
  std::uint16_t size = 0;
  std::uint32_t block_crc = 0;  ///< plan_block_crc() of it
};

/// Moves nothing, and the block has a checksum of its own, so it has neither counter nor CRC-8.
struct PlanData {
  std::uint8_t index = 0;  ///< bytes from 7 * index on
  std::array<std::byte, 7> bytes{};
};

enum class LogAction : std::uint8_t {
  info,
  read,
  erase,  ///< in Safe, by the bench that has the session
  plan,   ///< bytes of the block of the plan in force, as read gives those of the record
};

/// Of the flight record, which is the used part of the flash's flight region, or of the plan in force. Moves nothing;
/// protected because it can erase.
struct LogRequest {
  LogAction action = LogAction::info;
  std::uint8_t tag = 0;      ///< 0 to 15, chosen by the bench; the answer carries it
  std::uint32_t offset = 0;  ///< read, plan: of the first byte; erase: the number of the open session
  std::uint16_t size = 0;    ///< read, plan: 1 to largest_log_chunk; 12 bits
};

}  // namespace fantail::protocol
