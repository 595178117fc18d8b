// SPDX-License-Identifier: MIT
#include "report/fault_sentences.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "text/number.hpp"

namespace fantail::report {

std::string unmeasured(const flight::Flight& flight) {
  const flight::Unmeasured& u = flight.unmeasured;
  std::string text;
  if (u.silent_from_s) {
    text +=
        fmt::format(" The gyro gave no usable rate for {} s in all, first at {} s; no roll was commanded meanwhile.",
                    text::fixed(u.silent_for_s, 3), text::fixed(*u.silent_from_s, 2));
  }
  if (u.speed_bound_from_s) {
    text += fmt::format(
        " From {} s on the avionics knew only lower bounds of height and speed, because every "
        "accelerometer was at the end of its range.",
        text::fixed(*u.speed_bound_from_s, 2));
  }
  return text;
}

namespace {

std::string until_when(const flight::Outage& outage) {
  return (outage.to_s ? fmt::format("to {} s", text::fixed(*outage.to_s, 3)) : "on") +
         (outage.resumed                         ? ", and then the flight was resumed"
          : outage.to_s && !outage.cause.empty() ? ", and then the flight was not resumed: the avionics was Safe"
                                                 : "");
}

}  // namespace

std::string outages(const flight::Flight& flight) {
  constexpr std::size_t most = 4;  // of which each is told
  const std::vector<flight::Outage>& all = flight.outages;
  const std::size_t told = all.size() > most ? most - 1 : all.size();
  std::string text;
  for (const flight::Outage& outage : std::span{all}.first(told)) {
    text += outage.cause.empty() ? " No" : fmt::format(" The processor was reset ({}): no", outage.cause);
    text += fmt::format(" tick is on record from {} s {}.", text::fixed(outage.from_s, 3), until_when(outage));
  }
  if (told < all.size()) {
    text += fmt::format(" That came {} more times, the last time from {} s {}.", all.size() - told,
                        text::fixed(all.back().from_s, 3), until_when(all.back()));
  }
  return text;
}

namespace {

// A flight's last tick is a fraction of a millisecond or, in a thinned table, a row before its end.
constexpr double tolerance_s = 0.1;

std::vector<Hole> unexplained_holes(const flight::Flight& flight, const Figures& f) {
  std::vector<Hole> holes;
  std::ranges::copy_if(f.holes, std::back_inserter(holes), [&](const Hole& hole) {
    return std::ranges::none_of(flight.outages, [&](const flight::Outage& outage) {
      return hole.from_s < outage.to_s.value_or(hole.to_s) && outage.from_s < hole.to_s;
    });
  });
  return holes;
}

bool lost_to_reset(const flight::Flight& flight) { return !flight.outages.empty() && !flight.outages.back().to_s; }

/// The first of control's end and apogee that the rows do not reach.
std::string what_is_not_reached(const flight::Flight& flight, const Figures& f) {
  const auto& [end_s, apogee_s] = std::pair{flight.events.control_end_s, flight.events.apogee_s};
  if (end_s && *end_s > f.end_s + tolerance_s) {
    return fmt::format("before control ended at {} s", text::fixed(*end_s, 2));
  }
  if (apogee_s && *apogee_s > f.end_s + tolerance_s) {
    return fmt::format("before apogee at {} s", text::fixed(*apogee_s, 2));
  }
  return {};
}

}  // namespace

std::string missing_ticks(const flight::Flight& flight, const Figures& f) {
  std::string text;
  if (f.end_s <= f.begin_s) {
    return text;  // one row, or none
  }
  if (const std::vector<Hole> holes = unexplained_holes(flight, f); !holes.empty()) {
    text += fmt::format(" No tick is on record from {} s to {} s", text::fixed(holes.front().from_s, 2),
                        text::fixed(holes.front().to_s, 2));
    const std::size_t more = holes.size() - 1;
    text += more > 0 ? fmt::format(", nor in {} more {}.", more, more == 1 ? "gap" : "gaps") : ".";
  }
  if (const std::optional<double>& start_s = flight.events.control_start_s;
      start_s && *start_s < f.begin_s - tolerance_s) {
    text += fmt::format(" The record begins at {} s, after control started at {} s.", text::fixed(f.begin_s, 2),
                        text::fixed(*start_s, 2));
  }
  if (const std::string event = what_is_not_reached(flight, f); !event.empty() && !lost_to_reset(flight)) {
    text += fmt::format(" The record ends at {} s, {}.", text::fixed(f.end_s, 2), event);
  }
  return text;
}

bool misses_control(const flight::Flight& flight, const Figures& f) {
  const double start_s = flight.events.control_start_s.value_or(f.begin_s);
  const double end_s = flight.events.control_end_s.value_or(f.end_s);
  return start_s < f.begin_s - tolerance_s || (end_s > f.end_s + tolerance_s && !lost_to_reset(flight)) ||
         std::ranges::any_of(
             unexplained_holes(flight, f),
             [&](const Hole& hole) {
               return std::min(hole.to_s, end_s) - std::max(hole.from_s, start_s) > tolerance_s;
             });
}

std::string canard_faults(const flight::Flight& flight) {
  std::string text;
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    std::vector<flight::CanardVerdictChange> changes;
    std::ranges::copy_if(flight.canard_verdict_changes, std::back_inserter(changes),
                         [canard](const auto& change) { return change.canard == canard; });
    const auto healthy = [](const auto& change) { return change.verdict == core::CanardVerdict::healthy; };
    changes.erase(changes.begin(), std::ranges::find_if_not(changes, healthy));
    if (changes.empty()) {
      continue;
    }
    std::vector<std::string_view> verdicts;
    for (const auto& change : changes) {
      const std::string_view name = core::name(change.verdict);
      if (!healthy(change) && std::ranges::find(verdicts, name) == verdicts.end()) {
        verdicts.push_back(name);
      }
    }
    const bool ends_healthy = healthy(changes.back());
    const bool recovers = std::ranges::count_if(changes, healthy) > (ends_healthy ? 1 : 0);
    text += fmt::format(" Canard {} {} from {} s to {}{}{}.", canard + 1, fmt::join(verdicts, ", "),
                        text::fixed(changes[0].time_s, 2),
                        ends_healthy ? text::fixed(changes.back().time_s, 2) + " s" : "the end",
                        recovers ? ", healthy in between" : "", ends_healthy ? ", then healthy" : "");
  }
  return text;
}

}  // namespace fantail::report
