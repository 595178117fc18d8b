// SPDX-License-Identifier: MIT
#include "fantail/fly_summary.hpp"

#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "fantail/terminal.hpp"
#include "fantail/verdict_color.hpp"
#include "flight/phase_names.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

void print_figure(std::string_view label, const std::optional<double>& value, std::string_view format) {
  if (value) {
    show("  {:<22}{}\n", label, fmt::format(fmt::runtime(format), *value));
  }
}

void print_apogee(const flight::Flight& flight, const report::Figures& figures) {
  if (figures.apogee_m) {
    print_figure("apogee", figures.apogee_m, "{:.1f} m");
    print_figure("  at time", flight.events.apogee_s, "{:.2f} s");
  } else {
    print_figure("apogee", flight.events.apogee_s, "at {:.2f} s; no tick is on record there");
  }
}

/// Where it was not the apogee: when, what for, and what became of the roll.
void print_control_end(const flight::Flight& flight, const report::Results& results) {
  const std::optional<double>& turned_rad = results.figures.roll_after_end_rad;
  if (!results.verdict.ended_early || !flight.events.control_end_s || !turned_rad) {
    return;
  }
  const auto reason = flight.phase_changes.back().reason;
  show("  {:<22}{:.2f} s ({}); the roll then turned by up to {:.1f} deg\n", "control ends",
       *flight.events.control_end_s,
       !reason                                          ? "the log does not say why"
       : reason == core::PhaseReason::control_time_over ? "plan"
                                                        : flight::display_name(*reason),
       text::degrees(*turned_rad));
}

}  // namespace

void print_summary(const flight::Flight& flight, const report::Results& results) {
  show("{} ({}), seed {}\n{}\n", text::printable(flight.scenario), text::printable(flight.vehicle),
       flight.seed.value_or(0), painted_verdict(results.verdict));
  if (!flight.changes.empty()) {
    show("Changed on the command line: {}.\n", text::printable(fmt::format("{}", fmt::join(flight.changes, ", "))));
  }
  std::vector<std::string> assumed = flight.notes;
  if (const std::string imposed = flight::imposed_roll_sentence(flight); !imposed.empty()) {
    assumed.insert(assumed.begin(), imposed);
  }
  show("{}", assumed.empty() ? "" : "\nAssumptions and notes:\n");
  for (const std::string& sentence : assumed) {
    show("  {}\n", text::printable(sentence));
  }
  show("\n");
  const flight::Events& events = flight.events;
  const auto percent = results.figures.saturated_fraction;
  print_figure("launch detected", events.detected_s, "{:.3f} s after lift-off");
  print_figure("control starts", flight.tunnel ? std::nullopt : events.control_start_s, "{:.3f} s after lift-off");
  print_figure("  at height", results.figures.control_start_height_m, "{:.2f} m");
  print_control_end(flight, results);
  const bool is_highest_first = events.burnout_s && events.apogee_s && *events.apogee_s < *events.burnout_s;
  if (is_highest_first) {
    print_apogee(flight, results.figures);
  }
  print_figure("burn-out", events.burnout_s, "{:.2f} s");
  std::string speed{report::top_speed_name(flight)};
  speed.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(speed.front())));
  print_figure(speed, results.figures.max_speed_m_s, "{:.1f} m/s");
  if (!is_highest_first) {
    print_apogee(flight, results.figures);
  }
  for (const flight::LoopMargin& margin : report::different_margins(flight)) {
    show("  {:<22}{:.0f} deg at {:.0f} m/s, gain margin {}\n", "phase margin", text::degrees(margin.phase_margin_rad),
         margin.speed_m_s, report::gain_margin_text(margin));
  }
  print_figure("saturated", percent ? std::optional{100.0 * *percent} : std::nullopt, "{:.1f} % of control time");
}

}  // namespace fantail::tool
