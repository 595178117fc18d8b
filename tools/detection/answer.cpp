// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "detection/report.hpp"
#include "json/value.hpp"

namespace fantail::detection {
namespace {

using result::Cell;
namespace u = result::units;

constexpr int exact = -17;  // digits: a bound of 10^9 events is as small

/// The counts of one rule over the kinds.
struct Sums {
  const Rule* rule;
  Sum events;
  Sum well;
  Sum launches;
};
Cell at_most(std::uint64_t count, const Sum& of) { return upper_bound_95(count, of.events); }
std::uint64_t missed(const Sum& launches) { return launches.events - launches.detected; }

constexpr auto rule_fields = result::fields<Sums>({
    {"judged", "judged", u::none, 0, [](const Sums& s) { return Cell{s.rule->judged}; },
     "whether a false actuation by this rule is a failure"},
    {"events", "events", u::none, 0, [](const Sums& s) { return Cell{s.events.events}; },
     "events that are not launches"},
    {"launches_imagined", "false launches", u::none, 0, [](const Sums& s) { return Cell{s.events.detected}; },
     "events in which it detected a launch"},
    {"false_actuations", "false actuations", u::none, 0, [](const Sums& s) { return Cell{s.events.controlling}; },
     "events in which its canards could move"},
    {"false_actuations_at_most", "at most", u::percent, 2,
     [](const Sums& s) { return at_most(s.events.controlling, s.events); }, "95 % bound of their share"},
    {"events_both_well", "events, both healthy", u::none, 0, [](const Sums& s) { return Cell{s.well.events}; },
     "events with both accelerometers healthy"},
    {"false_actuations_both_well", "false actuations, both healthy", u::none, 0,
     [](const Sums& s) { return Cell{s.well.controlling}; }, "those of them in which its canards could move"},
    {"false_actuations_both_well_at_most", "at most", u::percent, 2,
     [](const Sums& s) { return at_most(s.well.controlling, s.well); }, "95 % bound of their share"},
    {"launches", "launches", u::none, 0, [](const Sums& s) { return Cell{s.launches.events}; },
     "launches with both accelerometers healthy"},
    {"launches_missed", "missed", u::none, 0, [](const Sums& s) { return Cell{missed(s.launches)}; },
     "those of them that it missed"},
    {"launches_missed_at_most", "at most", u::percent, 2,
     [](const Sums& s) { return at_most(missed(s.launches), s.launches); }, "95 % bound of their share"},
});

/// What one rule made of one kind, the accelerometers in one condition.
struct Row {
  Kind kind;
  std::size_t condition;
  const Count* count;
};
constexpr auto row_fields = result::fields<Row>({
    {"kind", "kind", u::none, 0, [](const Row& r) { return Cell{std::string{info(r.kind).name}}; },
     "kind of event, as --kind takes it"},
    {"accelerometers", "accelerometers", u::none, 0,
     [](const Row& r) { return Cell{std::string{condition_names[r.condition]}}; }, "their condition"},
    {"events", "events", u::none, 0, [](const Row& r) { return Cell{r.count->events}; },
     "events of the kind, or launches"},
    {"detected", "detected", u::none, 0, [](const Row& r) { return Cell{r.count->detected}; },
     "those in which it detected a launch"},
    {"controlling", "controlling", u::none, 0, [](const Row& r) { return Cell{r.count->controlling}; },
     "those in which its canards could move"},
});
constexpr auto launch_fields = result::fields<Row>({
    {"missed", "missed", u::none, 0, [](const Row& r) { return Cell{r.count->events - r.count->detected}; },
     "launches that were not detected"},
    {"missed_at_most", "at most", u::percent, 2,
     [](const Row& r) { return Cell{upper_bound_95(r.count->events - r.count->detected, r.count->events)}; },
     "95 % bound of their share"},
    {"inside_guide", "in guide", u::none, 0, [](const Row& r) { return Cell{r.count->inside_guide}; },
     "launches in which control began inside the guide"},
});
constexpr auto event_fields = result::fields<Row>({
    {"detected_at_most", "at most", u::percent, 2,
     [](const Row& r) { return Cell{upper_bound_95(r.count->detected, r.count->events)}; },
     "95 % bound of the share that was detected"},
    {"false_actuations_at_most", "at most", u::percent, 2,
     [](const Row& r) { return Cell{upper_bound_95(r.count->controlling, r.count->events)}; },
     "95 % bound of the share in which its canards could move"},
    {"largest_share_of_gate", "nearest to the gate", u::percent, 0,
     [](const Row& r) { return Cell{r.count->worst.value}; },
     "how near an event came to opening the gate; at 1 it opens"},
});

template <typename Of>
void put(json::Value& to, const Of& row, const result::Fields<Of> auto& fields) {
  for (const auto& field : fields) {
    to[field.key] = result::json_of(field.unit, field.get(row), exact);
  }
}

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

json::Value json_of(const Campaign& campaign, const Row& row) {
  const Count& count = *row.count;
  json::Value value;
  put(value, row, row_fields);
  if (is_launch(row.kind)) {
    put(value, row, launch_fields);
    value["latency_s"] = points(count.latency_ms, 1e-3);
    value["control_start_s"] = points(count.control_ms, 1e-3);
    value["distance_at_control_start_m"] = points(count.distance_cm, 1e-2);
    value["distance_error_m"] = points(count.error_cm, 1e-2);
    value["by_peak_thrust"] = by_peak_thrust(count);
    value["tilt_error_deg"] = points(count.tilt_error_ddeg, 0.1);
    if (row.kind == Kind::raised_rail) {
      value["by_time_still"] = by_time_still(count);
    }
  } else {
    put(value, row, event_fields);
    if (is_flight(row.kind)) {
      value["controlled_as_they_should"] = count.flown;
      value["false_actuations_by_part"] = by_part(count);
    }
  }
  value["worst"] = command_of(campaign, row.kind, count.worst.event);
  return value;
}

Sums sums(const Report& report, std::size_t rule) {
  return {&report.campaign.rules[rule], events_of(report.results, rule), well_events_of(report.results, rule),
          launches_of(report.results, rule)};
}

json::Value rules(const Report& report) {
  std::vector<json::Value> all;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    std::vector<json::Value> rows;
    for (const Kind kind : report.campaign.kinds) {
      for (std::size_t condition = 0; condition < conditions; ++condition) {
        const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][condition];
        if (count.events > 0) {
          rows.push_back(json_of(report.campaign, {kind, condition, &count}));
        }
      }
    }
    json::Value& one = all.emplace_back();
    one["plans"] = report.campaign.rules[rule].names;
    put(one, sums(report, rule), rule_fields);
    one["rows"] = rows;
  }
  return all;
}

std::vector<result::Block> asked(const std::vector<Requirement>& requirements) {
  result::Table table{.columns = {{.key = "verdict", .label = "verdict"}, {.key = "sentence", .label = "requirement"}}};
  json::Value all = json::Value::array();
  for (const Requirement& one : requirements) {
    table.rows.push_back({result::Judged{answer_of(one.verdict), name(one.verdict)}, one.sentence});
    all.push_back({{"verdict", name(one.verdict)}, {"sentence", one.sentence}});
  }
  return {table, result::Data{"requirements", all}};
}

std::vector<result::Section> of_rule(const Report& report, std::size_t rule) {
  using result::Sentences;
  const Rule& of = report.campaign.rules[rule];
  const result::Table launches = launches_table(report, rule);
  std::vector<result::Block> blocks{events_table(report, rule), Sentences{.all = about_flights(report, rule)},
                                    launches};
  if (!launches.rows.empty()) {
    blocks.emplace_back(
        "Latency: from the first time the thrust crosses the threshold, for 50 and 99 % of the launches. Control "
        "start: after ignition, for the same shares. Distance: true distance along the guide at control start; error: "
        "estimated less true distance; both for 1, 50 and 99 %. In guide: control starts while the rocket is truly in "
        "the guide. Tilt error: estimated less true tilt at detection, for 50 and 99 %.");
  }
  blocks.emplace_back(Sentences{.all = about_launches(report, rule)});
  return {{of.name() + (of.judged ? "" : " (shown, not judged)"), blocks},
          {fmt::format("Each condition of the accelerometers, {}", of.name()),
           {events_by_condition(report, rule)},
           result::Readers::files}};
}

std::vector<result::Section> sections(const Report& report, const std::vector<Requirement>& requirements) {
  using enum result::Readers;
  std::vector<result::Section> list;
  if (const std::string bounds = bounds_svg(report, page::full_page); !bounds.empty()) {
    list.push_back(
        {"Events that are not launches, both accelerometers healthy",
         {result::Drawing{bounds, bounds_svg(report, page::half_page),
                          "A dot is the count, and its line ends at the 95 % bound. An arrow: none was counted, "
                          "and the share lies below its tip."}},
         files});
  }
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    std::ranges::move(of_rule(report, rule), std::back_inserter(list));
  }
  list.push_back({"All events and launches", {result::Sentences{.all = sum_lines(report)}}});
  list.push_back({"Requirements", asked(requirements)});
  list.push_back({"Known limits, not judged", {result::Sentences{"known_limits", known_limits(report)}}});
  for (const Kind kind : {Kind::launch, Kind::launch_at_2_g}) {
    if (report.results.of_kind[index(kind)]) {
      list.push_back({fmt::format("Delay: {}", info(kind).name), distributions(report, kind), files});
    }
  }
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    if (auto worst = worst_event(report, rule)) {
      list.push_back(std::move(*worst));
    }
  }
  list.push_back({"Models", {models(report)}, files});
  list.push_back({"For programs",
                  {result::Sentences{"failures", failures(report)}, result::Data{"rules", rules(report)}},
                  programs});
  return list;
}

}  // namespace

std::vector<result::Listed> listed_fields() {
  return {result::listed("rules[]", rule_fields), result::listed("rules[].rows[]", row_fields),
          result::listed("rules[].rows[], of a launch", launch_fields),
          result::listed("rules[].rows[], of an event", event_fields)};
}

result::Document answer(const Report& report) {
  const std::vector<Requirement> asked = requirements(report);
  const Verdict came = verdict(asked);
  return {.kind = "detection campaign",
          .title = "False and missed launches",
          .subtitle = fmt::format("{} events and launches, seed {}; shares \"at most\" are 95 % bounds (Clopper and "
                                  "Pearson, one-sided)",
                                  report.campaign.total(), report.campaign.seed),
          .verdict = {.answer = answer_of(came),
                      .heading = came == Verdict::met       ? "Met"
                                 : came == Verdict::not_met ? "Not met"
                                                            : "Not judged",
                      .sentence = what_was_judged(report, came)},
          .facts = {{"version", "", report.made.version},
                    {"seed", "", report.campaign.seed},
                    {"events_of_each_kind", "", report.campaign.events},
                    {"launches_of_each_kind", "", report.campaign.launches},
                    {"both_well", "", report.campaign.both_well},
                    {"at_most", "", report.at_most},
                    {"false_at_most", "", report.false_at_most},
                    {"verdict", "", name(came)}},
          .sections = sections(report, asked),
          .made = report.made};
}

}  // namespace fantail::detection
