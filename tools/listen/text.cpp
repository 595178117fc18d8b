// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "flight/phase_names.hpp"
#include "listen/outputs.hpp"
#include "listen/sentences.hpp"
#include "text/degrees.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

constexpr const char* unknown = "-";

std::string seconds(const std::optional<double>& time_s) { return time_s ? text::fixed(*time_s, 3) : unknown; }

// "12.34 s after lift-off", or by the log's clock where that is not known.
std::string moment(const Heard& heard, double time_s) {
  const auto since = heard.since_lift_off_s(time_s);
  return since ? fmt::format("{} s after lift-off", text::fixed(*since, 2))
               : fmt::format("{:.2f} s of the log's clock", time_s);
}

std::string at_least(const Heard& heard) { return heard.is_lower_bound ? "at least " : ""; }

}  // namespace

std::vector<PhaseRow> phase_rows(const Heard& heard) {
  std::vector<PhaseRow> rows;
  for (const Event& event : heard.events) {
    rows.push_back({.phase = flight::display_name(event.to),
                    .reason = std::string{flight::display_name(event.reason)},
                    .log_time = text::fixed(event.time_s, 3),
                    .since_lift_off = seconds(heard.since_lift_off_s(event.time_s)),
                    .height = text::fixed(event.height_m, 1),
                    .speed = text::fixed(event.speed_m_s, 1),
                    .tilt = text::fixed(text::degrees(event.tilt_rad), 1)});
  }
  return rows;
}

std::vector<Row> comparison(const Heard& heard) {
  const LogHeight& height = heard.log_height;
  std::vector<Row> rows;
  const auto& gap = heard.lift_off_gap;
  rows.push_back({"lift-off, log's clock / s", unknown,
                  gap ? fmt::format("{:.3f} to {:.3f}, a gap", gap->from_s, gap->to_s) : seconds(heard.lift_off_s)});
  rows.push_back({"detected after lift-off / s", seconds(heard.since_lift_off_s(heard.detected_s)), unknown});
  rows.push_back({"detected before lift-off", std::to_string(heard.false_detections_s.size()), unknown});
  rows.push_back(
      {"hardest push / g", unknown,
       fmt::format("{}, {}", text::fixed(heard.hardest.value / one_g_m_s2, 2), moment(heard, heard.hardest.time_s))});
  if (heard.control) {
    rows.push_back({"top speed / (m/s)",
                    fmt::format("{}{}, {}", at_least(heard), text::fixed(heard.fastest.value, 1),
                                moment(heard, heard.fastest.time_s)),
                    heard.log_fastest ? fmt::format("{}, {}", text::fixed(heard.log_fastest->value, 1),
                                                    moment(heard, heard.log_fastest->time_s))
                                      : unknown});
  }
  const auto apogee_s = heard.since_lift_off_s(heard.apogee_s);
  rows.push_back({"apogee after lift-off / s", apogee_s ? at_least(heard) + seconds(apogee_s) : unknown,
                  seconds(heard.since_lift_off_s(height.apogee_s))});
  rows.push_back({"apogee / m", heard.apogee_s ? at_least(heard) + text::fixed(heard.apogee_m, 1) : unknown,
                  height.apogee_s ? text::fixed(height.apogee_m, 1) : unknown});
  rows.push_back(
      {"tilt at the law's apogee / deg",
       heard.apogee_s && knows_tilt(heard.log) ? text::fixed(text::degrees(heard.tilt_at_apogee_rad), 1) : unknown,
       unknown});
  return rows;
}

namespace {

std::string phase_lines(const Heard& heard, std::size_t columns) {
  text::Table table{
      {{"phase"}, {"because"}, {"log / s"}, {"lift-off + / s"}, {"height", 3}, {"speed", 2}, {"tilt", 1}}};
  const auto add = [&table](const PhaseRow& row) {
    table.row({fmt::format("  {:<12}", row.phase), fmt::format(" {:<34}", row.reason),
               fmt::format(" {:>10}", row.log_time), fmt::format(" {:>14}", row.since_lift_off),
               fmt::format(" {:>10}", row.height), fmt::format(" {:>10}", row.speed), fmt::format(" {:>8}", row.tilt)});
  };
  add({"phase", "because", "log / s", "lift-off + / s", "height / m", "v / (m/s)", "tilt/deg"});
  for (const PhaseRow& row : phase_rows(heard)) {
    add(row);
  }
  return table.text(columns);
}

std::string comparison_lines(const Heard& heard, std::size_t columns) {
  text::Table table{{{""}, {"the law"}, {"the log"}}};
  const auto add = [&table](const std::string& what, const std::string& law, const std::string& log) {
    table.row({fmt::format("  {:<32}", what), fmt::format(" {:<36}", law), fmt::format(" {}", log)});
  };
  const std::string since = " s after lift-off";
  bool is_short = false;
  const auto fitting = [&](std::string cell) {
    if (columns < 100 && cell.ends_with(since)) {
      cell.resize(cell.size() - since.size());
      cell += " s";
      is_short = true;
    }
    return cell;
  };
  add("", "the law", "the log");
  for (const Row& row : comparison(heard)) {
    add(row.what, fitting(row.law), fitting(row.log));
  }
  return table.text(columns) + (is_short ? "  Times behind a comma count from lift-off.\n" : "");
}

}  // namespace

std::string as_text(const Heard& heard, std::size_t columns) {
  const core::LaunchDetectionPlan& rule = heard.flown.launch_detection;
  std::string text = fmt::format(
      "{}: {} rows, {:.3f} s to {:.3f} s{}\nplan {}: {} g for {} s{}, {}\n\n", heard.log.name, heard.log.rows,
      heard.log.begin_s(), heard.log.end_s(), heard.log.columns_from.empty() ? "" : ", " + heard.log.columns_from,
      heard.plan, text::brief(static_cast<double>(rule.threshold_m_s2) / one_g_m_s2, 2),
      text::brief(static_cast<double>(core::seconds(rule.hold)), 3),
      rule.low_pass ? fmt::format(", low-passed at {} Hz", text::brief(static_cast<double>(rule.low_pass_hz), 1)) : "",
      rule.accelerometers == core::AccelerometerRule::two_agree ? "two accelerometers that agree"
                                                                : "one accelerometer");
  for (const std::string& doubt : heard.doubts) {
    text += "In doubt: " + doubt + "\n";
  }
  text += headline(heard) + "\n";
  text += fmt::format("\n{}\n{}", phase_lines(heard, columns), comparison_lines(heard, columns));
  text += "\nNote: " + lift_off_rule();
  for (const std::string& note : heard.notes) {
    text += "\nNote: " + note;
  }
  return text + "\n";
}

}  // namespace fantail::listen
