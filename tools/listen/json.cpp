// SPDX-License-Identifier: MIT
#include "core/tick_record.hpp"
#include "json/value.hpp"
#include "listen/outputs.hpp"
#include "listen/sentences.hpp"
#include "text/degrees.hpp"

namespace fantail::listen {
namespace {

using Json = json::Value;
using json::rounded;

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

Json events(const Heard& heard) {
  Json list = Json::array();
  for (const Event& event : heard.events) {
    list.push_back({{"phase", core::name(event.to)},
                    {"reason", core::name(event.reason)},
                    {"time_s", rounded(event.time_s)},
                    {"since_lift_off_s", rounded(heard.since_lift_off_s(event.time_s))},
                    {"height_m", rounded(event.height_m)},
                    {"speed_m_s", rounded(event.speed_m_s)},
                    {"tilt_deg", rounded(text::degrees(event.tilt_rad))}});
  }
  return list;
}

Json times(const std::vector<double>& times_s) {
  Json list = Json::array();
  for (const double time_s : times_s) {
    list.push_back(rounded(time_s));
  }
  return list;
}

Json json_of(const Gap& gap) { return {{"from_s", rounded(gap.from_s)}, {"to_s", rounded(gap.to_s)}}; }

Json gaps_of(const Heard& heard) {
  Json list = Json::array();
  for (const Gap& gap : heard.gaps) {
    list.push_back(json_of(gap));
  }
  return list;
}

Json clipped(const Heard& heard) {
  Json list = Json::array();
  for (const auto& [what, end] : heard.clipped) {
    const bool is_rate = what.ends_with("rate");
    list.push_back({{"quantity", what},
                    {"at", rounded(is_rate ? text::degrees(end.value) : end.value)},
                    {"unit", is_rate ? "deg/s" : "m/s2"},
                    {"samples", end.samples},
                    {"longest_s", rounded(end.longest_s)},
                    {"first_s", rounded(end.first_s)}});
  }
  return list;
}

template <typename T>
std::optional<T> where(bool known, T value) {
  return known ? std::optional{value} : std::nullopt;
}

}  // namespace

std::string as_json(const Heard& heard, std::string_view version, const result::Made& made) {
  const bool flew = heard.control.has_value();
  const bool turned = heard.apogee_s.has_value();
  const LogHeight& height = heard.log_height;
  Json json = {{"log", heard.log.name},
               {"plan", heard.plan},
               {"finding", name_of(finding(heard))},
               {"doubts", heard.doubts},
               {"headline", headline(heard)},
               {"rows", heard.log.rows},
               {"from_s", rounded(heard.log.begin_s())},
               {"to_s", rounded(heard.log.end_s())},
               {"interval_s", rounded(heard.log.interval_s)},
               {"longest_bridge_s", rounded(heard.longest_bridge_s)},
               {"gaps", gaps_of(heard)},
               {"ends_of_range", clipped(heard)},
               {"lift_off_s", rounded(heard.known_lift_off_s())},
               {"lift_off_gap", heard.lift_off_gap ? json_of(*heard.lift_off_gap) : Json{}},
               {"further_lift_offs_s", times(heard.further_lift_offs_s)},
               {"detected_s", rounded(heard.detected_s)},
               {"detected_since_lift_off_s", rounded(heard.since_lift_off_s(heard.detected_s))},
               {"false_detections_s", times(heard.false_detections_s)},
               {"early_control_s", rounded(heard.early_control_s)},
               {"disagreed_before_detection_s", rounded(heard.no_hold.in_all_s)},
               {"disagreed_before_control_s", rounded(heard.no_control.in_all_s)},
               {"phases", events(heard)},
               {"peak_axial_m_s2", rounded(heard.hardest.value)},
               {"is_lower_bound", heard.is_lower_bound},
               {"law",
                {{"top_speed_m_s", rounded(where(flew, heard.fastest.value))},
                 {"top_speed_at_s", rounded(where(flew, heard.fastest.time_s))},
                 {"apogee_s", rounded(heard.apogee_s)},
                 {"apogee_since_lift_off_s", rounded(heard.since_lift_off_s(heard.apogee_s))},
                 {"apogee_m", rounded(where(turned, heard.apogee_m))},
                 {"tilt_at_apogee_deg",
                  rounded(where(turned && knows_tilt(heard.log), text::degrees(heard.tilt_at_apogee_rad)))}}},
               {"log_itself",
                {{"top_speed_m_s", heard.log_fastest ? Json(rounded(heard.log_fastest->value)) : Json{}},
                 {"apogee_s", rounded(height.apogee_s)},
                 {"apogee_since_lift_off_s", rounded(heard.since_lift_off_s(height.apogee_s))},
                 {"apogee_m", rounded(where(height.apogee_s.has_value(), height.apogee_m))}}},
               {"notes", heard.notes},
               {"version", version}};
  result::put_answer(json, answer(heard), headline(heard), made);
  return json.pretty();
}

}  // namespace fantail::listen
