// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "flight/gate.hpp"
#include "flight/phase_names.hpp"
#include "report/fields.hpp"
#include "report/hold.hpp"
#include "report/sections.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

// What a person reads of a flight.
namespace fantail::report {
namespace {

using result::Figure;
using text::degrees;
using text::fixed;

/// So that the events of control are farther apart than its rows.
bool rows_are_sparse(const flight::Flight& flight, const Figures& f) {
  const flight::Events& e = flight.events;
  return f.control_time_s && e.control_start_s && e.control_end_s &&
         *e.control_end_s - *e.control_start_s - *f.control_time_s > 0.005;
}

/// Those that a person reads, with what belongs to each.
std::vector<Figure> read_figures(const flight::Flight& flight, const Figures& f, bool roll_is_judged) {
  result::Figures all = result::figures("", f, fields::figures);
  all["max_speed"].label = top_speed_name(flight);
  if (f.opening.closings > 0) {
    all["control_time"].remark = "without the time in which the gate had closed";
  } else if (rows_are_sparse(flight, f)) {
    all["control_time"].remark = "from its first row to its last";
  }
  if (flight.tunnel) {
    all["largest_disturbance"].label = "fin offset and swirl together";
  }
  all["rest_error"].remark =
      fmt::format("farthest mean of any step; limit {} deg", text::brief(degrees(flight.rest_limit_rad), 1));
  all["roll_after_end"].remark = f.ended_before_apogee_s ? "until apogee" : "until the trajectory ends";
  if (f.authority_rad) {
    all["authority_margin"].remark = fmt::format("of {} deg", text::brief(degrees(*f.authority_rad), 1));
  }
  std::erase_if(all.all, [&](const Figure& one) {
    const bool is_of_hold = one.key == "largest_hold_error" || one.key == "mean_hold_error" || one.key == "rest_error";
    const bool is_of_control = one.key == "control_time" || one.key == "saturated_fraction" ||
                               one.key == "roll_turns" || one.key == "roll_turns_without_control" ||
                               one.key == "mean_reference_error" || one.key == "authority_margin";
    return (is_of_control && nothing_controls_roll(flight)) || (is_of_hold && !roll_is_judged) ||
           (one.key == "roll_after_end" && !ended_early(flight, f)) ||
           (one.key == "saturated_fraction" && !(f.control_time_s.value_or(0.0) > 0.0)) || one.key == "judged_time" ||
           one.key == "authority" || one.key == "ended_before_apogee" || one.key == "at_limit_since";
  });
  return all.all;
}

void add(std::vector<Figure>& to, const result::Figures& more) {
  to.insert(to.end(), more.all.begin(), more.all.end());
}

/// Of a plan with a gate or with capture.
void add_beginning(std::vector<Figure>& to, const flight::Flight& flight, const Figures& f) {
  if (!flight::shows_gate(flight)) {
    return;
  }
  result::Figures opening = result::figures("", f.opening, fields::opening);
  std::erase_if(opening.all, [&](const Figure& one) { return one.key == "closings" && f.opening.closings == 0; });
  opening["speed"].remark = speed_kind(flight);
  add(to, opening);
  result::Figures capture = result::figures("", f.capture, fields::capture);
  if (!flight.seed) {
    capture["after"].remark = "within 10 deg of where it came to rest";
  }
  if (f.capture.watched_s && !f.capture.after_s) {
    capture["after"].value = fmt::format("not in the first {} s", fixed(*f.capture.watched_s, 2));
    capture["after"].unit = result::units::none;
  }
  std::erase_if(capture.all, [](const Figure& one) { return one.key == "watched"; });
  add(to, capture);
  result::Figures neutral = result::figures("", f.neutral, fields::neutral);
  std::erase_if(neutral.all, [&](const Figure& one) {
    return one.key == "from" || one.key == "until" || (one.key == "unread" && f.neutral.unread_s == 0.0);
  });
  add(to, neutral);
}

result::Figures shown_figures(const flight::Flight& flight, const Figures& f, bool roll_is_judged) {
  std::vector<Figure> all = read_figures(flight, f, roll_is_judged);
  add_beginning(all, flight, f);
  if (f.side_deflection) {
    result::Figures side = result::figures("", *f.side_deflection, fields::side_deflection);
    side["largest"].remark = "vector sum of the four canard angles";
    side["largest_moment"].remark = "about the centre of gravity, by that sum";
    add(all, side);
  }
  if (f.camera_roll) {
    add(all, result::figures("", *f.camera_roll, fields::camera_roll));
  }
  if (const auto top = apogee_of(flight)) {
    const bool is_plane = flight.path_frame == flight::PathFrame::plane;
    all.push_back({{.label = "drift at apogee", .unit = result::units::m, .decimals = 1},
                   flight::distance_m(*top),
                   is_plane ? "over ground" : "over ground, towards " + compass(*top)});
    all.push_back(result::figures("", *top, fields::apogee)["tilt"]);
  }
  if (const auto landing = landing_of(flight); landing && landing->under_parachute) {
    all.push_back(
        {{.label = "landing, from the guide", .unit = result::units::m, .decimals = 0},
         flight::distance_m(landing->at),
         fmt::format("towards {}, at {} s, under the parachute", compass(landing->at), fixed(landing->at.time_s, 1))});
  }
  if (flight.gyro_bias_rad_s) {
    all.push_back({{.label = "gyro zero", .unit = result::units::deg_s, .decimals = 2},
                   static_cast<double>(flight.gyro_bias_rad_s->x),
                   "about the long axis; subtracted"});
  }
  return {.all = std::move(all)};
}

/// With words for a gain margin: a loop may swing with less gain, too.
result::Table margins(const flight::Flight& flight) {
  const std::vector<flight::LoopMargin> all = different_margins(flight);
  result::Table table = result::table({}, all, fields::margins);
  const std::size_t gain = table.column("gain_margin");
  table.columns[gain].unit = result::units::none;
  for (std::size_t i = 0; i < all.size(); ++i) {
    table.rows[i][gain] = gain_margin_text(all[i]);
  }
  return table;
}

/// The canards obey the law and reach far enough, and the loop is stable at every speed.
bool can_settle(const flight::Flight& flight, const Figures& f) {
  return flight.why_uncontrollable.empty() && f.authority_margin_rad.value_or(0.0) >= 0.0 &&
         std::ranges::none_of(flight.loop_margins,
                              [](const flight::LoopMargin& margin) { return margin.phase_margin_rad < 0.0; });
}

}  // namespace

std::string compass(const flight::PathPoint& point) {
  constexpr std::array names{"north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west"};
  constexpr double eighth_rad = 0.25 * std::numbers::pi;
  const auto eighths = std::lround(std::atan2(point.east_m, point.north_m) / eighth_rad);
  return names[static_cast<std::size_t>((eighths + 8) % 8)];
}

std::vector<std::string> beside_the_verdict(const flight::Flight& flight, const Figures& f, const Verdict& verdict) {
  std::vector<std::string> all;
  if (verdict.roll_is_judged && f.largest_hold_error_rad && can_settle(flight, f)) {
    all.push_back(fmt::format("It settles at {}{}.", settle_point_name(flight),
                              flight::rejects_offset(flight.plan) ? ", its reference"
                              : flight.tunnel ? ": R is its reference, u_d the fin offset with the swirl"
                                              : ": R is its reference, u_d the fin offset"));
  }
  add_gate_sentences(all, flight, f);
  if (std::string barometer = barometer_sentences(flight); !barometer.empty()) {
    all.push_back(std::move(barometer));
  }
  if (f.roll_turns && f.roll_turns_without_control && !nothing_controls_roll(flight)) {
    all.push_back(fmt::format("Under control it made {} turns; with its canards at trim it would have made {}.",
                              fixed(*f.roll_turns, 2), fixed(*f.roll_turns_without_control, 2)));
  }
  if (const auto landing = landing_of(flight); landing && !landing->under_parachute) {
    all.emplace_back("It falls without a parachute, which is outside the model: no landing point is given.");
  }
  if (f.camera_roll && std::abs(f.camera_roll->largest_rad) >= text::radians(1.0)) {
    all.push_back(
        fmt::format("The rocket coned: the roll that a camera sees differed by up to {} deg from the roll angle, which "
                    "is the integral of the gyro's rate.",
                    fixed(std::abs(degrees(f.camera_roll->largest_rad)), 1)));
  }
  if (!flight.changes.empty()) {
    all.push_back(fmt::format("Changed on the command line: {}.", fmt::join(flight.changes, ", ")));
  }
  if (std::string imposed = flight::imposed_roll_sentence(flight); !imposed.empty()) {
    all.push_back(std::move(imposed));
  }
  return all;
}

result::Section figures_section(const flight::Flight& flight, const Figures& figures, const Verdict& verdict) {
  result::Section section{"Figures", {shown_figures(flight, figures, verdict.roll_is_judged), margins(flight)}};
  if (verdict.roll_is_judged && figures.largest_hold_error_rad) {
    section.blocks.emplace_back(settle_point_text(flight, can_settle(flight, figures)));
  }
  return section;
}

result::Section notes_section(const flight::Flight& flight) {
  if (!flight.seed) {
    return {"About the log", {result::Sentences{.all = flight.notes}}};
  }
  if (flight.notes.empty()) {
    return {"Assumptions and notes",
            {std::string{flight.imposed_roll ? "The scenario has no faults and no further assumptions."
                                             : "The scenario has no imposed roll, no faults and no further "
                                               "assumptions."}}};
  }
  return {"Assumptions and notes", {result::Sentences{.all = flight.notes}}};
}

}  // namespace fantail::report
