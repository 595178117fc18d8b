// SPDX-License-Identifier: MIT
#include "flight_log/to_report.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "core/flight_plan_fields.hpp"
#include "flight_log/integrity.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "protocol/plan_block.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::flight_log {
namespace {

using protocol::LogEventKind;

double in_seconds(core::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

// A row that follows a hole shows a phase, but not when it began. The recorder's own events do, where they are left.
void set_events(flight::Flight& result, const Flight& flight, const std::vector<double>& after_hole_s) {
  for (const flight::PhaseChange& change : result.phase_changes) {
    if (std::ranges::find(after_hole_s, change.time_s) != after_hole_s.end()) {
      if (auto* event = flight::event_of(result.events, change.phase)) {
        event->reset();
      }
    }
  }
  // The rest of a flight begins with the phase in which it was resumed.
  const auto rest = resumed(flight);
  flight::Events recorded;
  core::Phase before = core::Phase::safe;
  for (const protocol::LogEvent& event : flight.events) {
    if (event.kind != LogEventKind::phase) {
      continue;
    }
    const auto phase = static_cast<core::Phase>(event.value);
    if (!rest || event.time != rest->time) {
      flight::note_phase_event(recorded, before, phase, in_seconds(event.time));
    }
    before = phase;
  }
  for (const flight::NamedEvent& event : flight::named_events) {
    if (recorded.*event.time_s) {
      result.events.*event.time_s = recorded.*event.time_s;
    }
  }
}

bool is_tunnel(const Flight& flight) { return flight.plan && flight.plan->run.start == core::Start::tunnel; }

// As the recorder noted it; else as two ticks in a row show it.
std::optional<core::Microseconds> control_start(const Flight& flight) {
  constexpr core::Phase phase = core::Phase::controlling;
  const auto event = std::ranges::find_if(flight.events, [](const auto& e) {
    return e.kind == LogEventKind::phase && e.value == static_cast<std::uint8_t>(phase);
  });
  if (event != flight.events.end()) {
    return event->time;
  }
  const auto& ticks = flight.ticks;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    if (ticks[i].tick.phase == phase && ticks[i - 1].tick.phase != phase) {
      return ticks[i].tick.time;
    }
  }
  return std::nullopt;
}

// Of the last detection: one before it was none.
std::optional<core::Microseconds> lift_off(const Regeneration& regeneration) {
  std::optional<core::Microseconds> result;
  core::Phase before = core::Phase::safe;
  for (const auto& record : regeneration.records) {
    if (record && core::is_flight(record->phase) && !core::is_flight(before)) {
      result = record->motion.thrust_since;
    }
    before = record ? record->phase : before;
  }
  return result;
}

void add_notes(flight::Flight& result, const Flight& flight, const Regeneration& regeneration) {
  const auto note = [&result](std::string sentence) { result.notes.push_back(std::move(sentence)); };
  if (!intact(flight)) {
    note(fmt::format("The log is {}.", integrity_text(flight)));
  } else if (!has_end(flight)) {
    std::string end = end_text(flight);
    end.front() = 'T';
    note(std::move(end) + ".");
  }
  if (is_simulated(flight) && flight.sensors != "simulated") {
    note(fmt::format(
        "Values of the scenario's files were changed for this flight, on the command line or by the draw of a "
        "campaign ({}); the log does not say which.",
        flight.sensors));
  }
  if (const std::uint64_t dropped = dropped_records(flight); dropped > 0) {
    note(text::counted(dropped, "record was", "records were") + " never written, because the flash was too slow.");
  }
  if (!regeneration.obstacle.empty()) {
    note("The flight could not be replayed. " + regeneration.obstacle);
  } else if (regeneration.unreachable > 0) {
    note(
        fmt::format("{} between a gap and the next checkpoint could not be replayed: the state of the flight law "
                    "there is lost.",
                    text::counted(regeneration.unreachable, "tick")));
  }
  if (regeneration.differing > 0) {
    note(fmt::format("{} from what this program's flight law computes from the recorded inputs.",
                     text::counted(regeneration.differing, "tick differs", "ticks differ")));
  }
}

void add_rows(flight::Flight& result, const Regeneration& regeneration, std::vector<double>& after_hole_s) {
  result.rows.reserve(result.rows.size() + regeneration.compared);
  bool hole = true;
  for (const auto& record : regeneration.records) {
    if (!record) {
      hole = true;
      continue;
    }
    const double time_s = in_seconds(record->time);
    if (hole) {
      after_hole_s.push_back(time_s);
      hole = false;
    }
    flight::add_tick(result, *record, time_s, std::nullopt);
  }
}

// The recorder says so at its first tick, which is a few after the first of all: the flash must be ready.
void add_outages(flight::Flight& result, std::span<const Part> parts) {
  if (const auto rest = resumed(parts.front().flight)) {
    result.notes.push_back(fmt::format("This is the rest of a flight that was resumed after a reset ({}).",
                                       name(static_cast<protocol::ResumedAfter>(rest->value))));
  }
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto& before = parts[i - 1].flight.ticks;
    const auto& after = parts[i].flight.ticks;
    if (const auto rest = resumed(parts[i].flight); rest && !before.empty() && !after.empty()) {
      result.outages.push_back({.from_s = in_seconds(before.back().tick.time),
                                .to_s = in_seconds(after.front().tick.time),
                                .cause = std::string{name(static_cast<protocol::ResumedAfter>(rest->value))},
                                .resumed = true});
    }
  }
}

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

std::string plan_name(const Flight& flight) {
  if (flight.plan_block.empty()) {
    return {};
  }
  const std::uint32_t checksum = protocol::plan_block_crc(flight.plan_block);
  static const std::vector<NamedChecksum> shipped = shipped_plans();
  const auto found = std::ranges::find(shipped, checksum, &NamedChecksum::second);
  return found == shipped.end() ? fmt::format("plan {:08x}", checksum) : found->first;
}

core::Microseconds time_zero(const Flight& flight, const Regeneration& regeneration) {
  if (const auto begin = is_tunnel(flight) ? control_start(flight) : lift_off(regeneration)) {
    return *begin;
  }
  return flight.ticks.empty() ? flight.first_time : flight.ticks.front().tick.time;
}

std::string_view time_zero_text(const Flight& flight, const Regeneration& regeneration) {
  if (is_tunnel(flight)) {
    return control_start(flight) ? "control start"
                                 : "the beginning of the record, which does not show the start of "
                                   "control";
  }
  return lift_off(regeneration) ? "lift-off" : "the beginning of the record, which does not show lift-off";
}

flight::Flight to_report(const Flight& flight, const Regeneration& regeneration) {
  const Part whole{flight, regeneration};
  return to_report(std::span{&whole, 1});
}

flight::Flight to_report(std::span<const Part> parts) {
  const Flight& first = parts.front().flight;
  flight::Flight result;
  result.scenario = fmt::format("flight {}, power-up {}", first.number, first.power_up);
  result.vehicle = first.vehicle;
  result.plan_name = plan_name(first);
  result.version = first.firmware_version;
  result.plan = first.plan.value_or(core::default_plan());
  result.tunnel = is_tunnel(first);
  std::vector<double> after_hole_s;
  for (const Part& part : parts) {
    add_rows(result, part.regeneration, after_hole_s);
  }
  for (const Part& part : parts) {
    set_events(result, part.flight, after_hole_s);
    add_notes(result, part.flight, part.regeneration);
    result.differing_ticks += part.regeneration.differing;
  }
  add_outages(result, parts);
  flight::end_control_with_outage(result);
  if (const auto begin = result.tunnel ? std::nullopt : lift_off(parts.front().regeneration)) {
    result.events.liftoff_s = in_seconds(*begin);
  }
  flight::set_time_zero(result, in_seconds(time_zero(first, parts.front().regeneration)));
  return result;
}

}  // namespace fantail::flight_log
