// SPDX-License-Identifier: MIT
#include "logs/summary.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "json/value.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

using Json = json::Value;

// Null without the file: a folder may hold nothing but the CSV.
Json read(const std::filesystem::path& file) {
  std::ifstream stream{file};
  if (!stream) {
    return {};
  }
  try {
    Json summary = json::parse(std::string{std::istreambuf_iterator<char>{stream}, {}});
    if (!summary.is_object()) {
      throw json::Error{"no object"};
    }
    return summary;
  } catch (const json::Error&) {
    throw text::Error{text::ErrorKind::bad_data, file.string() + ": not the JSON of a flight's summary"};
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
  return value.is_text() ? value.text() : std::string{};
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

void read_events(flight::Events& events, const Json& json) {
  const auto read = [&json](std::optional<double>& event, const char* name) {
    if (const auto value = number(json, name)) {
      event = value;
    }
  };
  read(events.liftoff_s, "liftoff_s");
  read(events.detected_s, "detected_s");
  read(events.guide_clear_s, "guide_clear_s");
  read(events.control_start_s, "control_start_s");
  read(events.burnout_s, "burnout_s");
  read(events.control_end_s, "control_end_s");
  read(events.apogee_s, "apogee_s");
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

}  // namespace

flight::Events summary_events(const std::filesystem::path& file) {
  flight::Events events;
  read_events(events, member(read(file), "events"));
  return events;
}

void add_summary(flight::Flight& flight, const std::filesystem::path& file) {
  const Json summary = read(file);
  if (summary.is_null()) {
    return;
  }
  flight.scenario = text(summary, "scenario");
  flight.vehicle = text(summary, "vehicle");
  flight.plan_name = text(summary, "plan");
  flight.version = text(summary, "version");
  if (const Json& seed = member(summary, "seed"); seed.is_count()) {
    flight.seed = seed.count();
  }
  read_events(flight.events, member(summary, "events"));
  read_phase_changes(flight, member(summary, "phase_changes"));
  read_canard_verdicts(flight, member(summary, "canard_verdicts"));
  const Json& imposed = member(summary, "imposed_roll");
  if (const auto time_s = number(imposed, "time_s")) {
    flight.imposed_roll = {.time_s = *time_s,
                           .angle_rad = text::radians(number(imposed, "angle_deg").value_or(0.0)),
                           .rate_rad_s = text::radians(number(imposed, "rate_deg_s").value_or(0.0))};
  }
  for (const Json& note : member(summary, "notes")) {
    if (note.is_text()) {
      flight.notes.push_back(note.text());
    }
  }
}

}  // namespace fantail::logs
