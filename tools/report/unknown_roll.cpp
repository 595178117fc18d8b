// SPDX-License-Identifier: MIT
#include "report/unknown_roll.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "text/number.hpp"

namespace fantail::report {
namespace {

// A flight's last tick is a fraction of a millisecond or, in a thinned table, a row before its end.
constexpr double tolerance_s = RunningExtent::shortest_hole_s;

std::string seconds(double time_s) { return text::fixed(time_s, 2) + " s"; }

std::vector<Hole> unexplained_holes(const flight::Flight& flight, const Figures& f) {
  std::vector<Hole> holes;
  std::ranges::copy_if(f.roll.holes, std::back_inserter(holes), [&](const Hole& hole) {
    return std::ranges::none_of(flight.outages, [&](const flight::Outage& outage) {
      return hole.from_s < outage.to_s.value_or(hole.to_s) && outage.from_s < hole.to_s;
    });
  });
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

std::string of_holes(const std::vector<Hole>& holes) {
  if (holes.empty()) {
    return {};
  }
  const std::size_t more = holes.size() - 1;
  return fmt::format(" The roll is not known from {} to {}{}.", seconds(holes.front().from_s),
                     seconds(holes.front().to_s),
                     more > 0 ? fmt::format(", nor in {} more {}", more, more == 1 ? "gap" : "gaps") : "");
}

}  // namespace

bool misses_control(const flight::Flight& flight, const Figures& f) {
  const double start_s = flight.events.control_start_s.value_or(f.roll.begin_s);
  const double end_s = flight.events.control_end_s.value_or(f.roll.end_s);
  const auto is_under_control = [&](const Hole& hole) {
    return std::min(hole.to_s, end_s) - std::max(hole.from_s, start_s) > tolerance_s;
  };
  return f.begins_under_control || f.roll.is_thin() || start_s < f.roll.begin_s - tolerance_s ||
         (end_s > f.roll.end_s + tolerance_s && !lost_to_reset(flight)) ||
         std::ranges::any_of(unexplained_holes(flight, f), is_under_control);
}

std::string unknown_roll(const flight::Flight& flight, const Figures& f) {
  if (f.roll.end_s <= f.roll.begin_s) {
    return {};  // known once, or never
  }
  std::string text = f.roll.is_thin()
                         ? fmt::format(" The roll is known only every {} s.", text::brief(f.roll.usual_step_s, 2))
                         : of_holes(unexplained_holes(flight, f));
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
  return text;
}

bool ends_under_control(const flight::Flight& flight, const Figures& f) {
  return f.final_phase == core::Phase::controlling &&
         (flight.events.control_end_s
              ? *flight.events.control_end_s > f.roll.end_s + tolerance_s
              : !flight.events.apogee_s || *flight.events.apogee_s > f.roll.end_s + tolerance_s);
}

}  // namespace fantail::report
