// SPDX-License-Identifier: MIT

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "flight/gate.hpp"
#include "report/chart_drawer.hpp"
#include "report/hold.hpp"
#include "report/phase_colors.hpp"
#include "report/sections.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

using page::Chart;
using page::Mark;
using page::Role;

// More labelled steps than this would hide each other.
constexpr std::size_t most_step_labels = 3;

std::vector<page::Level> reference_steps(const flight::Flight& flight) {
  std::vector<page::Level> steps;
  const flight::Row* before = nullptr;
  double turns = 0.0;  // that capture put on the plan's angles, anew where the gate reopens
  std::optional<double> start_s;
  for (const flight::Row& row : flight.rows) {
    before = row.phase == core::Phase::dormant ? nullptr : before;
    if (row.phase != core::Phase::controlling || !std::isfinite(row.reference_rad)) {
      continue;
    }
    start_s = start_s.value_or(row.time_s);
    if (before == nullptr) {
      turns = flight::chosen_turn(flight, row, row.time_s - *start_s).value_or(0.0);
    } else if (row.reference_rad != before->reference_rad) {
      const double planned_deg = text::degrees(row.reference_rad) - 360.0 * turns;
      const std::string sign = planned_deg > 0.0 ? "+" : "";
      const std::string angle = text::with_minus(text::brief(planned_deg, 1));
      steps.push_back({.value = row.time_s, .label = fmt::format("step to {}{}\u00b0", sign, angle), .upright = true});
    }
    before = &row;
  }
  if (steps.size() > most_step_labels) {
    for (std::size_t i = 1; i < steps.size(); ++i) {
      steps[i].label.clear();
    }
    steps.front().label = "steps";
  }
  return steps;
}

// In order of time.
std::vector<page::Level> event_marks(const flight::Flight& flight) {
  std::vector<page::Level> marks = reference_steps(flight);  // by time, and kept so
  const flight::Events& e = flight.events;
  const auto mark = [&marks](const std::optional<double>& time_s, const char* label) {
    if (time_s) {
      marks.insert(std::ranges::upper_bound(marks, *time_s, {}, &page::Level::value),
                   {.value = *time_s, .label = label, .upright = true});
    }
  };
  mark(e.liftoff_s, "lift-off");
  mark(e.detected_s, "detected");
  mark(e.guide_clear_s, "off the guide");
  mark(e.dormant_s, "dormant");
  mark(e.control_start_s, e.dormant_s ? "gate opens" : "control");
  mark(e.burnout_s, "burn-out");
  mark(e.apogee_s, "apogee");
  mark(e.parachute_s, "parachute");
  if (const auto jolt = jolt_after_apogee(flight); jolt && !e.parachute_s) {
    mark(jolt->time_s, "jolt");
  }
  if (!e.apogee_s || (e.control_end_s && *e.control_end_s < *e.apogee_s - 0.2)) {
    mark(e.control_end_s, ends_a_wait(flight) ? "control never began" : "control ends");
  }
  return marks;
}

bool rests_at_reference(const flight::Flight& flight) {
  return flight.known.plan && flight::rejects_offset(flight.plan);
}

Chart disturbance(const flight::Flight& flight, const ChartDrawer& drawer) {
  const page::Series truth = drawer.line("u_d", Role::target, column("true_disturbance_deg"));
  if (!rests_at_reference(flight)) {
    return drawer.chart("True disturbance (equivalent fin offset u_d)", "deg", page::full_page, flat_chart, {truth});
  }
  return drawer.chart(
      "Disturbance (equivalent fin offset u_d), and the law's estimate of it", "deg", page::full_page, flat_chart,
      {truth, drawer.line("estimate", Role::measured, drawer.in_control(column("offset_estimate_deg")))});
}

/// "reference R, on turn -1": what the plan's angles are counted from.
std::string reference_name(const flight::Flight& flight) {
  const auto first = std::ranges::find(flight.rows, core::Phase::controlling, &flight::Row::phase);
  const auto turn = first == flight.rows.end() ? std::nullopt : flight::chosen_turn(flight, *first);
  return turn.value_or(0.0) == 0.0
             ? "reference R"
             : fmt::format("reference R, from turn {} ({} deg)", text::with_minus(text::fixed(*turn, 0)),
                           text::with_minus(text::fixed(360.0 * *turn, 0)));
}

Chart roll_angle(const flight::Flight& flight, const ChartDrawer& drawer) {
  const RowValue settle = [&flight](const flight::Row& row) {
    const bool in_still_air = flight.tunnel && row.truth && std::abs(row.truth->speed_m_s) < Figures::still_air_m_s;
    if (in_still_air || !flight.why_uncontrollable.empty()) {
      return unknown_value;
    }
    return text::in_degrees(flight::settle_point_rad(row, flight)).value_or(unknown_value);
  };
  Chart chart = drawer.chart(
      "Roll angle", "deg", page::full_page, tall_chart,
      {drawer.line(reference_name(flight), Role::reference, drawer.in_control(column("reference_deg")), Mark::step),
       drawer.line("settles at " + settle_point_name(flight), Role::second_model, drawer.in_control(settle),
                   Mark::step),
       drawer.line("true", Role::target, column("true_roll_angle_deg")),
       drawer.line("estimate", Role::measured, column("roll_angle_deg"))});
  chart.shaded_ranges = phase_ranges(flight);
  chart.levels = event_marks(flight);
  return chart;
}

/// To either side, as far as the rates that were flown are in sight: a resonance far away would flatten them.
std::vector<page::Area> resonance(const flight::Flight& flight, const ChartDrawer& drawer, const page::Series& rate) {
  if (!flight.resonance_1_m) {
    return {};
  }
  double sight_deg_s = 0.0;
  for (std::size_t i = 0; i < rate.x.size() && rate.x[i] <= plot_window(flight).end_s; ++i) {
    sight_deg_s = std::fmax(sight_deg_s, 1.3 * std::abs(rate.y[i]));
  }
  const auto edge = [&](double sign, double frequency_1_m) -> RowValue {
    return [=, low_1_m = flight.resonance_1_m->front()](const flight::Row& row) {
      const double speed_m_s = row.truth ? row.truth->speed_m_s : row.speed_m_s;
      const bool is_in_sight = text::degrees(low_1_m * speed_m_s) < sight_deg_s && speed_m_s > Figures::still_air_m_s;
      return is_in_sight ? sign * std::min(text::degrees(frequency_1_m * speed_m_s), sight_deg_s) : unknown_value;
    };
  };
  std::vector<page::Area> areas;
  for (const double sign : {1.0, -1.0}) {
    const std::array edges{edge(sign, flight.resonance_1_m->front()), edge(sign, flight.resonance_1_m->back())};
    areas.push_back(drawer.band(sign > 0.0 ? "roll resonance" : "", Role::limit, edges));
  }
  // In slow air alone, at lift-off and near apogee, it would be a scrap at both ends.
  const auto seen = std::ranges::count_if(areas.front().low, [](double low) { return std::isfinite(low); });
  constexpr double least_share = 0.2;
  if (static_cast<double>(seen) < least_share * static_cast<double>(areas.front().low.size())) {
    areas.clear();
  }
  return areas;
}

Chart roll_rate(const flight::Flight& flight, const ChartDrawer& drawer) {
  const page::Series truth = drawer.line("true", Role::target, column("true_roll_rate_deg_s"));
  const page::Series estimate = drawer.line("estimate", Role::measured, column("roll_rate_deg_s"));
  Chart chart = drawer.chart("Roll rate", "deg/s", page::full_page, flat_chart, {truth, estimate});
  chart.areas = resonance(flight, drawer, knows_true_roll(flight.rows) ? truth : estimate);
  return chart;
}

std::vector<Chart> all_charts(const flight::Flight& flight, const ChartDrawer& drawer) {
  std::vector<Chart> all{roll_angle(flight, drawer), roll_rate(flight, drawer), canards_together(flight, drawer),
                         drawer.with_limits(disturbance(flight, drawer))};
  const page::Series true_speed = drawer.line(flight.path.empty() ? "true" : "true, through the air along the axis",
                                              Role::target, column("true_speed_m_s"));
  if (flight.tunnel) {  // on a string nothing accelerates, so there is no estimate
    all.push_back(drawer.chart("Air speed", "m/s", page::full_page, small_chart, {true_speed}));
  } else {
    all.push_back(drawer.chart("Height", "m", page::half_page, small_chart,
                               {drawer.line("true", Role::target, column("true_height_m")),
                                drawer.line("estimate", Role::measured, column("height_m"))}));
    all.push_back(drawer.chart(
        "Speed", "m/s", page::half_page, small_chart,
        {true_speed, drawer.line(flight.path.empty() ? "estimate" : "estimate, over ground along the guide",
                                 Role::measured, column("speed_m_s"))}));
  }
  return all;
}

std::vector<page::LiveCharts::View> views(const flight::Flight& flight) {
  const PlotWindow window = plot_window(flight);
  const flight::Events& e = flight.events;
  std::vector<page::LiveCharts::View> all{{flight.tunnel ? "Run" : "Flight", window.begin_s, window.end_s}};
  if (!flight.tunnel && e.liftoff_s && e.control_start_s) {
    all.push_back({"Launch", *e.liftoff_s - 0.2, *e.control_start_s + 1.5});
  }
  if (e.dormant_s && e.control_start_s) {
    all.push_back({"Capture", *e.control_start_s - 0.5, *e.control_start_s + 2.0});
  }
  if (!flight.tunnel && e.control_start_s && e.control_end_s) {
    all.push_back({"Control", *e.control_start_s - 0.1, *e.control_end_s + 0.1});
  }
  std::erase_if(all, [](const auto& view) { return view.end_s <= view.begin_s; });  // of events in no order
  if (flight.rows.back().time_s > window.end_s) {
    all.push_back({flight.tunnel ? "All" : "With descent", window.begin_s, flight.rows.back().time_s});
  }
  return all;
}

}  // namespace

page::LiveCharts charts(const flight::Flight& flight) {
  if (flight.rows.empty()) {
    return {};
  }
  const ChartDrawer drawer{flight};
  return {.charts = all_charts(flight, drawer),
          .more = canards_alone(drawer),
          .more_label = "Each canard alone",
          .scene = roll_scene(flight, plot_window(flight).begin_s),
          .views = views(flight)};
}

}  // namespace fantail::report
