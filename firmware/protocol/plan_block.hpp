// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/flight_plan.hpp"
#include "core/flight_plan_members.hpp"

namespace fantail::protocol {

// A flight plan as a board is loaded with it: little-endian,
//   0  4 bytes  "FTPL"
//   4  u16      version (3): of this format and of the table of fields, one more with every change of either
//   6  u16      length of the payload in bytes
//   8  u32      schema hash: changes with every name, unit, kind or capacity in the table of fields
//  12  payload  every field in the order of the table: a list begins with its length (u32); then one u32 a slot
//               (an IEEE single in inside units, microseconds, or the index of a choice)
//   n  u32      CRC-32C of everything before it

inline constexpr std::uint16_t plan_block_version = 3;
inline constexpr std::size_t plan_block_header_size = 12;
inline constexpr std::size_t plan_block_size = plan_block_header_size + 4 * core::flight_plan_words + 4;
/// Room for those of other versions too, so that what is stored or sent can be called by its name.
inline constexpr std::size_t largest_plan_block = 1024;
static_assert(plan_block_size <= largest_plan_block);

enum class PlanBlockFault : std::uint8_t {
  too_short,
  no_plan_block,  ///< it does not begin with the four letters
  wrong_length,   ///< cut off or run on, or not the length of this table of fields
  wrong_checksum,
  older_version,
  other_schema,   ///< of this version, and yet written for another table of fields
  refused,        ///< intact, but its plan does not pass core::validate()
  newer_version,  ///< intact as far as this version can tell; to read it takes newer firmware
};

/// Number of bytes written, plan_block_size; `out` has room for them.
std::size_t write_plan_block(const core::FlightPlan& plan, std::span<std::byte> out);

/// plan_block_crc() of this plan's block: the plan's name on the bus.
[[nodiscard]] std::uint32_t plan_crc(const core::FlightPlan& plan);

struct PlanBlockReading {
  std::optional<core::FlightPlan> plan;
  PlanBlockFault fault{};                       ///< when there is no plan
  std::optional<core::PlanFault> plan_fault{};  ///< when the plan was refused
};

/// Accepts a block only as a whole: every byte checked, every field validated.
[[nodiscard]] PlanBlockReading read_plan_block(std::span<const std::byte> block);

/// What a block is known by: CRC-32C of all but its last four bytes, which is what an intact block has in those. Of the
/// whole block it would be 0x48674BC7 for every plan, because a CRC over its own end is a constant.
[[nodiscard]] std::uint32_t plan_block_crc(std::span<const std::byte> block);

/// How long a block is by what its first plan_block_header_size bytes say.
[[nodiscard]] std::size_t announced_plan_block_size(std::span<const std::byte> header);

/// What stands in its last four bytes: of an intact block, its plan_block_crc().
[[nodiscard]] std::uint32_t plan_block_checksum(std::span<const std::byte> block);

[[nodiscard]] std::uint32_t plan_schema_hash();

}  // namespace fantail::protocol
