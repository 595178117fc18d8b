// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "report/verdict_parts.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

// A flight's last tick is a fraction of a millisecond or, in a thinned table, a row before its end.
constexpr double tolerance_s = RunningExtent::shortest_hole_s;

std::string seconds(double time_s) { return text::fixed(time_s, 2) + " s"; }

/// The plan's gate had closed again there: nobody asks for a hold error.
bool is_pause(const flight::Flight& flight, const Hole& hole) {
  return std::ranges::any_of(flight.phase_changes, [&](const flight::PhaseChange& change) {
    return change.phase == core::Phase::dormant && change.time_s > hole.from_s && change.time_s <= hole.to_s;
  });
}

std::vector<Hole> unexplained_holes(const flight::Flight& flight, const Extent& extent) {
  std::vector<Hole> holes;
  std::ranges::copy_if(extent.holes, std::back_inserter(holes), [&](const Hole& hole) {
    return std::ranges::none_of(flight.outages, [&](const flight::Outage& outage) {
      return hole.from_s < outage.to_s.value_or(hole.to_s) && outage.from_s < hole.to_s;
    });
  });
  std::erase_if(holes, [&](const Hole& hole) { return is_pause(flight, hole); });
  return holes;
}

bool lost_to_reset(const flight::Flight& flight) { return !flight.outages.empty() && !flight.outages.back().to_s; }

/// The first of control's end and apogee that is behind the last known roll angle.
std::string what_is_not_reached(const flight::Flight& flight, const Figures& f) {
  const auto is_behind = [&f](const std::optional<double>& time_s) {
    return time_s && *time_s > f.roll.end_s + tolerance_s;
  };
  if (is_behind(flight.events.control_end_s)) {
    return "control ended at " + seconds(*flight.events.control_end_s);
  }
  return is_behind(flight.events.apogee_s) ? "apogee was at " + seconds(*flight.events.apogee_s) : "";
}

/// "The roll is not known from 3.00 s to 5.00 s, nor in 1 more gap".
std::string of_holes(std::string_view what, const std::vector<Hole>& holes) {
  const std::size_t more = holes.size() - 1;
  return fmt::format("{} is not known from {} to {}{}", what, seconds(holes.front().from_s),
                     seconds(holes.front().to_s),
                     more > 0 ? fmt::format(", nor in {} more {}", more, more == 1 ? "gap" : "gaps") : "");
}

bool misses_roll(const flight::Flight& flight, const Figures& f) {
  const double start_s = flight.events.control_start_s.value_or(f.roll.begin_s);
  const double end_s = flight.events.control_end_s.value_or(f.roll.end_s);
  const auto is_under_control = [&](const Hole& hole) {
    return std::min(hole.to_s, end_s) - std::max(hole.from_s, start_s) > tolerance_s;
  };
  return f.begins_under_control || f.roll.is_thin() || start_s < f.roll.begin_s - tolerance_s ||
         (end_s > f.roll.end_s + tolerance_s && !lost_to_reset(flight)) ||
         std::ranges::any_of(unexplained_holes(flight, f.roll), is_under_control);
}

/// Then the roll's own sentences are enough.
bool is_of_unknown_roll(const Figures& f, const Hole& hole) {
  return hole.from_s < f.roll.begin_s - tolerance_s || hole.to_s > f.roll.end_s + tolerance_s ||
         std::ranges::any_of(f.roll.holes, [&](const Hole& of_roll) {
           return of_roll.from_s < hole.to_s && hole.from_s < of_roll.to_s;
         });
}

/// What is not known of the hold error where the roll is known, a clause each.
std::vector<std::string> unknown_hold(const flight::Flight& flight, const Figures& f) {
  const Extent& known = f.hold.known;
  const double from_s = f.hold.control_from_s;
  const double to_s = f.hold.control_to_s;
  std::vector<std::string> clauses;
  if (!f.hold.is_ever_known || f.roll.is_thin()) {
    return clauses;
  }
  std::vector<Hole> holes = unexplained_holes(flight, known);
  std::erase_if(holes, [&](const Hole& hole) { return is_of_unknown_roll(f, hole); });
  if (!holes.empty()) {
    clauses.push_back(of_holes("The hold error", holes));
  }
  if (known.begin_s > from_s + tolerance_s && !is_of_unknown_roll(f, {from_s, known.begin_s})) {
    clauses.push_back(fmt::format("The hold error is known only from {} on, and the record shows control from {} on",
                                  seconds(known.begin_s), seconds(from_s)));
  }
  if (known.end_s < to_s - tolerance_s && !is_of_unknown_roll(f, {known.end_s, to_s})) {
    clauses.push_back(fmt::format("The hold error is known only until {}, and the record shows control until {}",
                                  seconds(known.end_s), seconds(to_s)));
  }
  return clauses;
}

}  // namespace

std::string_view what_misses_control(const flight::Flight& flight, const Figures& f) {
  if (misses_roll(flight, f)) {
    return "the roll is not known at all times under control";
  }
  return unknown_hold(flight, f).empty() ? "" : "the hold error is not known at all times under control";
}

std::string what_hold_lacks(const HoldRecord& hold) {
  std::vector<std::string_view> words;
  for (const auto& [is_missing, word] : {std::pair{hold.lacks_roll, "the measured roll angle"},
                                         {hold.lacks_reference, "the reference"},
                                         {hold.lacks_fin_offset, "the fin offset"},
                                         {hold.lacks_speed, "the speed"}}) {
    if (is_missing) {
      words.emplace_back(word);
    }
  }
  return fmt::format("{}", fmt::join(words, " or "));
}

std::string unknown_roll(const flight::Flight& flight, const Figures& f) {
  if (f.roll.end_s <= f.roll.begin_s) {
    return {};  // known once, or never
  }
  std::string text;
  if (f.roll.is_thin()) {
    text = fmt::format(" The roll is known only every {} s.", text::brief(f.roll.usual_step_s, 2));
  } else if (const std::vector<Hole> holes = unexplained_holes(flight, f.roll); !holes.empty()) {
    text = fmt::format(" {}.", of_holes("The roll", holes));
  } else if (f.roll.usual_step_s > 0.5 * RunningExtent::shortest_hole_s) {
    text = fmt::format(" The roll is known every {} s, and may have been farther off in between.",
                       text::brief(f.roll.usual_step_s, 2));
  }
  const auto& start_s = flight.events.control_start_s;
  if (start_s && *start_s < f.roll.begin_s - tolerance_s) {
    text += fmt::format(" The roll is known only from {} on, and control started at {}.", seconds(f.roll.begin_s),
                        seconds(*start_s));
  } else if (f.begins_under_control && !start_s) {
    text += " The record begins under control.";
  }
  if (const std::string event = what_is_not_reached(flight, f); !event.empty() && !lost_to_reset(flight)) {
    text += fmt::format(" The roll is known only until {}, and {}.", seconds(f.roll.end_s), event);
  }
  const std::string lacks = what_hold_lacks(f.hold);
  for (const std::string& clause : unknown_hold(flight, f)) {
    text += fmt::format(" {}{}.", clause, lacks.empty() ? "" : fmt::format(": {} is missing", lacks));
  }
  return text;
}

bool may_hide_control(const flight::Flight& flight, const Figures& f) {
  const auto& changes = flight.phase_changes;
  const std::vector<Hole> holes = unexplained_holes(flight, f.roll);
  for (std::size_t i = 1; i < changes.size(); ++i) {
    const bool is_open = changes[i].phase == core::Phase::finished &&
                         changes[i - 1].phase != core::Phase::controlling &&
                         changes[i].reason != core::PhaseReason::gate_never_opened;
    if (is_open && std::ranges::any_of(holes, [&](const Hole& hole) {
          return hole.from_s < changes[i].time_s && changes[i].time_s < hole.to_s + tolerance_s;
        })) {
      return true;
    }
  }
  return false;
}

bool ends_under_control(const flight::Flight& flight, const Figures& f) {
  return f.final_phase == core::Phase::controlling &&
         (flight.events.control_end_s
              ? *flight.events.control_end_s > f.roll.end_s + tolerance_s
              : !flight.events.apogee_s || *flight.events.apogee_s > f.roll.end_s + tolerance_s);
}

}  // namespace fantail::report
