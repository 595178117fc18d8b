// SPDX-License-Identifier: MIT
#include "flight_log/plan_words.hpp"

#include <utility>
#include <vector>

#include <fmt/core.h>

#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "text/error.hpp"

namespace fantail::flight_log {
namespace {

using NamedChecksum = std::pair<std::string, std::uint32_t>;

std::vector<NamedChecksum> shipped_plans() {
  std::vector<NamedChecksum> plans;
  for (const std::string& name : input::shipped_names(input::Shipped::plan)) {
    try {
      const auto file = input::find_input(input::Shipped::plan, name);
      plans.emplace_back(name, protocol::plan_crc(input::read_plan(input::Document::load(file))));
    } catch (const text::Error&) {
      continue;  // somebody is at work on that file; it is not what was asked for
    }
  }
  return plans;
}

}  // namespace

std::string words(const protocol::PlanBlockReading& reading) {
  switch (reading.fault) {
    case protocol::PlanBlockFault::too_short:
    case protocol::PlanBlockFault::no_plan_block: return "there is none in the header";
    case protocol::PlanBlockFault::wrong_length: return "it is not of the length it should have";
    case protocol::PlanBlockFault::wrong_checksum: return "its checksum is wrong";
    case protocol::PlanBlockFault::older_version: return "it was written by an older version";
    case protocol::PlanBlockFault::newer_version: return "it was written by a newer version";
    case protocol::PlanBlockFault::other_schema: return "it was written for another list of plan values";
    case protocol::PlanBlockFault::refused: break;
  }
  if (!reading.plan_fault) {
    return "it would not be allowed to fly";
  }
  return fmt::format("it would not be allowed to fly: {}.{}, {}", reading.plan_fault->field->section,
                     reading.plan_fault->field->key, reading.plan_fault->rule);
}

std::string plan_name(const Flight& flight) {
  if (flight.plan_block.empty()) {
    return {};
  }
  const std::uint32_t checksum = protocol::plan_block_crc(flight.plan_block);
  static const std::vector<NamedChecksum> shipped = shipped_plans();
  for (const auto& [name, its_checksum] : shipped) {
    if (its_checksum == checksum) {
      return name;
    }
  }
  return fmt::format("plan {:08x}", checksum);
}

}  // namespace fantail::flight_log
