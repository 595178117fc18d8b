// SPDX-License-Identifier: MIT
#include "listen/answer.hpp"

#include <fmt/core.h>

#include "core/tick_record.hpp"
#include "flight/phase_names.hpp"
#include "json/value.hpp"
#include "listen/sentences.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

using result::Cell;
using text::brief;
using text::fixed;
using Json = json::Value;
namespace u = result::units;

constexpr result::Unit in_g{"_m_s2", "g", 1.0, 1.0 / one_g_m_s2};

Cell value(const std::optional<double>& number) { return number ? Cell{*number} : Cell{}; }

using H = Heard;
constexpr auto heard_fields = result::fields<H>({
    {"lift_off", "lift-off by the log's clock", u::s, 3, [](const H& h) { return value(h.known_lift_off_s()); },
     "by the log's clock; null where there is none, or where it lies in a gap"},
    {"detected_since_lift_off", "detected after lift-off", u::s, 3,
     [](const H& h) { return value(h.since_lift_off_s(h.detected_s)); }, "time from lift-off to its detection"},
    {"detected_before_lift_off", "detected before lift-off", u::none, 0,
     [](const H& h) { return Cell{std::uint64_t{h.false_detections_s.size()}}; },
     "number of false launches that were detected before lift-off"},
    {"peak_axial", "largest push", in_g, 2, [](const H& h) { return Cell{h.hardest.value}; },
     "largest axial specific force between lift-off and top speed"},
});
constexpr auto log_fields = result::fields<H>({
    {"rows", "rows", u::none, 0, [](const H& h) { return Cell{std::uint64_t{h.log.rows}}; }, "rows of the log"},
    {"from", "from", u::s, 3, [](const H& h) { return Cell{h.log.begin_s()}; }, "the log's first sample"},
    {"to", "to", u::s, 3, [](const H& h) { return Cell{h.log.end_s()}; }, "its last"},
    {"interval", "interval", u::s, 4, [](const H& h) { return Cell{h.log.interval_s}; },
     "usual time between two samples, around lift-off"},
    {"longest_bridge", "longest bridge", u::s, 4, &H::longest_bridge_s,
     "longest time between two samples that a straight line bridges"},
    {"detected", "detected", u::s, 3, &H::detected_s, "by the log's clock"},
    {"early_control", "early control", u::s, 3, &H::early_control_s,
     "when control began before lift-off, or in a log without one"},
    {"disagreed_before_detection", "disagreed before detection", u::s, 3,
     [](const H& h) { return Cell{h.no_hold.in_all_s}; },
     "how long two accelerometers differed while the law waited for the launch"},
    {"disagreed_before_control", "disagreed before control", u::s, 3,
     [](const H& h) { return Cell{h.no_control.in_all_s}; },
     "how long they differed beyond the guide, so that control did not begin"},
    {"is_lower_bound", "lower bound", u::none, 0, &H::is_lower_bound,
     "whether the law's top speed, apogee and time of apogee are lower bounds"},
});

constexpr auto gap_fields = result::fields<Gap>({
    {"from", "from", u::s, 3, &Gap::from_s, "last sample before the gap"},
    {"to", "to", u::s, 3, &Gap::to_s, "first sample after the gap"},
});

struct Entered : Event {
  std::optional<double> since_lift_off_s{};
};
using E = Entered;
constexpr auto phase_fields = result::fields<E>({
    {"phase", "phase", u::none, 0, [](const E& e) { return Cell{std::string{core::name(e.to)}}; },
     "phase that was entered"},
    {"reason", "because", u::none, 0, [](const E& e) { return Cell{std::string{core::name(e.reason)}}; }, "why"},
    {"time", "log's clock", u::s, 3, [](const E& e) { return Cell{e.time_s}; }, "by the log's clock"},
    {"since_lift_off", "after lift-off", u::s, 3, &E::since_lift_off_s, "after lift-off, where that is known"},
    {"height", "height", u::m, 1, [](const E& e) { return Cell{e.height_m}; },
     "above the pad, as the law estimated it"},
    {"speed", "speed", u::m_s, 1, [](const E& e) { return Cell{e.speed_m_s}; }, "along the guide, likewise"},
    {"tilt", "tilt", u::deg, 1, [](const E& e) { return Cell{e.tilt_rad}; }, "likewise"},
});

/// What the law knew, and what the log itself says.
struct Told {
  std::optional<double> top_speed_m_s{};
  std::optional<double> top_speed_at_s{};
  std::optional<double> top_speed_since_lift_off_s{};
  std::optional<double> apogee_s{};
  std::optional<double> apogee_since_lift_off_s{};
  std::optional<double> apogee_m{};
  std::optional<double> tilt_rad{};
};
constexpr auto side_fields = result::fields<Told>({
    {"top_speed", "top speed", u::m_s, 1, &Told::top_speed_m_s, "up to apogee"},
    {"top_speed_at", "top speed, log's clock", u::s, 2, &Told::top_speed_at_s, "when, by the log's clock"},
    {"top_speed_since_lift_off", "top speed after lift-off", u::s, 2, &Told::top_speed_since_lift_off_s, "likewise"},
    {"apogee", "apogee, log's clock", u::s, 3, &Told::apogee_s, "when, by the log's clock"},
    {"apogee_since_lift_off", "apogee after lift-off", u::s, 3, &Told::apogee_since_lift_off_s, "likewise"},
    {"apogee", "apogee", u::m, 1, &Told::apogee_m, "above the pad"},
    {"tilt_at_apogee", "tilt at apogee", u::deg, 1, &Told::tilt_rad, "the law's, where the log has pitch or yaw"},
});

Told law_of(const H& h) {
  Told law{.apogee_s = h.apogee_s, .apogee_since_lift_off_s = h.since_lift_off_s(h.apogee_s)};
  if (h.control) {
    law.top_speed_m_s = h.fastest.value;
    law.top_speed_at_s = h.fastest.time_s;
    law.top_speed_since_lift_off_s = h.since_lift_off_s(h.fastest.time_s);
  }
  if (h.apogee_s) {
    law.apogee_m = h.apogee_m;
    law.tilt_rad = knows_tilt(h.log) ? std::optional{h.tilt_at_apogee_rad} : std::nullopt;
  }
  return law;
}

Told log_of(const H& h) {
  const LogHeight& height = h.log_height;
  Told log{.apogee_s = height.apogee_s, .apogee_since_lift_off_s = h.since_lift_off_s(height.apogee_s)};
  if (h.log_fastest) {
    log.top_speed_m_s = h.log_fastest->value;
    log.top_speed_at_s = h.log_fastest->time_s;
    log.top_speed_since_lift_off_s = h.since_lift_off_s(h.log_fastest->time_s);
  }
  log.apogee_m = height.apogee_s ? std::optional{height.apogee_m} : std::nullopt;
  return log;
}

Json times(const std::vector<double>& times_s) {
  Json list = Json::array();
  for (const double time_s : times_s) {
    list.push_back(json::rounded(time_s));
  }
  return list;
}

Json clipped(const H& h) {
  Json list = Json::array();
  for (const auto& [what, end] : h.clipped) {
    const bool is_rate = what.ends_with("rate");
    list.push_back({{"quantity", what},
                    {"at", result::json_of(is_rate ? u::deg_s : u::none, end.value)},
                    {"unit", is_rate ? "deg/s" : "m/s2"},
                    {"samples", end.samples},
                    {"longest_s", json::rounded(end.longest_s)},
                    {"first_s", json::rounded(end.first_s)}});
  }
  return list;
}

std::vector<Entered> entered_of(const H& h) {
  std::vector<Entered> entered;
  entered.reserve(h.events.size());
  for (const Event& event : h.events) {
    entered.push_back({event, h.since_lift_off_s(event.time_s)});
  }
  return entered;
}

std::vector<result::Block> phase_blocks(const H& h) {
  const std::vector<Entered> entered = entered_of(h);
  result::Table read = result::table({}, entered, phase_fields);
  for (std::size_t i = 0; i < entered.size(); ++i) {
    read.rows[i][read.column("phase")] = flight::display_name(entered[i].to);
    read.rows[i][read.column("reason")] = std::string{flight::display_name(entered[i].reason)};
  }
  const core::LaunchDetectionPlan& rule = h.flown.launch_detection;
  return {
      fmt::format(
          "The plan detects a launch at {} g for {} s{}, with {}.",
          brief(static_cast<double>(rule.threshold_m_s2) / one_g_m_s2, 2),
          brief(static_cast<double>(core::seconds(rule.hold)), 3),
          rule.low_pass ? fmt::format(", low-passed at {} Hz", brief(static_cast<double>(rule.low_pass_hz), 1)) : "",
          rule.accelerometers == core::AccelerometerRule::two_agree ? "two accelerometers that agree"
                                                                    : "one accelerometer"),
      read, "Height, speed and tilt are the law's estimates at that moment."};
}

std::vector<result::Block> comparison(const H& h) {
  result::Figures figures = result::figures("", h, heard_fields);
  const auto since = h.since_lift_off_s(h.hardest.time_s);
  figures["peak_axial"].remark =
      since ? fmt::format("{} s after lift-off, of all up to {}", fixed(*since, 2), h.control ? "top speed" : "apogee")
            : fmt::format("{} s of the log's clock", fixed(h.hardest.time_s, 2));
  const result::Figures law = result::figures("law", law_of(h), side_fields);
  const result::Figures log = result::figures("log_itself", log_of(h), side_fields);
  std::vector<result::Block> all{figures, result::beside({{"the law", law}, {"the log", log}})};
  if (h.is_lower_bound) {
    all.emplace_back("The law's top speed, apogee and time of apogee are lower bounds.");
  }
  all.emplace_back(lift_off_rule() +
                   " The log's apogee is where a running median of its height over 0.5 s is largest.");
  return all;
}

std::vector<result::Block> for_programs(const H& h) {
  return {result::figures("", h, log_fields),
          result::table("gaps", h.gaps, gap_fields),
          result::Data{"ends_of_range", clipped(h)},
          h.lift_off_gap ? result::Block{result::figures("lift_off_gap", *h.lift_off_gap, gap_fields)}
                         : result::Data{"lift_off_gap", {}},
          result::Data{"further_lift_offs_s", times(h.further_lift_offs_s)},
          result::Data{"false_detections_s", times(h.false_detections_s)},
          result::table("phases", entered_of(h), phase_fields),
          result::figures("law", law_of(h), side_fields),
          result::figures("log_itself", log_of(h), side_fields)};
}

std::string_view name_of(Finding finding) {
  switch (finding) {
    case Finding::heard: return "heard";
    case Finding::late: return "late";
    case Finding::imagined: return "imagined";
    case Finding::imagined_and_missed: return "imagined_and_missed";
    case Finding::missed: return "missed";
    case Finding::no_launch: return "no_launch";
  }
  return "unknown";
}

std::string_view heading(Finding finding) {
  switch (finding) {
    case Finding::heard: return "Detected in time";
    case Finding::late: return "Detected late";
    case Finding::imagined: return "False launch";
    case Finding::imagined_and_missed: return "False launch, and the real one missed";
    case Finding::missed: return "Missed";
    case Finding::no_launch: break;
  }
  return "No launch";
}

result::Answer answer_of(const H& h) {
  switch (finding(h)) {
    case Finding::heard: return h.doubts.empty() ? result::Answer::yes : result::Answer::undecided;
    case Finding::late:
    case Finding::imagined:
    case Finding::imagined_and_missed:
    case Finding::missed: return result::Answer::no;
    case Finding::no_launch: break;
  }
  return result::Answer::undecided;
}

/// Doubts go before what they are doubts of.
result::Verdict verdict(const H& h) {
  std::string sentence;
  for (const std::string& doubt : h.doubts) {
    sentence += doubt + " ";
  }
  return {.answer = answer_of(h),
          .heading = std::string{heading(finding(h))} + (h.doubts.empty() ? "" : ", in doubt"),
          .sentence = sentence + headline(h)};
}

}  // namespace

std::vector<result::Listed> listed_fields() {
  std::vector<result::Listed> all{result::listed("", heard_fields), result::listed("gaps[], lift_off_gap", gap_fields),
                                  result::listed("phases[]", phase_fields),
                                  result::listed("law, log_itself", side_fields)};
  for (const result::Column& column : result::listed("", log_fields).columns) {
    all.front().columns.push_back(column);
  }
  return all;
}

result::Document answer(const Heard& h, const result::Made& made) {
  using enum result::Readers;
  result::Document document{
      .kind = "launch law on a log",
      .title = std::filesystem::path{h.log.name}.filename().string(),
      .subtitle = fmt::format("plan {}; {} rows, {:.3f} s to {:.3f} s, {} samples a second{}", h.plan, h.log.rows,
                              h.log.begin_s(), h.log.end_s(), brief(1.0 / h.log.interval_s, 1),
                              h.log.columns_from.empty() ? "" : ", " + h.log.columns_from),
      .verdict = verdict(h),
      .facts = {{"log", "log", h.log.name},
                {"plan", "", h.plan},
                {"finding", "", name_of(finding(h))},
                {"doubts", "", h.doubts},
                {"headline", "", headline(h)},
                {"version", "", made.version}},
      .sections = {{"Phases", phase_blocks(h)}, {"The law beside the log", comparison(h)}},
      .made = made};
  for (result::Section& section : charts(h)) {
    document.sections.push_back(std::move(section));
  }
  document.sections.push_back({"How it was flown", {result::Sentences{"notes", h.notes}}});
  document.sections.push_back({"For programs", for_programs(h), programs});
  return document;
}

}  // namespace fantail::listen
