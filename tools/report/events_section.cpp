// SPDX-License-Identifier: MIT
#include <algorithm>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "flight/gate.hpp"
#include "flight/phase_names.hpp"
#include "report/fields.hpp"
#include "report/sections.hpp"
#include "report/verdict_parts.hpp"
#include "text/number.hpp"

// What happened when.
namespace fantail::report {
namespace {

struct Moment {
  double time_s = 0.0;
  std::string what{};
  std::string meaning{};
};
constexpr auto moment_fields = result::fields<Moment>({
    {"time", "time", result::units::s, 3, &Moment::time_s, "on the clock of the rows"},
    {"what", "event", result::units::none, 0, &Moment::what, "what happened"},
    {"meaning", "meaning", result::units::none, 0, &Moment::meaning, "why, or what it is"},
});

/// Where it was not the apogee also what for.
std::string what_control_end_means(const flight::Flight& flight, const Verdict& verdict) {
  if (!was_under_control(flight.phase_changes)) {
    const std::string canards = commanded_to_trim(flight, flight.events.detected_s.value_or(0.0));
    const auto reason =
        flight.phase_changes.empty() ? core::PhaseReason::flew_without_launch : flight.phase_changes.back().reason;
    return reason == core::PhaseReason::flew_without_launch || !reason
               ? fmt::format("the rocket reports that it has flown; {}", canards)
               : fmt::format("{}; {}", flight::display_name(*reason), canards);
  }
  const auto outage = std::ranges::find(flight.outages, flight.events.control_end_s, &flight::Outage::from_s);
  if (outage != flight.outages.end()) {
    return outage->to_s ? fmt::format("with the last tick before {} s", text::fixed(*outage->to_s, 3))
                        : "with the last tick";
  }
  const std::string canards = commanded_to_trim(flight, *flight.events.control_end_s);
  if (!verdict.ended_early || flight.phase_changes.empty()) {
    return canards;
  }
  const auto reason = flight.phase_changes.back().reason;
  return fmt::format("{}; {}", !reason ? "the log does not say why" : flight::display_name(*reason), canards);
}

/// The gate closed again under control, and opened again. A record may miss where control began.
void add_gate_events(std::vector<Moment>& to, const flight::Flight& flight) {
  for (std::size_t i = 1; i < flight.phase_changes.size(); ++i) {
    const flight::PhaseChange& change = flight.phase_changes[i];
    const core::Phase before = flight.phase_changes[i - 1].phase;
    if (change.phase == core::Phase::dormant && before == core::Phase::controlling) {
      to.push_back({change.time_s, "gate closes", flight::gate_has_closed(flight) + ", canards commanded to trim"});
    } else if (change.phase == core::Phase::controlling &&
               !was_under_control(std::span{flight.phase_changes}.first(i))) {
      if (!flight.events.control_start_s) {
        to.push_back({change.time_s, "under control", "the record does not show when control began"});
      }
    } else if (change.phase == core::Phase::controlling) {
      to.push_back({change.time_s, "gate reopens", flight::gate_has_opened(flight) + ", control goes on"});
    }
  }
}

/// By time; of two at the same instant the one that stands first.
result::Table events(const flight::Flight& flight, const Verdict& verdict) {
  std::vector<Moment> all;
  for (const result::Figure& event : result::figures("", flight.events, fields::events).all) {
    if (const double* time_s = std::get_if<double>(&event.value)) {
      all.push_back({*time_s, event.label, event.meaning});
    }
  }
  for (Moment& one : all) {
    if (one.what == "lift-off" && !flight.seed) {
      one.meaning = "where the specific force left the pad's 1 g";
    } else if (one.what == "control starts" && flight.tunnel) {
      one.meaning = "roll angle is zero here, canards leave trim";
    } else if (one.what == "control starts" && flight.events.dormant_s) {
      one.meaning = flight::gate_has_opened(flight);
    } else if (one.what == "burn-out" && flight.path_frame == flight::PathFrame::plane) {
      one.meaning = "thrust no longer above drag in the trajectory; it may last longer";
    } else if (one.what == "dormant") {
      one.meaning = "canards at trim, waiting for " + flight::gate_name(flight);
    } else if (one.what == "control ends" && ends_a_wait(flight)) {
      one.what = "control never began";
      one.meaning = what_control_end_means(flight, verdict);
    } else if (one.what == "control ends") {
      one.meaning = what_control_end_means(flight, verdict);
    }
  }
  add_gate_events(all, flight);
  if (const auto jolt = jolt_after_apogee(flight)) {
    all.push_back({jolt->time_s, "jolt",
                   fmt::format("{} g along the axis, as when a parachute opens",
                               text::fixed(jolt->specific_force_m_s2 / 9.80665, 1))});
  }
  std::ranges::stable_sort(all, {}, &Moment::time_s);
  return result::table({}, all, moment_fields);
}

result::Table phases(const flight::Flight& flight) {
  std::vector<Moment> all;
  for (const flight::PhaseChange& change : flight.phase_changes) {
    const bool is_first = !flight.rows.empty() && change.time_s <= flight.rows.front().time_s;
    all.push_back({change.time_s, flight::display_name(change.phase), flight::why_it_began(change.reason, is_first)});
  }
  result::Table table = result::table({}, all, moment_fields);
  table.columns[1].label = "phase";
  table.columns[2].label = "reason";
  return table;
}

}  // namespace

result::Section events_section(const flight::Flight& flight, const Verdict& verdict) {
  result::Table table = events(flight, verdict);
  if (table.rows.empty()) {
    return {"Events", {std::string{flight.known.phase ? "No events." : "Not in the log."}}};
  }
  return {"Events", {std::move(table)}};
}

result::Section phases_section(const flight::Flight& flight) {
  using enum result::Readers;
  if (!flight.known.phase || flight.phase_changes.empty()) {
    return {"Phases", {std::string{flight.known.phase ? "Safe throughout." : "Not in the log."}}, files};
  }
  result::Table canards = result::table({}, flight.canard_verdict_changes, fields::canard_verdicts);
  return {"Phases", {phases(flight), std::move(canards)}, files};
}

}  // namespace fantail::report
