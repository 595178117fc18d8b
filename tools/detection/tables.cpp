// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "detection/report.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

// What each rule made of the events and launches, for people.
namespace fantail::detection {
namespace {

using result::Digits;

result::Column titled(const std::string& label) { return {.key = label, .label = label}; }

const Count& count_of(const Report& report, Kind kind, std::size_t rule, std::size_t condition) {
  return report.results.of_kind[index(kind)]->of_rule[rule][condition];
}

/// Any is bad where it is judged.
Digits bad_if_any(std::uint64_t count, std::uint64_t of, bool judged) {
  return {with_bound(count, of), count == 0 ? result::Answer::yes
                                 : judged   ? result::Answer::no
                                            : result::Answer::undecided};
}

std::string point(const Histogram& histogram, double share, double scale, int decimals) {
  const auto point = histogram.point(share);
  return point ? text::fixed(scale * *point, decimals) : "-";
}
/// Of 50 and 99 %.
Digits two_points(const Histogram& of, double scale, int decimals) {
  return {fmt::format("{}, {}", point(of, 0.5, scale, decimals), point(of, 0.99, scale, decimals))};
}
/// Of 1, 50 and 99 %.
Digits three_points(const Histogram& of) {
  return {fmt::format("{}, {}", point(of, 0.01, 0.01, 2), two_points(of, 0.01, 2).text)};
}

/// Where on the scale of thrust it misses, or is late.
std::string by_thrust(const Count& count) {
  std::string text;
  for (const auto& [peak_g, all] : count.all_by_peak_g.counts()) {
    const std::uint64_t missed = count.missed_by_peak_g.times(peak_g);
    const std::uint64_t late = count.late_by_peak_g.times(peak_g);
    if (missed + late > 0) {
      text += fmt::format("{}{} g {} and {} of {}", text.empty() ? "" : "; ", peak_g, missed, late, all);
    }
  }
  return text.empty() ? text
                      : fmt::format("by peak thrust over weight, missed and later than {} ms: {}.", late_ms, text);
}

/// Of rails that were raised: by the seconds from then to ignition.
std::string time_still_sentence(const Count& count) {
  std::string text;
  for (const auto& [still_s, all] : count.all_by_still_s.counts()) {
    text += fmt::format("{}{} s {} and {} of {}", text.empty() ? "" : "; ", still_s,
                        count.missed_by_still_s.times(still_s), count.tilted_by_still_s.times(still_s), all);
  }
  return text.empty() ? text
                      : fmt::format("by whole seconds at rest, missed and tilt off by more than {} deg: {}.",
                                    tilted_ddeg / 10, text);
}

}  // namespace

// Rounded up: "at most" is not to say less than the bound.
std::string bound_text(std::uint64_t count, std::uint64_t of) {
  const double bound = 100.0 * upper_bound_95(count, of);
  const double unit = bound < 10.0 ? std::pow(10.0, std::floor(std::log10(bound)) - 1.0) : 0.1;
  return fmt::format("at most {:.3g} %", unit * std::ceil(bound / unit - 1e-9));
}

std::string with_bound(std::uint64_t count, std::uint64_t of) {
  return of == 0 ? "0 of 0" : fmt::format("{} ({})", count, bound_text(count, of));
}

std::string command_of(const Campaign& campaign, Kind kind, std::uint64_t event) {
  std::string command = fmt::format("fantail campaign detection --kind {} --event {}{}", info(kind).name, event,
                                    campaign.seed == Campaign{}.seed ? "" : fmt::format(" --seed {}", campaign.seed));
  for (const std::string& plan : campaign.plans) {
    command += " --plan " + text::shell_word(plan);
  }
  return command;
}

result::Table events_table(const Report& report, std::size_t rule) {
  result::Table table{.columns = {titled("event"), titled("events"), titled("false launches"),
                                  titled("false actuations"), titled("with one bad accelerometer")}};
  for (const Kind kind : report.campaign.kinds) {
    if (is_launch(kind)) {
      continue;
    }
    const Count& well = count_of(report, kind, rule, 0);
    const Sum bad = one_bad_of(*report.results.of_kind[index(kind)], rule);
    const double imagined =
        static_cast<double>(well.detected) / static_cast<double>(std::max<std::uint64_t>(1, well.events));
    table.rows.push_back({std::string{info(kind).name}, well.events,
                          Digits{fmt::format("{} ({} %)", well.detected, text::fixed(100.0 * imagined, 2))},
                          bad_if_any(well.controlling, well.events, report.campaign.rules[rule].judged),
                          bad.events == 0 ? "none"
                                          : fmt::format("of {}: false launches {}, false actuations {}", bad.events,
                                                        bad.detected, with_bound(bad.controlling, bad.events))});
  }
  return table;
}

result::Table events_by_condition(const Report& report, std::size_t rule) {
  result::Table table{.columns = {titled("event"), titled("accelerometers"), titled("events"), titled("false launches"),
                                  titled("false actuations"), titled("nearest to the gate")}};
  for (const Kind kind : report.campaign.kinds) {
    for (std::size_t condition = 0; condition < conditions && !is_launch(kind); ++condition) {
      const Count& count = count_of(report, kind, rule, condition);
      if (count.events > 0) {
        table.rows.push_back(
            {std::string{info(kind).name}, std::string{condition_names[condition]},
             Digits{.text = fmt::format("{}", count.events),
                    .below = count.flown > 0 ? fmt::format("{} more correctly controlled", count.flown) : ""},
             Digits{with_bound(count.detected, count.events)},
             bad_if_any(count.controlling, count.events, report.campaign.rules[rule].judged && condition == 0),
             Digits{.text = text::fixed(100.0 * count.worst.value, 0) + " %",
                    .below = count.worst.value > 0.0 ? fmt::format("event {}", count.worst.event) : ""}});
      }
    }
  }
  return table;
}

std::vector<std::string> about_flights(const Report& report, std::size_t rule) {
  std::vector<std::string> all;
  for (const Kind kind : report.campaign.kinds) {
    if (!is_flight(kind)) {
      continue;
    }
    std::uint64_t flown = 0;
    Histogram by_part;
    for (const Count& count : report.results.of_kind[index(kind)]->of_rule[rule]) {
      flown += count.flown;
      by_part.add(count.control_by_part);
    }
    all.push_back(
        fmt::format("{}: not counted, because this plan controls them correctly: {}.", info(kind).name, flown));
    std::string starts;
    for (const auto& [part, times] : by_part.counts()) {
      starts += fmt::format("{}{} {}", starts.empty() ? "" : ", ", part_names[static_cast<std::size_t>(part)], times);
    }
    if (!starts.empty()) {
      all.push_back(fmt::format("False actuations by part, accelerometers healthy or not: {}.", starts));
    }
  }
  return all;
}

result::Table launches_table(const Report& report, std::size_t rule) {
  result::Table table{.columns = {titled("launch"), titled("accelerometers"), titled("launches"), titled("missed"),
                                  titled("never controlled"), titled("latency, ms"), titled("control start, ms"),
                                  titled("distance, m"), titled("error, m"), titled("in guide"),
                                  titled("tilt error, deg")}};
  for (const Kind kind : report.campaign.kinds) {
    for (std::size_t condition = 0; condition < conditions && is_launch(kind); ++condition) {
      const Count& count = count_of(report, kind, rule, condition);
      if (count.events == 0) {
        continue;
      }
      table.rows.push_back(
          {std::string{info(kind).name}, std::string{condition_names[condition]}, count.events,
           Digits{.text = with_bound(count.events - count.detected, count.events),
                  .below = fmt::format("worst: event {}", count.worst.event)},
           count.detected - count.controlling, two_points(count.latency_ms, 1.0, 0),
           two_points(count.control_ms, 1.0, 0), three_points(count.distance_cm), three_points(count.error_cm),
           Digits{fmt::format("{}", count.inside_guide),
                  count.inside_guide > 0  ? result::Answer::no
                  : count.controlling > 0 ? result::Answer::yes
                                          : result::Answer::undecided,
                  count.controlling > 0 ? bound_text(count.inside_guide, count.controlling) : "none was controlled"},
           two_points(count.tilt_error_ddeg, 0.1, 1)});
    }
  }
  return table;
}

std::vector<std::string> about_launches(const Report& report, std::size_t rule) {
  std::vector<std::string> all;
  for (const Kind kind : report.campaign.kinds) {
    const Count& count = count_of(report, kind, rule, 0);
    for (const std::string& line : {by_thrust(count), time_still_sentence(count)}) {
      if (is_launch(kind) && !line.empty()) {
        all.push_back(fmt::format("{}: {}", info(kind).name, line));
      }
    }
  }
  return all;
}

std::vector<std::string> sum_lines(const Report& report) {
  std::vector<std::string> all;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const Sum well = well_events_of(report.results, rule);
    const Sum bad = bad_events_of(report.results, rule);
    const Sum launches = launches_of(report.results, rule);
    all.push_back(
        fmt::format("{}: {} events, false actuations {}; {} with one bad accelerometer, false actuations {}; {} "
                    "launches, missed {}",
                    report.campaign.rules[rule].name(), well.events, with_bound(well.controlling, well.events),
                    bad.events, with_bound(bad.controlling, bad.events), launches.events,
                    with_bound(launches.events - launches.detected, launches.events)));
  }
  return all;
}

result::Table models(const Report& report) {
  result::Table table{.columns = {titled("kind"), titled("what happens"), titled("source"), titled("weakness")}};
  for (const Kind kind : report.campaign.kinds) {
    const KindInfo& of = info(kind);
    table.rows.push_back(
        {std::string{of.name}, std::string{of.what}, std::string{of.source}, std::string{of.weakness}});
  }
  return table;
}

}  // namespace fantail::detection
