// SPDX-License-Identifier: MIT
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "json/value.hpp"
#include "report/results.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/quoting.hpp"

namespace fantail::report {
namespace {

using Json = json::Value;

// Null without the file: a folder may hold nothing but the CSV.
Json read(const std::filesystem::path& file) {
  const std::optional<std::string> content = text::read_if_there(file);
  if (!content) {
    return {};
  }
  try {
    Json summary = json::parse(*content);
    if (!summary.is_object()) {
      throw json::Error{"no object"};
    }
    return summary;
  } catch (const json::Error&) {
    throw text::Error{text::ErrorKind::bad_data, file.string() + ": is not the summary of a flight"};
  }
}

// The member of an object, or null.
const Json& member(const Json& object, const char* name) {
  static const Json null;
  const Json* found = object.find(name);
  return found != nullptr ? *found : null;
}

std::string text(const Json& object, const char* name) {
  const Json& value = member(object, name);
  return value.is_text() ? text::printable(value.text()) : std::string{};
}

/// Of a list, the texts.
std::vector<std::string> texts(const Json& object, const char* name) {
  std::vector<std::string> all;
  for (const Json& value : member(object, name)) {
    if (value.is_text()) {
      all.push_back(text::printable(value.text()));
    }
  }
  return all;
}

std::vector<double> numbers(const Json& object, const char* name) {
  std::vector<double> all;
  for (const Json& value : member(object, name)) {
    if (value.is_number()) {
      all.push_back(value.number());
    }
  }
  return all;
}

std::optional<double> number(const Json& object, const char* name) {
  const Json& value = member(object, name);
  return value.is_number() ? std::optional{value.number()} : std::nullopt;
}

// The value of an enumeration that has this name.
template <typename Enum>
std::optional<Enum> named(const std::string& word, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (core::name(static_cast<Enum>(i)) == word) {
      return static_cast<Enum>(i);
    }
  }
  return {};
}

std::optional<flight::FlownAirframe> airframe(const Json& summary) {
  const auto inertia_kg_m2 = number(summary, "roll_inertia_kg_m2");
  const auto area_m2 = number(summary, "reference_area_m2");
  if (!inertia_kg_m2 || !area_m2 || *inertia_kg_m2 <= 0.0 || *area_m2 <= 0.0) {
    return {};
  }
  std::map<double, double> course;
  for (const Json& point : member(summary, "roll_inertia_course")) {
    const auto time_s = number(point, "time_s");
    const auto kg_m2 = number(point, "kg_m2");
    if (time_s && kg_m2 && *kg_m2 > 0.0) {
      course[*time_s] = *kg_m2;
    }
  }
  return flight::FlownAirframe{.vehicle = text(summary, "vehicle"),
                               .vehicle_file = text(summary, "vehicle_file"),
                               .roll_inertia_kg_m2 = *inertia_kg_m2,
                               .reference_area_m2 = *area_m2,
                               .changes = texts(summary, "changes"),
                               .roll_inertia_course = course,
                               .grows_with_mach = text(summary, "compressibility") == "prandtl_glauert"};
}

void read_events(flight::Events& events, const Json& json) {
  for (const auto& [name, time_s] : flight::named_events) {
    if (const auto value = number(json, name)) {
      events.*time_s = value;
    }
  }
}

void read_phase_changes(flight::Flight& flight, const Json& list) {
  if (!list.is_array()) {
    return;
  }
  flight.phase_changes.clear();
  for (const Json& change : list) {
    const auto phase = named<core::Phase>(text(change, "phase"), core::phases);
    const auto time_s = number(change, "time_s");
    if (phase && time_s) {
      flight.phase_changes.push_back(
          {*time_s, *phase, named<core::PhaseReason>(text(change, "reason"), core::phase_reasons)});
    }
  }
}

void read_canard_verdicts(flight::Flight& flight, const Json& list) {
  for (const Json& change : list) {
    const auto verdict = named<core::CanardVerdict>(text(change, "verdict"), core::canard_verdicts);
    const auto canard = number(change, "canard");
    const auto time_s = number(change, "time_s");
    if (verdict && canard && time_s && *canard >= 1.0 && *canard <= core::canard_count) {
      flight.canard_verdict_changes.push_back({*time_s, static_cast<std::size_t>(*canard) - 1, *verdict});
    }
  }
}

void read_unmeasured(flight::Unmeasured& u, const Json& json) {
  u.spin_from_s = number(json, "spin_from_s");
  u.spin_for_s = number(json, "spin_for_s").value_or(0.0);
  u.spin_rad_s = text::radians(number(json, "spin_deg_s").value_or(0.0));
  u.silent_from_s = number(json, "silent_from_s");
  u.silent_for_s = number(json, "silent_for_s").value_or(0.0);
  u.speed_bound_from_s = number(json, "speed_bound_from_s");
}

void read_barometer(flight::Flight& flight, const Json& list) {
  for (const Json& spell : list) {
    const auto state = named<core::BarometerState>(text(spell, "state"), core::barometer_states);
    const auto from_s = number(spell, "from_s");
    const auto to_s = number(spell, "to_s");
    if (state && from_s && to_s) {
      flight.barometer_spells.push_back({*state, *from_s, *to_s});
    }
  }
}

void read_outages(flight::Flight& flight, const Json& list) {
  for (const Json& outage : list) {
    if (const auto from_s = number(outage, "from_s")) {
      flight.outages.push_back({.from_s = *from_s,
                                .to_s = number(outage, "to_s"),
                                .cause = text(outage, "cause"),
                                .resumed = member(outage, "resumed") == Json(true)});
    }
  }
}

void read_loop_margins(flight::Flight& flight, const Json& list) {
  for (const Json& margin : list) {
    const auto speed_m_s = number(margin, "speed_m_s");
    const auto phase_margin_deg = number(margin, "phase_margin_deg");
    if (speed_m_s && phase_margin_deg) {
      flight.loop_margins.push_back({*speed_m_s, text::radians(*phase_margin_deg), number(margin, "gain_margin"),
                                     number(margin, "crossover_rad_s")});
    }
  }
}

}  // namespace

flight::Events summary_events(const std::filesystem::path& file) {
  flight::Events events;
  read_events(events, member(read(file), "events"));
  return events;
}

flight::Unmeasured summary_unmeasured(const std::filesystem::path& file) {
  flight::Unmeasured unmeasured;
  read_unmeasured(unmeasured, member(read(file), "unmeasured"));
  return unmeasured;
}

SummaryOfControl summary_of_control(const std::filesystem::path& file) {
  const Json summary = read(file);
  const Json& events = member(summary, "events");
  return {.start_s = number(events, "control_start_s"),
          .end_s = number(events, "control_end_s"),
          .time_s = number(summary, "control_time_s"),
          .roll_turns = number(summary, "roll_turns")};
}

std::optional<std::string> summary_log_sha256(const std::filesystem::path& file) {
  const std::string sha256 = text(read(file), "log_sha256");
  return sha256.empty() ? std::nullopt : std::optional{sha256};
}

std::optional<flight::FlownAirframe> summary_airframe(const std::filesystem::path& file) {
  return airframe(read(file));
}

void add_summary(flight::Flight& flight, const std::filesystem::path& file) {
  const Json summary = read(file);
  if (summary.is_null()) {
    return;
  }
  flight.scenario = text(summary, "scenario");
  flight.vehicle = text(summary, "vehicle");
  flight.airframe = airframe(summary);
  flight.plan_name = text(summary, "plan");
  flight.version = text(summary, "version");
  if (const Json& seed = member(summary, "seed"); seed.is_count()) {
    flight.seed = seed.count();
  }
  read_events(flight.events, member(summary, "events"));
  read_phase_changes(flight, member(summary, "phase_changes"));
  read_canard_verdicts(flight, member(summary, "canard_verdicts"));
  flight.why_not_armed = text(summary, "why_not_armed");
  flight.trajectory_end_s = number(summary, "trajectory_end_s");
  flight.extremes = {.top_mach = number(summary, "top_mach"),
                     .static_margin_calibres = number(summary, "static_margin_calibres")};
  if (const auto attack_deg = number(summary, "angle_of_attack_deg")) {
    flight.extremes.angle_of_attack_rad = text::radians(*attack_deg);
  }
  flight.rest_limit_rad =
      text::radians(number(summary, "rest_limit_deg").value_or(text::degrees(flight.rest_limit_rad)));
  flight.tilt_end_before_apogee_s =
      number(summary, "tilt_end_before_apogee_s").value_or(flight.tilt_end_before_apogee_s);
  read_unmeasured(flight.unmeasured, member(summary, "unmeasured"));
  read_barometer(flight, member(summary, "barometer"));
  flight.before_burnout = read_before_burnout(member(summary, "before_burnout"));
  read_outages(flight, member(summary, "outages"));
  read_loop_margins(flight, member(summary, "loop_margins"));
  const Json& reach = member(summary, "canard_reach_deg");
  if (const auto lowest_deg = number(reach, "lowest"), highest_deg = number(reach, "highest");
      lowest_deg && highest_deg) {
    flight.canard_reach = {.lowest_rad = text::radians(*lowest_deg), .highest_rad = text::radians(*highest_deg)};
  }
  const Json& wind = member(summary, "wind");
  if (const auto speed_m_s = number(wind, "speed_m_s"), from_deg = number(wind, "from_deg"); speed_m_s && from_deg) {
    flight.wind = {.speed_m_s = *speed_m_s,
                   .from_rad = text::radians(*from_deg),
                   .height_m = number(wind, "height_m").value_or(0.0)};
  }
  flight.side_moment_m3 = number(summary, "canard_side_moment_m3");
  if (const std::vector<double> ends = numbers(summary, "pitch_frequency_per_speed_rad_m"); ends.size() == 2) {
    flight.resonance_1_m = {ends[0], ends[1]};
  }
  flight.why_uncontrollable = text(summary, "why_uncontrollable");
  flight.left_by_fins = number(summary, "left_by_fins").value_or(flight.left_by_fins);
  const Json& imposed = member(summary, "imposed_roll");
  if (const auto time_s = number(imposed, "time_s")) {
    flight.imposed_roll = {.time_s = *time_s,
                           .angle_rad = text::radians(number(imposed, "angle_deg").value_or(0.0)),
                           .rate_rad_s = text::radians(number(imposed, "rate_deg_s").value_or(0.0))};
  }
  flight.changes = texts(summary, "changes");
  for (std::string& note : texts(summary, "notes")) {
    flight.notes.push_back(std::move(note));
  }
}

}  // namespace fantail::report
