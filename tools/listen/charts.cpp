// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>

#include <fmt/core.h>

#include "flight/phase_names.hpp"
#include "listen/answer.hpp"
#include "page/chart.hpp"
#include "report/phase_colors.hpp"
#include "text/degrees.hpp"

namespace fantail::listen {
namespace {

using page::Role;

constexpr double tall = 280.0;
constexpr double flat = 190.0;

// Time from here on in the charts: after lift-off where it is known.
double zero_s(const Heard& heard) { return heard.known_lift_off_s().value_or(0.0); }

std::vector<double> shifted(std::vector<double> time_s, double by_s) {
  std::ranges::for_each(time_s, [&](double& t) { t -= by_s; });
  return time_s;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  std::ranges::for_each(values, [&](double& v) { v *= factor; });
  return values;
}

// The part of a log's signal that the charts show.
page::Series from_log(const Heard& heard, const Signal& signal, const char* name, double factor) {
  page::Series series{.name = name, .role = Role::measured};
  for (std::size_t i = 0; i < signal.time_s.size() && !heard.trace.time_s.empty(); ++i) {
    if (signal.time_s[i] >= heard.trace.time_s.front() && signal.time_s[i] <= heard.trace.time_s.back()) {
      series.x.push_back(signal.time_s[i] - zero_s(heard));
      series.y.push_back(signal.value[i] * factor);
    }
  }
  return series;
}

page::Series from_law(const Heard& heard, const std::vector<double>& values, const char* name, double factor = 1.0) {
  return {
      .name = name, .role = Role::model, .x = shifted(heard.trace.time_s, zero_s(heard)), .y = scaled(values, factor)};
}

// What comes before a launch is not shaded.
std::vector<page::ShadedRange> phases(const Heard& heard) {
  std::vector<page::ShadedRange> ranges;
  const double end_s = heard.trace.time_s.back();
  for (std::size_t i = 0; i < heard.events.size(); ++i) {
    const double from_s = std::max(heard.events[i].time_s, heard.trace.time_s.front());
    const double to_s = std::min(i + 1 < heard.events.size() ? heard.events[i + 1].time_s : end_s, end_s);
    const core::Phase phase = heard.events[i].to;
    if (from_s < to_s && phase != core::Phase::armed) {
      ranges.push_back(
          {from_s - zero_s(heard), to_s - zero_s(heard), flight::display_name(phase), report::color_of(phase)});
    }
  }
  return ranges;
}

std::vector<page::Level> moments(const Heard& heard) {
  std::vector<page::Level> levels;
  const auto mark = [&](const std::optional<double>& time_s, const char* label) {
    if (time_s && !heard.trace.time_s.empty() && *time_s <= heard.trace.time_s.back()) {
      levels.push_back({.value = *time_s - zero_s(heard), .label = label, .upright = true});
    }
  };
  mark(heard.known_lift_off_s(), "lift-off");
  mark(heard.apogee_s, "apogee, law");
  mark(heard.log_height.apogee_s, "apogee, log");
  return levels;
}

std::string in_lower_case(std::string_view heading) {
  std::string label{heading};
  label.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(label.front())));
  return label;
}

result::Section chart(const Heard& heard, const std::string& heading, std::string_view unit, double height,
                      std::vector<page::Series> series, std::vector<page::Level> levels) {
  std::erase_if(series, [](const page::Series& one) { return one.x.empty(); });
  const page::Chart chart{.label = fmt::format("{} over time", heading),
                          .x_label = heard.known_lift_off_s() ? "time after lift-off / s" : "time / s",
                          .y_label = fmt::format("{} / {}", in_lower_case(heading), unit),
                          .height = height,
                          .series = std::move(series),
                          .shaded_ranges = phases(heard),
                          .levels = std::move(levels),
                          .sampled = true};
  return {.heading = heading, .blocks = {result::Picture{chart}}, .readers = result::Readers::files};
}

// The half second in which everything is decided.
result::Picture close_up(const Heard& heard, std::vector<page::Level> levels) {
  constexpr page::Range around_lift_off{-0.5, 1.5};
  return {page::Chart{.label = "Axial specific force around lift-off",
                      .x_label = "time after lift-off / s",
                      .y_label = "axial specific force / g",
                      .height = flat,
                      .series = {from_log(heard, heard.log.axial, "log", 1.0 / one_g_m_s2)},
                      .shaded_ranges = phases(heard),
                      .levels = std::move(levels),
                      .x_range = around_lift_off},
          "Axial specific force around lift-off."};
}

}  // namespace

std::vector<result::Section> charts(const Heard& heard) {
  if (heard.trace.time_s.size() < 2) {
    return {};
  }
  const Trace& trace = heard.trace;
  std::vector<page::Level> threshold = moments(heard);
  threshold.push_back({.value = static_cast<double>(heard.flown.launch_detection.threshold_m_s2) / one_g_m_s2,
                       .label = "threshold",
                       .role = Role::limit});
  std::vector<result::Section> all{chart(heard, "Axial specific force", "g", flat,
                                         {from_log(heard, heard.log.axial, "log", 1.0 / one_g_m_s2),
                                          from_log(heard, heard.log.second_axial, "second", 1.0 / one_g_m_s2)},
                                         threshold)};
  if (heard.known_lift_off_s()) {
    all.back().blocks.emplace_back(close_up(heard, threshold));
  }
  all.push_back(chart(heard, "Speed", "(m/s)", tall,
                      {from_log(heard, heard.log.speed, "log", 1.0), from_law(heard, trace.speed_m_s, "law")},
                      moments(heard)));
  all.push_back(chart(heard, "Height", "m", tall,
                      {from_log(heard, heard.log_height.above_pad, "log", 1.0), from_law(heard, trace.height_m, "law")},
                      moments(heard)));
  if (knows_tilt(heard.log)) {
    all.push_back(chart(heard, "Tilt", "deg", flat, {from_law(heard, trace.tilt_rad, "law", text::degrees(1.0))}, {}));
  }
  if (heard.log.roll_rate.is_there()) {
    all.push_back(chart(heard, "Roll rate", "(deg/s)", flat,
                        {from_law(heard, trace.roll_rate_rad_s, "law", text::degrees(1.0))}, {}));
  }
  return all;
}

}  // namespace fantail::listen
