// SPDX-License-Identifier: MIT
#include <iterator>

#include <fmt/format.h>

#include "bench/cycle.hpp"
#include "bench/watch.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

using Json = json::Value;
using json::rounded;
using json::text_or_null;

Json scaled(const std::optional<double>& value, double unit) { return value ? Json(rounded(unit * *value)) : Json{}; }

Json course_json(const Course& course, double unit) {
  Json tenths = Json::array();
  for (const auto& tenth : course.tenths) {
    tenths.push_back(scaled(tenth, unit));
  }
  return {{"first", scaled(course.first, unit)},
          {"last", scaled(course.last, unit)},
          {"worst", scaled(course.worst, unit)},
          {"tenths", tenths}};
}

}  // namespace

std::string cycle_json(const Cycle& cycle, const result::Made& made) {
  const double degree = text::degrees(1.0);
  Json canards = Json::array();
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    canards.push_back({{"canard", i + 1},
                       {"lag_s", course_json(lag_course(cycle, i), 1.0)},
                       {"tracking_rms_deg", course_json(tracking_rms_course(cycle, i), degree)},
                       {"tracking_error_deg", course_json(tracking_error_course(cycle, i), degree)}});
  }
  Json left_out = Json::array();
  for (std::size_t i = 0; i < cycle.laps.size(); ++i) {
    if (!cycle.laps[i].measured()) {
      left_out.push_back({{"lap", i + 1}, {"because", cycle.laps[i].doubt}});
    }
  }
  const Heading& heading = cycle.heading;
  Json all = {{"judgement", name(judgement(cycle))},
              {"conclusions", conclusions(cycle)},
              {"vehicle", text_or_null(heading.vehicle)},
              {"plan", text_or_null(heading.plan)},
              {"plan_crc", text_or_null(heading.plan_crc)},
              {"gate", text_or_null(heading.gate)},
              {"date", text_or_null(heading.date)},
              {"avionics", text_or_null(heading.avionics)},
              {"lap_s", rounded(cycle.lap_s)},
              {"planned_laps", cycle.planned_laps},
              {"laps", cycle.laps.size()},
              {"left_out", left_out},
              {"ended_because", text_or_null(cycle.ended_because)},
              {"canards", canards},
              {"battery_v", knows_battery(cycle) ? course_json(battery_course(cycle), 1.0) : Json{}},
              {"notes", heading.notes},
              {"version", heading.version}};
  add_board(all, heading.board, "plan_source");
  result::put_answer(all, answer(judgement(cycle)), fmt::format("{}", fmt::join(conclusions(cycle), " ")), made);
  return all.pretty();
}

std::string cycle_csv(const Cycle& cycle) {
  const bool battery = knows_battery(cycle);
  std::string csv = "lap,time_s,measured";
  for (std::size_t i = 1; i <= core::canard_count; ++i) {
    csv += fmt::format(",lag_{0}_s,tracking_rms_{0}_deg,tracking_error_{0}_deg,passed_{0}", i);
  }
  csv += battery ? ",battery_v\n" : "\n";
  const auto add = [&csv](const std::optional<double>& value, double unit, int decimals) {
    csv += ',';
    if (value) {
      fmt::format_to(std::back_inserter(csv), "{:.{}f}", unit * *value, decimals);
    }
  };
  const double degree = text::degrees(1.0);
  for (std::size_t i = 0; i < cycle.laps.size(); ++i) {
    const Lap& lap = cycle.laps[i];
    fmt::format_to(std::back_inserter(csv), "{},{:.3f},{:d}", i + 1, lap.begin_s, lap.measured());
    for (const CanardLap& canard : lap.canards) {
      if (lap.measured()) {
        add(canard.lag_s, 1.0, 4);
        add(canard.tracking_rms_rad, degree, 3);
        add(canard.tracking_error_rad, degree, 3);
        csv += canard.passed ? ",1" : ",0";
      } else {
        csv += ",,,,";
      }
    }
    if (battery) {
      add(lap.battery_v, 1.0, 3);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace fantail::bench
