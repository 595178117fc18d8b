// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/core.h>

#include "flight/phase_names.hpp"
#include "listen/outputs.hpp"
#include "listen/sentences.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

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

// Of neighbours that are shaded alike nobody sees where one ends: what comes before a launch is not shaded, and control
// has a colour.
std::vector<page::ShadedRange> phases(const Heard& heard) {
  std::vector<page::ShadedRange> ranges;
  const double end_s = heard.trace.time_s.back();
  for (std::size_t i = 0; i < heard.events.size(); ++i) {
    const double from_s = std::max(heard.events[i].time_s, heard.trace.time_s.front());
    const double to_s = std::min(i + 1 < heard.events.size() ? heard.events[i + 1].time_s : end_s, end_s);
    const core::Phase phase = heard.events[i].to;
    if (from_s < to_s && phase != core::Phase::armed) {
      ranges.push_back({from_s - zero_s(heard), to_s - zero_s(heard), flight::display_name(phase),
                        phase == core::Phase::controlling ? Role::second_model : Role::neutral});
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

std::string chart(const Heard& heard, std::string_view heading, std::string_view unit, double height,
                  std::vector<page::Series> series, std::vector<page::Level> levels) {
  std::erase_if(series, [](const page::Series& one) { return one.x.empty(); });
  return page::section(heading,
                       page::figure({.label = fmt::format("{} over time", heading),
                                     .x_label = heard.known_lift_off_s() ? "time after lift-off / s" : "time / s",
                                     .y_label = fmt::format("{} / {}", in_lower_case(heading), unit),
                                     .height = height,
                                     .series = std::move(series),
                                     .shaded_ranges = phases(heard),
                                     .levels = std::move(levels),
                                     .sampled = true,
                                     .least_left = 48.0}));
}

// The half second in which everything is decided.
std::string close_up(const Heard& heard, std::vector<page::Level> levels) {
  if (!heard.known_lift_off_s()) {
    return {};
  }
  constexpr page::Range around_lift_off{-0.5, 1.5};
  return page::figure({.label = "Axial specific force around lift-off",
                       .x_label = "time after lift-off / s",
                       .y_label = "axial specific force / g",
                       .height = flat,
                       .series = {from_log(heard, heard.log.axial, "log", 1.0 / one_g_m_s2)},
                       .shaded_ranges = phases(heard),
                       .levels = std::move(levels),
                       .x_range = around_lift_off,
                       .least_left = 48.0},
                      "The same around lift-off.");
}

std::string charts(const Heard& heard) {
  if (heard.trace.time_s.size() < 2) {
    return {};
  }
  const Trace& trace = heard.trace;
  std::vector<page::Level> threshold = moments(heard);
  threshold.push_back({.value = static_cast<double>(heard.flown.launch_detection.threshold_m_s2) / one_g_m_s2,
                       .label = "threshold",
                       .role = Role::limit});
  return chart(heard, "Axial specific force", "g", flat,
               {from_log(heard, heard.log.axial, "log", 1.0 / one_g_m_s2),
                from_log(heard, heard.log.second_axial, "second", 1.0 / one_g_m_s2)},
               threshold) +
         close_up(heard, threshold) +
         chart(heard, "Speed", "(m/s)", tall,
               {from_log(heard, heard.log.speed, "log", 1.0), from_law(heard, trace.speed_m_s, "law")},
               moments(heard)) +
         chart(heard, "Height", "m", tall,
               {from_log(heard, heard.log_height.above_pad, "log", 1.0), from_law(heard, trace.height_m, "law")},
               moments(heard)) +
         (knows_tilt(heard.log)
              ? chart(heard, "Tilt", "deg", flat, {from_law(heard, trace.tilt_rad, "law", text::degrees(1.0))}, {})
              : "") +
         (heard.log.roll_rate.is_there()
              ? chart(heard, "Roll rate", "(deg/s)", flat,
                      {from_law(heard, trace.roll_rate_rad_s, "law", text::degrees(1.0))}, {})
              : "");
}

std::string phase_table(const Heard& heard) {
  const std::vector<page::Column> columns{{"phase"},
                                          {"because"},
                                          {"log / s", true},
                                          {"after lift-off / s", true},
                                          {"height / m", true},
                                          {"speed / (m/s)", true},
                                          {"tilt / deg", true}};
  std::vector<std::vector<page::Cell>> rows;
  for (const PhaseRow& row : phase_rows(heard)) {
    rows.push_back(
        {{row.phase}, {row.reason}, {row.log_time}, {row.since_lift_off}, {row.height}, {row.speed}, {row.tilt}});
  }
  return page::section("Phases", page::table(columns, rows) +
                                     page::note("Height, speed and tilt are what the law knew at that moment."));
}

std::string comparison_table(const Heard& heard) {
  const std::vector<page::Column> columns{{""}, {"the law"}, {"the log"}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Row& row : comparison(heard)) {
    rows.push_back({{row.what}, {row.law}, {row.log}});
  }
  return page::section(
      "The law beside the log",
      page::table(columns, rows) +
          page::note(lift_off_rule() + " The log's apogee is where a running median of its height over 0.5 s is "
                                       "largest."));
}

std::string_view heading(Finding finding) {
  switch (finding) {
    case Finding::heard: return "Heard";
    case Finding::late: return "Late";
    case Finding::imagined: return "Imagined";
    case Finding::imagined_and_missed: return "Imagined, and the launch missed";
    case Finding::missed: return "Missed";
    case Finding::no_launch: break;
  }
  return "No launch";
}

}  // namespace

std::string as_html(const Heard& heard) {
  page::Page page{.kind = "Fantail: a log, flown through the flight law",
                  .title = std::filesystem::path{heard.log.name}.filename().string()};
  page.subtitle = fmt::format("{}. Plan {}. {} rows, {} samples a second", heard.log.name, heard.plan, heard.log.rows,
                              text::brief(1.0 / heard.log.interval_s, 1));
  page.tone = result::tone(answer(heard));
  page.verdict_heading = std::string{heading(finding(heard))} + (heard.doubts.empty() ? "" : ", in doubt");
  for (const std::string& doubt : heard.doubts) {
    page.verdict += doubt + " ";
  }
  page.verdict += headline(heard);
  page.body_html = phase_table(heard) + comparison_table(heard) + charts(heard) +
                   page::section("How it was flown", page::list(heard.notes));
  return page::html(page);
}

}  // namespace fantail::listen
