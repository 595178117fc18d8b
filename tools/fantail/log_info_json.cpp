// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "fantail/log_info.hpp"
#include "flight_log/event_text.hpp"
#include "flight_log/integrity.hpp"
#include "json/value.hpp"
#include "protocol/plan_block.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

using Json = json::Value;
using json::text_or_null;

double duration_s(core::Microseconds time) { return static_cast<double>(time.count()) / 1e6; }

Json plan(const FlightInfo& info) {
  if (info.flight.plan_block.empty()) {
    return nullptr;
  }
  return {{"name", info.plan},
          {"crc", fmt::format("{:08x}", protocol::plan_block_crc(info.flight.plan_block))},
          {"usable", info.flight.plan.has_value()},
          {"fault", text_or_null(info.flight.plan_fault)}};
}

Json integrity(const FlightInfo& info) {
  const flight_log::Flight& flight = info.flight;
  Json gaps = Json::array();
  for (const flight_log::Gap& gap : flight.gaps) {
    gaps.push_back({{"first_missing", gap.first_missing},
                    {"count", gap.count},
                    {"dropped", gap.dropped},
                    {"from_s", info.seconds(gap.before)},
                    {"to_s", info.seconds(gap.after)}});
  }
  return {{"verdict", flight_log::integrity_text(flight)},
          {"intact", flight_log::intact(flight)},
          {"records", flight.records},
          {"unknown_records", flight.unknown_records},
          {"lost_records", flight_log::lost_records(flight)},
          {"gaps", gaps},
          {"has_end", flight_log::has_end(flight)},
          {"dropped_records", flight_log::dropped_records(flight)}};
}

Json replay(const FlightInfo& info) {
  Json json{{"verdict", flight_log::replay_text(info.flight, info.replay)},
            {"compared", info.replay.compared},
            {"differing", info.replay.differing},
            {"unreachable", info.replay.unreachable},
            {"obstacle", text_or_null(info.replay.obstacle)},
            {"first_difference", nullptr}};
  if (const auto& difference = info.replay.first_difference) {
    json["first_difference"] = {{"tick", difference->tick},
                                {"time_s", info.seconds(info.flight.ticks[difference->tick].tick.time)},
                                {"field", difference->field},
                                {"recorded", difference->recorded},
                                {"replayed", difference->replayed}};
  }
  return json;
}

Json loop(const FlightInfo& info) {
  if (!info.loop) {
    return nullptr;
  }
  return {{"ticks", info.loop->ticks},   {"mean_us", info.loop->mean_us},
          {"p99_us", info.loop->p99_us}, {"longest_us", info.loop->longest_us},
          {"late", info.loop->late},     {"longest_step_us", info.loop->longest_step_us}};
}

Json health(const FlightInfo& info) {
  if (!info.health) {
    return nullptr;
  }
  return {{"longest_tick_us", info.health->longest_tick_us},
          {"longest_queue", info.health->longest_queue},
          {"ticks_dropped", info.health->ticks_dropped},
          {"unsent", info.health->unsent},
          {"bus_errors", info.health->bus_errors}};
}

Json events(const FlightInfo& info) {
  Json list = Json::array();
  for (const protocol::LogEvent& event : info.flight.events) {
    Json one{{"time_s", info.seconds(event.time)},
             {"kind", name(event.kind)},
             {"words", flight_log::event_text(event, info.flight.first_time)}};
    if (event.kind == protocol::LogEventKind::phase) {
      one["phase"] = name(static_cast<core::Phase>(event.value));
      one["reason"] = name(static_cast<core::PhaseReason>(event.detail));
    }
    list.push_back(one);
  }
  return list;
}

Json flight(const FlightInfo& info) {
  const flight_log::Flight& f = info.flight;
  return {{"number", info.flight.number},
          {"flight", f.flight},
          {"power_up", f.power_up},
          {"vehicle", text_or_null(f.vehicle)},
          {"firmware_version", text_or_null(f.firmware_version)},
          {"git_hash", text_or_null(f.git_hash)},
          {"format_version", f.format_version},
          {"sensors", text_or_null(f.sensors)},
          {"plan", plan(info)},
          {"ticks", f.ticks.size() + f.foreign_ticks.size()},
          {"duration_s", duration_s(f.last_time - f.first_time)},
          {"from_s", info.seconds(f.first_time)},
          {"to_s", info.seconds(f.last_time)},
          {"time_zero_s", duration_s(info.zero)},
          {"clock", fmt::format("seconds from {}", info.zero_text)},
          {"integrity", integrity(info)},
          {"replay", replay(info)},
          {"loop", loop(info)},
          {"health", health(info)},
          {"events", events(info)}};
}

}  // namespace

std::string log_info_json(const flight_log::LogFile& file, const std::vector<FlightInfo>& flights,
                          const result::Made& made) {
  Json list = Json::array();
  for (const FlightInfo& info : flights) {
    list.push_back(flight(info));
  }
  Json json{{"log", file.name},
            {"bytes", file.bytes},
            {"foreign_bytes", file.foreign_bytes},
            {"foreign_places", file.foreign_places},
            {"cut_off_bytes", file.cut_off_bytes},
            {"intact", flight_log::intact(file)},
            {"flights", list}};
  const bool intact = flight_log::intact(file);
  result::put_answer(
      json, intact ? result::Answer::yes : result::Answer::no,
      fmt::format("{}: {}, {}.", file.name, text::counted(flights.size(), "flight"),
                  intact ? "nothing missing and nothing damaged" : "with records missing or bytes damaged"),
      made);
  return json.pretty();
}

}  // namespace fantail::tool
