// SPDX-License-Identifier: MIT
#include "detection/report.hpp"
#include "json/value.hpp"

namespace fantail::detection {
namespace {

std::optional<double> scaled(const std::optional<int>& value, double scale) {
  return value ? std::optional{json::rounded(scale * *value)} : std::nullopt;
}

json::Value points(const Histogram& histogram, double scale) {
  return {{"p1", scaled(histogram.point(0.01), scale)},
          {"p50", scaled(histogram.point(0.5), scale)},
          {"p99", scaled(histogram.point(0.99), scale)}};
}

json::Value by_peak_thrust(const Count& count) {
  std::vector<json::Value> rows;
  for (const auto& [peak_g, all] : count.all_by_peak_g.counts()) {
    rows.push_back({{"peak_g", peak_g},
                    {"launches", all},
                    {"missed", count.missed_by_peak_g.times(peak_g)},
                    {"late", count.late_by_peak_g.times(peak_g)}});
  }
  return rows;
}

json::Value by_time_still(const Count& count) {
  std::vector<json::Value> rows;
  for (const auto& [still_s, all] : count.all_by_still_s.counts()) {
    rows.push_back({{"still_s", still_s},
                    {"launches", all},
                    {"missed", count.missed_by_still_s.times(still_s)},
                    {"tilt_off_by_more_than_5_deg", count.tilted_by_still_s.times(still_s)}});
  }
  return rows;
}

json::Value by_part(const Count& count) {
  json::Value value;
  for (std::size_t part = 0; part < flight_parts; ++part) {
    value[part_names[part]] = count.control_by_part.times(static_cast<int>(part));
  }
  return value;
}

json::Value row(const Report& report, Kind kind, std::size_t rule, std::size_t condition) {
  const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][condition];
  json::Value value{{"kind", info(kind).name},
                    {"accelerometers", condition_names[condition]},
                    {"events", count.events},
                    {"detected", count.detected},
                    {"controlling", count.controlling}};
  if (is_launch(kind)) {
    value["missed"] = count.events - count.detected;
    value["missed_at_most"] = upper_bound_95(count.events - count.detected, count.events);
    value["inside_guide"] = count.inside_guide;
    value["latency_s"] = points(count.latency_ms, 1e-3);
    value["control_start_s"] = points(count.control_ms, 1e-3);
    value["distance_at_control_start_m"] = points(count.distance_cm, 1e-2);
    value["distance_error_m"] = points(count.error_cm, 1e-2);
    value["by_peak_thrust"] = by_peak_thrust(count);
    value["tilt_error_deg"] = points(count.tilt_error_ddeg, 0.1);
    if (kind == Kind::raised_rail) {
      value["by_time_still"] = by_time_still(count);
    }
  } else {
    value["detected_at_most"] = upper_bound_95(count.detected, count.events);
    value["false_actuations_at_most"] = upper_bound_95(count.controlling, count.events);
    value["largest_share_of_gate"] = count.worst.value;
    if (is_flight(kind)) {
      value["controlled_as_they_should"] = count.flown;
      value["false_actuations_by_part"] = by_part(count);
    }
  }
  value["worst"] = command_of(report.campaign, kind, count.worst.event);
  return value;
}

}  // namespace

std::string report_json(const Report& report) {
  std::vector<json::Value> rules;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    std::vector<json::Value> rows;
    for (const Kind kind : report.campaign.kinds) {
      for (std::size_t condition = 0; condition < conditions; ++condition) {
        if (report.results.of_kind[index(kind)]->of_rule[rule][condition].events > 0) {
          rows.push_back(row(report, kind, rule, condition));
        }
      }
    }
    const Sum events = events_of(report.results, rule);
    const Sum well = well_events_of(report.results, rule);
    const Sum launches = launches_of(report.results, rule);
    rules.push_back({{"plans", report.campaign.rules[rule].names},
                     {"judged", report.campaign.rules[rule].judged},
                     {"events", events.events},
                     {"launches_imagined", events.detected},
                     {"false_actuations", events.controlling},
                     {"false_actuations_at_most", upper_bound_95(events.controlling, events.events)},
                     {"events_both_well", well.events},
                     {"false_actuations_both_well", well.controlling},
                     {"false_actuations_both_well_at_most", upper_bound_95(well.controlling, well.events)},
                     {"launches", launches.events},
                     {"launches_missed", launches.events - launches.detected},
                     {"launches_missed_at_most", upper_bound_95(launches.events - launches.detected, launches.events)},
                     {"rows", rows}});
  }
  std::vector<json::Value> asked;
  for (const Requirement& requirement : requirements(report)) {
    asked.push_back({{"verdict", name(requirement.verdict)}, {"sentence", requirement.sentence}});
  }
  json::Value value{{"version", report.version},
                    {"seed", report.campaign.seed},
                    {"events_of_each_kind", report.campaign.events},
                    {"launches_of_each_kind", report.campaign.launches},
                    {"both_well", report.campaign.both_well},
                    {"at_most", report.at_most},
                    {"false_at_most", report.false_at_most},
                    {"verdict", name(verdict(requirements(report)))},
                    {"requirements", asked},
                    {"failures", failures(report)},
                    {"known_limits", known_limits(report)},
                    {"rules", rules}};
  json::keep_exact(value, "seed");
  result::put_answer(value, answer(verdict(requirements(report))),
                     what_was_judged(report, verdict(requirements(report))), report.made);
  return value.pretty();
}

}  // namespace fantail::detection
