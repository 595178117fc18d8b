// SPDX-License-Identifier: MIT
#include "log_export/about.hpp"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/flight_plan_fields.hpp"
#include "text/number.hpp"

namespace fantail::log_export {
namespace {

using protocol::LogEventKind;
using Json = json::Value;
using json::rounded;
using json::text_or_null;

Json plan(const flight_log::Flight& flight) {
  if (!flight.plan) {
    return {};
  }
  Json all;
  for (const core::PlanField& field : core::flight_plan_fields()) {
    const auto value = [&](std::size_t slot) -> Json {
      const float number = field.get(*flight.plan, slot);
      switch (field.kind) {
        case core::FieldKind::choice: return field.choices[static_cast<std::size_t>(number)];
        case core::FieldKind::flag: return number != 0.0F;
        case core::FieldKind::integer: return static_cast<std::int64_t>(number);
        case core::FieldKind::number: break;
      }
      return *text::number(fmt::format("{}", number));  // the float's own shortest decimals
    };
    if (field.slots == 1 && !field.is_list()) {
      all[field.section][field.key] = value(0);
    } else {
      Json list = Json::array();
      for (std::size_t slot = 0; slot < field.used_slots(*flight.plan); ++slot) {
        list.push_back(value(slot));
      }
      all[field.section][field.key] = std::move(list);
    }
  }
  return all;
}

// An event's value and its reason; empty where its kind has none.
std::string_view value_name(const protocol::LogEvent& event) {
  switch (event.kind) {
    case LogEventKind::recording_ended: return name(static_cast<protocol::LogEnd>(event.value));
    case LogEventKind::phase: return name(static_cast<core::Phase>(event.value));
    case LogEventKind::canard_verdict: return name(static_cast<core::CanardVerdict>(event.value));
    case LogEventKind::gyro_state:
    case LogEventKind::accelerometer_state: return name(static_cast<core::SensorState>(event.value));
    case LogEventKind::command_status: return name(static_cast<core::CommandStatus>(event.value));
    case LogEventKind::resumed: return name(static_cast<protocol::ResumedAfter>(event.value));
    case LogEventKind::barometer_state: return name(static_cast<core::BarometerState>(event.value));
    case LogEventKind::gyro_vote: return name(static_cast<core::GyroVote>(event.value));
    case LogEventKind::recording_began:
    case LogEventKind::records_dropped:
    case LogEventKind::longest_tick:
    case LogEventKind::board_faults: break;
  }
  return {};
}

std::string_view reason_name(const protocol::LogEvent& event) {
  return event.kind == LogEventKind::phase ? name(static_cast<core::PhaseReason>(event.detail)) : std::string_view{};
}

Json events(const ReplayedFlight& source) {
  Json all = Json::array();
  for (const protocol::LogEvent& event : source.flight().events) {
    if (source.inside(event.time)) {
      const bool of_a_canard = event.kind == LogEventKind::canard_verdict;
      all.push_back({{"time_s", rounded(source.time_s(event.time))},
                     {"kind", name(event.kind)},
                     {"value", text_or_null(value_name(event))},
                     {"reason", text_or_null(reason_name(event))},
                     {"canard", of_a_canard ? Json(event.index + 1) : Json{}},
                     {"number", event.number}});
    }
  }
  return all;
}

Json health(const ReplayedFlight& source) {
  Json all = Json::array();
  for (const protocol::LogHealth& record : source.flight().health) {
    if (!source.inside(record.time)) {
      continue;
    }
    Json verdicts = Json::array();
    for (const core::CanardVerdict verdict : record.verdicts) {
      verdicts.push_back(core::name(verdict));
    }
    all.push_back({{"time_s", rounded(source.time_s(record.time))},
                   {"verdicts", std::move(verdicts)},
                   {"gyro_state", core::name(record.gyro)},
                   {"accelerometer_state", core::name(record.accelerometer)},
                   {"bus_state", record.bus_state},
                   {"longest_tick_us", record.longest_tick_us},
                   {"longest_queue", record.longest_queue},
                   {"ticks_dropped", record.ticks_dropped},
                   {"unsent", record.unsent},
                   {"bus_errors", record.bus_errors}});
  }
  return all;
}

Json gaps(const ReplayedFlight& source) {
  Json all = Json::array();
  for (const flight_log::Gap& gap : source.flight().gaps) {
    all.push_back({{"after_s", rounded(source.time_s(gap.before))},
                   {"until_s", rounded(source.time_s(gap.after))},
                   {"records_missing", gap.count}});
  }
  return all;
}

Json columns(const Selection& selection) {
  Json all;
  for (const std::size_t i : selection) {
    const Field& field = fields()[i];
    all[field.name] = {{"unit", field.unit}, {"description", field.description}};
  }
  return all;
}

}  // namespace

json::Value about(const ReplayedFlight& source, const Selection& selection) {
  const flight_log::Flight& flight = source.flight();
  Json all = {{"flight", flight.flight},
              {"power_up", flight.power_up},
              {"vehicle", flight.vehicle},
              {"sensors", flight.sensors},
              {"firmware_version", flight.firmware_version},
              {"git_hash", flight.git_hash},
              {"format_version", flight.format_version},
              {"rate_scale_rad_s", flight.rate_scale_rad_s},
              {"specific_force_scale_m_s2", flight.specific_force_scale_m_s2},
              {"accelerometer_scale_m_s2", flight.accelerometer_scale_m_s2},
              {"plan", plan(flight)},
              {"gaps", gaps(source)},
              {"events", events(source)},
              {"health", health(source)},
              {"columns", columns(selection)}};
  if (flight.second_rate_scale_rad_s) {
    all["second_rate_scale_rad_s"] = *flight.second_rate_scale_rad_s;
  }
  return all;
}

}  // namespace fantail::log_export
