// SPDX-License-Identifier: MIT
#include "report/plot_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "json/value.hpp"
#include "report/decimate.hpp"
#include "report/numbers.hpp"
#include "report/timeline.hpp"

namespace fantail::report {
namespace {

using Json = json::Value;
using Value = std::function<double(const Row&)>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// `style` names a colour and a stroke in page.js.
struct Series {
  std::string name;
  std::string_view style;
  Value value;
};

struct Plot {
  std::string_view id;
  std::string title;
  std::string_view unit;
  std::size_t buckets;
  bool shows_limits;
  std::vector<Series> series;
};

double degrees_or_gap(const std::optional<double>& radians) { return radians ? degrees(*radians) : unknown; }

Value truth(double Truth::* member) {
  return [member](const Row& row) { return row.truth ? (*row.truth).*member : unknown; };
}
Value truth_degrees(double Truth::* member) {
  return [member](const Row& row) { return row.truth ? degrees((*row.truth).*member) : unknown; };
}
Value own(double Row::* member) {
  return [member](const Row& row) { return row.*member; };
}
Value own_degrees(double Row::* member) {
  return [member](const Row& row) { return degrees(row.*member); };
}
// References and commands mean something only while somebody follows them.
Value in_control(const Flight& flight, const Value& value) {
  return [value, always = !flight.known.phase](const Row& row) {
    return always || row.phase == core::Phase::controlling ? value(row) : unknown;
  };
}

Plot canard_plot(std::size_t i) {
  static constexpr std::array<std::string_view, core::canard_count> ids{"canard-1", "canard-2", "canard-3", "canard-4"};
  return {ids[i],
          "Canard " + std::to_string(i + 1),
          "deg",
          800,
          true,
          {{"command", "command", [i](const Row& row) { return degrees_or_gap(row.commands_rad[i]); }},
           {"encoder", "measured", [i](const Row& row) { return degrees_or_gap(row.encoders_rad[i]); }}}};
}

std::vector<Plot> plots(const Flight& flight) {
  const Value settle = [&flight](const Row& row) {
    const std::optional<double> point = settle_point_rad(row, flight);
    return point ? degrees(*point) : unknown;
  };
  const bool excites = flight.known.plan && flight.plan.excitation.form != core::ExcitationForm::none;
  const Value excitation = [excites](const Row& row) { return excites ? degrees(row.excitation_rad) : unknown; };
  std::vector<Plot> all{{"roll-angle",
                         "Roll angle",
                         "deg",
                         1500,
                         false,
                         {{"reference R", "reference", in_control(flight, own_degrees(&Row::reference_rad))},
                          {"settles at R + u_d/kp", "settle", in_control(flight, settle)},
                          {"true", "truth", truth_degrees(&Truth::roll_angle_rad)},
                          {"estimate", "estimate", own_degrees(&Row::roll_angle_rad)}}},
                        {"roll-rate",
                         "Roll rate",
                         "deg/s",
                         1500,
                         false,
                         {{"true", "truth", truth_degrees(&Truth::roll_rate_rad_s)},
                          {"estimate", "estimate", own_degrees(&Row::roll_rate_rad_s)}}},
                        {"command",
                         "Command and canards",
                         "deg",
                         1500,
                         true,
                         {{"excitation", "excitation", in_control(flight, excitation)},
                          {"command", "command", own_degrees(&Row::command_rad)},
                          {"encoder mean", "measured", [](const Row& row) { return degrees_or_gap(row.canard_rad); }}}},
                        {"disturbance",
                         "True disturbance (equivalent fin offset u_d)",
                         "deg",
                         800,
                         true,
                         {{"u_d", "truth", truth_degrees(&Truth::disturbance_rad)}}}};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    all.push_back(canard_plot(i));
  }
  if (!flight.tunnel) {
    all.push_back({"height",
                   "Height",
                   "m",
                   600,
                   false,
                   {{"true", "truth", truth(&Truth::height_m)}, {"estimate", "estimate", own(&Row::height_m)}}});
  }
  all.push_back({"speed",
                 flight.tunnel ? "Air speed" : "Speed",
                 "m/s",
                 600,
                 false,
                 {{"true", "truth", truth(&Truth::speed_m_s)}, {"estimate", "estimate", own(&Row::speed_m_s)}}});
  if (flight.tunnel) {
    all.back().series.pop_back();  // on a string nothing accelerates, so there is no estimate
  }
  return all;
}

// To a hundredth; integers are shorter than "12.30", so the page divides by 100.
Json hundredths(double value) {
  if (!std::isfinite(value) || std::abs(value) > 1e12) {
    return {};
  }
  return static_cast<std::int64_t>(std::llround(value * 100.0));
}

struct Point {
  double time_s;
  std::optional<std::size_t> row;  // empty: nothing is known there, and no line goes across
};

std::vector<Point> points_with_gaps(const std::vector<std::size_t>& kept, std::span<const Row> rows) {
  const std::vector<std::size_t> missing_after = gaps(rows);
  std::vector<Point> points;
  points.reserve(kept.size());
  auto gap = missing_after.begin();
  for (const std::size_t i : kept) {
    for (; gap != missing_after.end() && *gap < i; ++gap) {
      if (!points.empty()) {
        points.push_back({0.5 * (rows[*gap].time_s + rows[*gap + 1].time_s), {}});
      }
    }
    points.push_back({rows[i].time_s, i});
  }
  return points;
}

Json draw(const Plot& plot, std::span<const Row> rows) {
  std::vector<std::vector<double>> values;
  Json series = Json::array();
  for (const Series& one : plot.series) {
    std::vector<double> column(rows.size());
    std::ranges::transform(rows, column.begin(), one.value);
    if (std::ranges::none_of(column, [](double v) { return std::isfinite(v); })) {
      continue;
    }
    values.push_back(std::move(column));
    series.push_back({{"name", one.name}, {"style", one.style}});
  }
  if (values.empty()) {
    return {};
  }
  const std::vector<Point> points = points_with_gaps(keep_extremes(values, plot.buckets), rows);
  Json times = Json::array();
  for (const Point& point : points) {
    times.push_back(static_cast<std::int64_t>(std::llround(point.time_s * 1000.0)));
  }
  for (std::size_t s = 0; s < values.size(); ++s) {
    Json column = Json::array();
    for (const Point& point : points) {
      column.push_back(point.row ? hundredths(values[s][*point.row]) : Json{});
    }
    series[s]["hundredths"] = std::move(column);
  }
  return {{"id", plot.id},
          {"title", plot.title},
          {"unit", plot.unit},
          {"limits", plot.shows_limits},
          {"milliseconds", std::move(times)},
          {"series", std::move(series)}};
}

Json limits(const core::FlightPlan& plan) {
  core::Angle stop = plan.canards.each.front().mechanical_stop;
  for (const core::CanardPlan& canard : plan.canards.each) {
    stop = std::min(stop, canard.mechanical_stop);
  }
  const auto text_degrees = [](core::Angle angle) { return json::rounded(static_cast<double>(angle.degrees()), 3); };
  return {{"plan", text_degrees(plan.controller.canard_limit)},
          {"hard", text_degrees(core::hard_canard_limit)},
          {"stop", text_degrees(stop)}};
}

// Stretches worth a button of their own; the first is shown at first.
Json views(const Flight& flight, const Window& window) {
  Json all = Json::array();
  const auto add = [&all](const char* label, double begin_s, double end_s) {
    all.push_back({{"label", label}, {"begin", begin_s}, {"end", end_s}});
  };
  const Events& e = flight.events;
  add(flight.tunnel ? "Run" : "Flight", window.begin_s, window.end_s);
  if (!flight.tunnel && e.liftoff_s && e.control_start_s) {
    add("Launch", *e.liftoff_s - 0.2, *e.control_start_s + 1.5);
  }
  if (!flight.tunnel && e.control_start_s && e.control_end_s) {
    add("Control", *e.control_start_s - 0.1, *e.control_end_s + 0.1);
  }
  if (!flight.rows.empty() && flight.rows.back().time_s > window.end_s) {
    add(flight.tunnel ? "All" : "With descent", window.begin_s, flight.rows.back().time_s);
  }
  return all;
}

}  // namespace

std::string plot_data(const Flight& flight) {
  const Window window = plot_window(flight);
  const std::span<const Row> rows = rows_between(flight, window.begin_s, std::numeric_limits<double>::infinity());

  Json phases = Json::array();
  for (const PhaseBand& band : flight.known.phase ? phase_bands(flight) : std::vector<PhaseBand>{}) {
    phases.push_back({{"phase", core::name(band.phase)}, {"begin", band.begin_s}, {"end", band.end_s}});
  }
  Json events = Json::array();
  for (const EventMark& mark : event_marks(flight)) {
    events.push_back({{"time", mark.time_s}, {"label", mark.label}});
  }
  Json drawn = Json::array();
  for (const Plot& plot : plots(flight)) {
    if (Json one = draw(plot, rows); !one.is_null()) {
      drawn.push_back(std::move(one));
    }
  }
  const Json data = {{"views", views(flight, window)},
                     {"limits", flight.known.plan ? limits(flight.plan) : Json{}},
                     {"phases", phases},
                     {"events", events},
                     {"plots", drawn}};
  return data.dump();
}

}  // namespace fantail::report
