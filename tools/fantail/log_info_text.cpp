// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "fantail/log_info.hpp"
#include "flight_log/event_text.hpp"
#include "flight_log/integrity.hpp"
#include "protocol/plan_block.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

constexpr std::size_t most_events_shown = 60;

std::string line(std::string_view label, std::string_view text) { return fmt::format("  {:<10}{}\n", label, text); }

std::string or_unknown(const std::string& text) { return text.empty() ? "not known" : text; }

std::string plan_words(const FlightInfo& info) {
  if (info.flight.plan_block.empty()) {
    return "not known";
  }
  const std::uint32_t checksum = protocol::plan_block_crc(info.flight.plan_block);
  const std::string fault = info.flight.plan ? "" : "; it cannot be used: " + info.flight.plan_fault;
  // A plan that is not a shipped one is called after its checksum.
  const std::string known = info.plan == fmt::format("plan {:08x}", checksum) ? "" : info.plan + ", ";
  return fmt::format("{}checksum {:08x}{}", known, checksum, fault);
}

std::string extent_words(const FlightInfo& info) {
  const flight_log::Flight& flight = info.flight;
  const std::size_t ticks = flight.ticks.size() + flight.foreign_ticks.size();
  return fmt::format("{:.3f} s, from {:.3f} s to {:.3f} s; {}",
                     static_cast<double>((flight.last_time - flight.first_time).count()) / 1e6,
                     info.seconds(flight.first_time), info.seconds(flight.last_time), text::counted(ticks, "tick"));
}

std::string duration_words(const flight_log::LoopTimes& loop) {
  if (loop.longest_us == 0.0) {
    return "no tick durations: the simulated clock does not advance during a tick";
  }
  return fmt::format("a tick takes {:.1f} us on average, 99 of 100 at most {:.0f} us, the longest {:.0f} us; {}",
                     loop.mean_us, loop.p99_us, loop.longest_us,
                     loop.late == 0 ? "none was late" : fmt::format("{} took a millisecond or more", loop.late));
}

std::string loop_words(const flight_log::LoopTimes& loop, bool has_gaps) {
  return fmt::format("{}\n{:12}longest step from one tick to the next{}: {:.3f} ms", duration_words(loop), "",
                     has_gaps ? ", except for the gaps in the log" : "", 1e-3 * loop.longest_step_us);
}

std::string health_words(const flight_log::HealthFigures& health) {
  return fmt::format("at most {} waited for the flash, {} dropped; bus: {} unsent, {}",
                     text::counted(health.longest_queue, "tick"), health.ticks_dropped,
                     text::counted(health.unsent, "frame"), text::counted(health.bus_errors, "error"));
}

std::string event_list(const FlightInfo& info) {
  const auto& events = info.flight.events;
  std::string text = events.empty() ? ""
                                    : "\n"
                                      "  time / s   event\n";
  for (std::size_t i = 0; i < std::min(events.size(), most_events_shown); ++i) {
    text += fmt::format("  {:>9.3f}  {}\n", info.seconds(events[i].time),
                        flight_log::event_text(events[i], info.flight.first_time));
  }
  if (events.size() > most_events_shown) {
    text += fmt::format("  and {} more, listed by --json\n", events.size() - most_events_shown);
  }
  return text;
}

}  // namespace

std::string log_info_text(const FlightInfo& info) {
  const flight_log::Flight& flight = info.flight;
  std::string text = fmt::format("\nFlight {}: from sector {} of the flight memory on, power-up {}\n",
                                 info.flight.number, flight.flight, flight.power_up);
  text += line("vehicle", or_unknown(flight.vehicle));
  text += line("firmware", fmt::format("{}, git {}, log format {}", or_unknown(flight.firmware_version),
                                       or_unknown(flight.git_hash), flight.format_version));
  text += line("plan", plan_words(info));
  text += line("sensors", or_unknown(flight.sensors));
  text += line("recorded", extent_words(info));
  text += line("clock", fmt::format("seconds from {}", info.zero_text));
  text += line("integrity", flight_log::integrity_text(flight));
  text += line("replay", flight_log::replay_text(flight, info.replay));
  if (info.loop) {
    text += line("loop", loop_words(*info.loop, !flight.gaps.empty()));
  }
  if (info.health) {
    text += line("health", health_words(*info.health));
  }
  return text + event_list(info);
}

}  // namespace fantail::tool
