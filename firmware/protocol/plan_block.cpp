// SPDX-License-Identifier: MIT
#include "protocol/plan_block.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/flight_plan_table.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {
namespace {

constexpr std::array<std::byte, 4> magic{std::byte{'F'}, std::byte{'T'}, std::byte{'P'}, std::byte{'L'}};
constexpr std::size_t header_size = plan_block_header_size;
constexpr std::size_t checksum_size = 4;

// FNV-1a.
consteval std::uint32_t hash(std::uint32_t h, std::string_view text) {
  for (const char c : text) {
    h = (h ^ static_cast<std::uint8_t>(c)) * 16777619U;
  }
  return (h ^ 0xFFU) * 16777619U;  // ends the text, so that "ab","c" is not "a","bc"
}

// By the compiler: a board has no names to hash.
constexpr std::uint32_t schema_hash = []() consteval {
  std::uint32_t h = 2166136261U;
  for (const core::PlanField& field : core::plan_table::flight_plan_table) {
    h = hash(hash(hash(h, field.section), field.key), field.unit);
    h = (h ^ static_cast<std::uint32_t>(field.kind)) * 16777619U;
    h = (h ^ static_cast<std::uint32_t>(field.slots)) * 16777619U;
    for (const std::string_view choice : field.choices) {
      h = hash(h, choice);
    }
  }
  return h;
}();

constexpr std::size_t payload_size = plan_block_size - header_size - checksum_size;

PlanBlockReading refuse(PlanBlockFault fault) { return {.plan = {}, .fault = fault}; }

PlanBlockReading refuse(const core::PlanFault& fault) {
  return {.plan = {}, .fault = PlanBlockFault::refused, .plan_fault = fault};
}

// Everything but the fields.
std::optional<PlanBlockFault> fault_of_envelope(std::span<const std::byte> block) {
  if (block.size() < header_size + checksum_size) {
    return PlanBlockFault::too_short;
  }
  for (std::size_t i = 0; i < magic.size(); ++i) {
    if (block[i] != magic[i]) {
      return PlanBlockFault::no_plan_block;
    }
  }
  // The length first, because a block that was cut off also has a wrong checksum, which would say less.
  if (block.size() != announced_plan_block_size(block)) {
    return PlanBlockFault::wrong_length;
  }
  if (get<4>(block, block.size() - checksum_size) != crc32c(block.first(block.size() - checksum_size))) {
    return PlanBlockFault::wrong_checksum;
  }
  if (get<2>(block, 4) != plan_block_version) {
    return get<2>(block, 4) > plan_block_version ? PlanBlockFault::newer_version : PlanBlockFault::older_version;
  }
  if (get<4>(block, 8) != schema_hash) {
    return PlanBlockFault::other_schema;
  }
  if (block.size() != plan_block_size) {
    return PlanBlockFault::wrong_length;
  }
  return std::nullopt;
}

}  // namespace

std::uint32_t plan_schema_hash() { return schema_hash; }

std::size_t write_plan_block(const core::FlightPlan& plan, std::span<std::byte> out) {
  for (std::size_t i = 0; i < magic.size(); ++i) {
    out[i] = magic[i];
  }
  put<2>(out, 4, plan_block_version);
  put<2>(out, 6, payload_size);
  put<4>(out, 8, schema_hash);
  std::size_t at = header_size;
  for (const core::PlanMember& field : core::flight_plan_members()) {
    const std::size_t used = field.used_slots(plan);
    if (field.is_list()) {
      put<4>(out, at, used);
      at += 4;
    }
    for (std::size_t slot = 0; slot < field.slots; ++slot) {
      put<4>(out, at, slot < used ? field.get_bits(plan, slot) : 0U);
      at += 4;
    }
  }
  put<4>(out, at, crc32c(std::span{out}.first(at)));
  return at + checksum_size;
}

std::uint32_t plan_block_crc(std::span<const std::byte> block) {
  return crc32c(block.first(block.size() - std::min(checksum_size, block.size())));
}

std::uint32_t plan_crc(const core::FlightPlan& plan) {
  std::array<std::byte, plan_block_size> block;
  (void)write_plan_block(plan, block);
  return plan_block_checksum(block);
}

std::size_t announced_plan_block_size(std::span<const std::byte> header) {
  return header_size + static_cast<std::size_t>(get<2>(header, 6)) + checksum_size;
}

std::uint32_t plan_block_checksum(std::span<const std::byte> block) {
  return static_cast<std::uint32_t>(get<4>(block, block.size() - checksum_size));
}

PlanBlockReading read_plan_block(std::span<const std::byte> block) {
  if (const auto fault = fault_of_envelope(block)) {
    return refuse(*fault);
  }
  core::FlightPlan plan{};
  std::size_t at = header_size;
  const auto members = core::flight_plan_members();
  for (std::size_t place = 0; place < members.size(); ++place) {
    const core::PlanMember& field = members[place];
    if (field.is_list()) {
      const auto length = static_cast<std::uint32_t>(get<4>(block, at));
      if (length > field.slots) {
        return refuse(core::PlanFault{place, 0, core::PlanRule::too_many_values});
      }
      field.set_length(plan, length);
      at += 4;
    }
    for (std::size_t slot = 0; slot < field.slots; ++slot) {
      const auto bits = static_cast<std::uint32_t>(get<4>(block, at));
      field.set_bits(plan, slot, bits);
      if (field.get_bits(plan, slot) != bits) {  // did not fit the field's type
        return refuse(core::PlanFault{place, slot, core::PlanRule::in_range});
      }
      at += 4;
    }
  }
  if (const auto fault = core::validate(plan)) {
    return refuse(*fault);
  }
  return {.plan = plan};
}

}  // namespace fantail::protocol
