// SPDX-License-Identifier: MIT
#include "fantail/exported.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "fantail/command_line.hpp"
#include "flight_log/to_report.hpp"
#include "input/messages.hpp"
#include "log_export/formats.hpp"
#include "text/error.hpp"

namespace fantail::tool {
namespace {

[[noreturn]] void refuse_fields(const std::string& complaint) { throw UsageError{"--fields: " + complaint}; }

[[noreturn]] void refuse_log(const ExportQuestion& question, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, question.log + ": " + complaint};
}

void require_once(std::span<const std::string> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::ranges::find(names.first(i), names[i]) != names.begin() + static_cast<std::ptrdiff_t>(i)) {
      refuse_fields(names[i] + " stands there twice");
    }
  }
}

std::optional<log_export::Selection> selection(const ExportQuestion& question) {
  if (question.fields.empty()) {
    return {};
  }
  log_export::Selection chosen;
  for (const std::string& name : question.fields) {
    const auto field = log_export::find_field(name);
    if (!field) {
      refuse_fields(log_export::unknown_field(name));
    }
    chosen.push_back(*field);
  }
  return chosen;
}

flight_log::Regeneration replay_of(const flight_log::Flight& flight) {
  if (flight.plan) {
    return flight_log::regenerate(flight, *flight.plan);
  }
  flight_log::Regeneration none;
  none.records.resize(flight.ticks.size());
  none.unreachable = flight.ticks.size();
  none.obstacle = flight.has_header ? fmt::format("Its plan cannot be used: {}.", flight.plan_fault)
                                    : "No intact header is left, and so no plan.";
  return none;
}

std::string content(const ExportQuestion& question, const log_export::ReplayedFlight& source,
                    const flight::Flight& report, const std::optional<log_export::Selection>& chosen) {
  if (question.format->name == "csv") {
    return chosen ? log_export::csv(source, *chosen) : log_export::flight_csv(source, report);
  }
  if (question.format->name == "candump") {
    return log_export::candump(source);
  }
  if (question.format->name == "lcm") {
    return log_export::lcm(source);
  }
  const log_export::Selection fields = chosen.value_or(log_export::every_field());
  return question.format->name == "ulog" ? log_export::ulog(source, fields) : log_export::json(source, fields);
}

Exported export_foreign(const ExportQuestion& question, const flight_log::Flight& flight) {
  const std::vector<std::string> all = log_export::foreign_fields(flight);
  constexpr std::string_view what = "its ticks have the layout of another version of Fantail";
  if (all.empty()) {
    refuse_log(question, fmt::format("{}, and its schema does not say how", what));
  }
  if (question.format->name != "csv") {
    refuse_log(question, fmt::format("{}; what they hold can be exported with --to csv", what));
  }
  for (const std::string& name : question.fields) {
    if (std::ranges::find(all, name) == all.end()) {
      const auto meant = input::suggestion(name, all);
      refuse_fields(fmt::format("no field \"{}\"{} in this log of another version; there are: {}", name,
                                meant ? " (did you mean " + *meant + "?)" : "", fmt::join(all, ", ")));
    }
  }
  return {
      .bytes = log_export::foreign_csv(flight, question.fields.empty() ? all : question.fields, question.window),
      .notes = {fmt::format("Written by Fantail {}: {}. The table holds what the log contains; nothing was replayed.",
                            flight.firmware_version, what)}};
}

}  // namespace

Exported export_flight(const ExportQuestion& question, const flight_log::Flight& flight) {
  if (!question.fields.empty() && !question.format->has_fields) {
    refuse_fields(
        fmt::format("--to {} has messages of its own; allowed with csv, ulog and json", question.format->name));
  }
  require_once(question.fields);
  if (!flight.foreign_ticks.empty()) {
    return export_foreign(question, flight);
  }
  const auto chosen = selection(question);
  if (flight.ticks.empty()) {
    refuse_log(question, "holds no tick of the flight");
  }
  const flight_log::Regeneration replay = replay_of(flight);
  const bool shows_recorded = chosen || question.format->name == "ulog" || question.format->name == "json";
  if (!shows_recorded && replay.compared == 0) {
    // A file of nothing but headers would look like a success.
    refuse_log(question, fmt::format("{} What the log itself contains can be exported: --to csv --fields "
                                     "time_us,phase,command_deg,rate_x_count,encoder_1_count",
                                     replay.obstacle.empty() ? "No tick of it can be replayed." : replay.obstacle));
  }
  const flight::Flight report = flight_log::to_report(flight, replay);
  const log_export::ReplayedFlight source{flight, replay, report, question.window};
  if (std::ranges::none_of(flight.ticks, [&](const auto& t) { return source.inside(t.tick.time); })) {
    refuse_log(question, fmt::format("no tick between --from and --until; the log goes from {:.6f} s to {:.6f} s",
                                     source.time_s(flight.ticks.front().tick.time),
                                     source.time_s(flight.ticks.back().tick.time)));
  }
  return {.bytes = content(question, source, report, chosen), .notes = report.notes};
}

}  // namespace fantail::tool
