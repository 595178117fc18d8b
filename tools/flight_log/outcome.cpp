// SPDX-License-Identifier: MIT
#include "flight_log/outcome.hpp"

#include <cmath>

#include <fmt/core.h>

#include "core/tick_record.hpp"
#include "flight_log/schema.hpp"
#include "protocol/log_schema.hpp"

namespace fantail::flight_log {
namespace {

// Only the bytes matter here; ages that say "as before" are the same on both sides.
protocol::PackedTick packed(const protocol::LogTick& tick) {
  protocol::SampleTimes not_needed;
  return protocol::pack(tick, not_needed);
}

std::string text(const SchemaField& field, double value) {
  if (field.name == "phase" && value < static_cast<double>(core::phases)) {
    return std::string{core::name(static_cast<core::Phase>(value))};
  }
  if (field.name == "command_status" && value < static_cast<double>(core::command_statuses)) {
    return std::string{core::name(static_cast<core::CommandStatus>(value))};
  }
  if (field.unit == "mdeg") {
    return value == -32768.0 ? "not driven" : fmt::format("{:.3f} deg", value / 1000.0);
  }
  if (field.name == "digest") {
    return fmt::format("{:08x}", static_cast<std::uint32_t>(value));
  }
  if (field.type == FieldType::real_number) {
    return fmt::format("{:.9g} {}", value, field.unit);  // nine digits tell any two floats apart
  }
  return fmt::format("{:g}{}{}", value, field.unit.empty() ? "" : " ", field.unit);
}

}  // namespace

bool same_bytes(const protocol::LogTick& a, const protocol::LogTick& b) { return packed(a) == packed(b); }

std::optional<OutcomeDifference> first_difference(const protocol::LogTick& recorded,
                                                  const protocol::LogTick& replayed) {
  static const std::vector<SchemaRecord> schema = parse_schema(protocol::log_schema());
  const protocol::PackedTick a = packed(recorded);
  const protocol::PackedTick b = packed(replayed);
  for (const SchemaField& field : find_record(schema, "tick")->fields) {
    const double was = *value(field, a);
    const double is = *value(field, b);
    if (was != is) {
      return OutcomeDifference{.field = field.name, .recorded = text(field, was), .replayed = text(field, is)};
    }
    if (field.name == "command" && recorded.command.radians() == 0.0F && a != b) {
      // -0 and 0 are equal numbers and other bytes.
      const bool was_negative = std::signbit(recorded.command.radians());
      if (was_negative != std::signbit(replayed.command.radians())) {
        return OutcomeDifference{.field = field.name,
                                 .recorded = was_negative ? "-0 rad" : "0 rad",
                                 .replayed = was_negative ? "0 rad" : "-0 rad"};
      }
    }
  }
  return std::nullopt;
}

}  // namespace fantail::flight_log
