// SPDX-License-Identifier: MIT
#include <vector>

#include "detection/tally.hpp"

namespace fantail::detection {
namespace {

json::Value histogram_json(const Histogram& histogram) {
  std::vector<json::Value> pairs;
  for (const auto& [value, times] : histogram.counts()) {
    pairs.push_back(json::Value::array({value, times}));
  }
  return pairs;
}

Histogram histogram_of(const json::Value& value) {
  Histogram histogram;
  for (const json::Value& pair : value) {
    histogram.add(static_cast<int>(pair[std::size_t{0}].number()), pair[1].count());
  }
  return histogram;
}

json::Value count_json(const Count& count) {
  json::Value value{{"events", count.events},
                    {"detected", count.detected},
                    {"controlling", count.controlling},
                    {"worst_event", count.worst.event},
                    {"worst", count.worst.value}};
  if (count.flown > 0 || count.control_by_part.total() > 0) {
    value["flown"] = count.flown;
    value["control_by_part"] = histogram_json(count.control_by_part);
  }
  if (count.all_by_peak_g.total() > 0) {
    value["inside_guide"] = count.inside_guide;
    value["latency_ms"] = histogram_json(count.latency_ms);
    value["control_ms"] = histogram_json(count.control_ms);
    value["error_cm"] = histogram_json(count.error_cm);
    value["distance_cm"] = histogram_json(count.distance_cm);
    value["all_by_peak_g"] = histogram_json(count.all_by_peak_g);
    value["missed_by_peak_g"] = histogram_json(count.missed_by_peak_g);
    value["late_by_peak_g"] = histogram_json(count.late_by_peak_g);
    value["tilt_error_ddeg"] = histogram_json(count.tilt_error_ddeg);
    value["all_by_still_s"] = histogram_json(count.all_by_still_s);
    value["missed_by_still_s"] = histogram_json(count.missed_by_still_s);
    value["tilted_by_still_s"] = histogram_json(count.tilted_by_still_s);
  }
  return value;
}

Count count_of(const json::Value& value) {
  Count count{.events = value["events"].count(),
              .detected = value["detected"].count(),
              .controlling = value["controlling"].count(),
              .worst = {.event = value["worst_event"].count(), .value = value["worst"].number()}};
  if (value.contains("flown")) {
    count.flown = value["flown"].count();
    count.control_by_part = histogram_of(value["control_by_part"]);
  }
  if (value.contains("all_by_peak_g")) {
    count.inside_guide = value["inside_guide"].count();
    count.latency_ms = histogram_of(value["latency_ms"]);
    count.control_ms = histogram_of(value["control_ms"]);
    count.error_cm = histogram_of(value["error_cm"]);
    count.distance_cm = histogram_of(value["distance_cm"]);
    count.all_by_peak_g = histogram_of(value["all_by_peak_g"]);
    count.missed_by_peak_g = histogram_of(value["missed_by_peak_g"]);
    count.late_by_peak_g = histogram_of(value["late_by_peak_g"]);
    count.tilt_error_ddeg = histogram_of(value["tilt_error_ddeg"]);
    count.all_by_still_s = histogram_of(value["all_by_still_s"]);
    count.missed_by_still_s = histogram_of(value["missed_by_still_s"]);
    count.tilted_by_still_s = histogram_of(value["tilted_by_still_s"]);
  }
  return count;
}

}  // namespace

json::Value tally_json(const Tally& tally) {
  std::vector<json::Value> rules;
  for (const auto& rule : tally.of_rule) {
    std::vector<json::Value> counts;
    for (const Count& count : rule) {
      counts.push_back(count_json(count));
    }
    rules.emplace_back(counts);
  }
  return rules;
}

Tally tally_of(const json::Value& value, std::size_t rules) {
  if (value.size() != rules) {
    throw json::Error{"not a tally of as many rules"};
  }
  Tally tally{rules};
  for (std::size_t rule = 0; rule < rules; ++rule) {
    for (std::size_t condition = 0; condition < conditions; ++condition) {
      tally.of_rule[rule][condition] = count_of(value[rule][condition]);
    }
  }
  return tally;
}

}  // namespace fantail::detection
