// SPDX-License-Identifier: MIT
#include "detection/report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "text/layout.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::detection {
namespace {

std::string events_table(const Report& report, std::size_t rule, std::size_t columns) {
  text::Table table{
      {{"event"}, {"events"}, {"launch imagined"}, {"false actuations"}, {"with one accelerometer bad", 1}}};
  const auto row = [&table](const auto& event, const auto& events, const auto& imagined, const auto& false_ones,
                            const auto& of_bad) {
    table.row({fmt::format("  {:<19}", event), fmt::format(" {:>9}", events), fmt::format(" {:>18}", imagined),
               fmt::format(" {:>26}", false_ones), fmt::format("   {}", of_bad)});
  };
  row("event", "events", "launch imagined", "false actuations", "with one accelerometer bad");
  for (const Kind kind : report.campaign.kinds) {
    if (is_launch(kind)) {
      continue;
    }
    const Tally& tally = *report.results.of_kind[index(kind)];
    const Count& well = tally.of_rule[rule][0];
    const Sum bad = one_bad_of(tally, rule);
    const std::string of_bad = bad.events == 0 ? "none"
                                               : fmt::format("of {}: imagined {}, false actuations {}", bad.events,
                                                             bad.detected, with_bound(bad.controlling, bad.events));
    row(info(kind).name, well.events,
        fmt::format("{} ({} %)", well.detected,
                    text::fixed(100.0 * static_cast<double>(well.detected) /
                                    static_cast<double>(std::max<std::uint64_t>(1, well.events)),
                                2)),
        with_bound(well.controlling, well.events), of_bad);
  }
  return table.text(columns);
}

std::string in_units(const std::optional<int>& value, double scale, int decimals) {
  return value ? text::fixed(scale * *value, decimals) : "-";
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
                      : fmt::format("    by peak thrust over weight, missed and later than {} ms: {}\n", late_ms, text);
}

/// Of flights that come down: how many were none, and in which part control started.
std::string flight_lines(const Report& report, std::size_t rule) {
  std::string text;
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
    text +=
        fmt::format("  {}: not counted, because this plan controls them as it should: {}\n", info(kind).name, flown);
    std::string starts;
    for (const auto& [part, times] : by_part.counts()) {
      starts += fmt::format("{}{} {}", starts.empty() ? "" : ", ", part_names[static_cast<std::size_t>(part)], times);
    }
    text += starts.empty() ? "" : fmt::format("    false actuations by part, accelerometers well or not: {}\n", starts);
  }
  return text;
}

/// Of rails that were raised: by the seconds from then to ignition.
std::string by_time_still(const Count& count) {
  std::string text;
  for (const auto& [still_s, all] : count.all_by_still_s.counts()) {
    text += fmt::format("{}{} s {} and {} of {}", text.empty() ? "" : "; ", still_s,
                        count.missed_by_still_s.times(still_s), count.tilted_by_still_s.times(still_s), all);
  }
  return text.empty() ? text
                      : fmt::format("    by whole seconds still, missed and tilt off by more than {} deg: {}\n",
                                    tilted_ddeg / 10, text);
}

std::string launch_lines(const Report& report, std::size_t rule) {
  std::string text;
  for (const Kind kind : report.campaign.kinds) {
    if (!is_launch(kind)) {
      continue;
    }
    const Tally& tally = *report.results.of_kind[index(kind)];
    for (std::size_t condition = 0; condition < conditions; ++condition) {
      const Count& count = tally.of_rule[rule][condition];
      if (count.events == 0) {
        continue;
      }
      text += fmt::format("  {}, {}: of {} missed {}; detected but never controlled {}\n", info(kind).name,
                          condition_names[condition], count.events,
                          with_bound(count.events - count.detected, count.events), count.detected - count.controlling);
      if (count.controlling > 0) {
        text += fmt::format(
            "    detected {} ms after the thrust's first crossing (99 %: {}); control starts {} ms after ignition "
            "(99 %: {}), {} m along the guide (1 to 99 %: {} to {}), by an estimate that is off by {} m ({} to {}); "
            "inside the guide {}; tilt off by {} deg (99 %: {})\n",
            in_units(count.latency_ms.point(0.5), 1.0, 0), in_units(count.latency_ms.point(0.99), 1.0, 0),
            in_units(count.control_ms.point(0.5), 1.0, 0), in_units(count.control_ms.point(0.99), 1.0, 0),
            in_units(count.distance_cm.point(0.5), 0.01, 2), in_units(count.distance_cm.point(0.01), 0.01, 2),
            in_units(count.distance_cm.point(0.99), 0.01, 2), in_units(count.error_cm.point(0.5), 0.01, 2),
            in_units(count.error_cm.point(0.01), 0.01, 2), in_units(count.error_cm.point(0.99), 0.01, 2),
            count.inside_guide, in_units(count.tilt_error_ddeg.point(0.5), 0.1, 1),
            in_units(count.tilt_error_ddeg.point(0.99), 0.1, 1));
      }
      text += condition == 0 ? by_thrust(count) + by_time_still(count) : "";
    }
  }
  return text;
}

/// All of it in one line, for scripts too.
std::string sum_line(const Report& report, std::size_t rule) {
  const Sum well = well_events_of(report.results, rule);
  const Sum bad = bad_events_of(report.results, rule);
  const Sum launches = launches_of(report.results, rule);
  return fmt::format(
      "{}: {} events, false actuations {}; {} with one accelerometer bad, false actuations {}; {} launches, missed "
      "{}\n",
      report.campaign.rules[rule].name(), well.events, with_bound(well.controlling, well.events), bad.events,
      with_bound(bad.controlling, bad.events), launches.events,
      with_bound(launches.events - launches.detected, launches.events));
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

std::string report_text(const Report& report, std::size_t columns) {
  const Campaign& campaign = report.campaign;
  std::string text =
      fmt::format("{} events, seed {}; shares \"at most\" are 95 % bounds\n", campaign.total(), campaign.seed);
  for (std::size_t rule = 0; rule < campaign.rules.size(); ++rule) {
    text +=
        fmt::format("\n{}{}\n", campaign.rules[rule].name(), campaign.rules[rule].judged ? "" : " (shown, not judged)");
    const bool any_event = std::ranges::any_of(campaign.kinds, [](Kind kind) { return !is_launch(kind); });
    text += any_event ? events_table(report, rule, columns) + flight_lines(report, rule) : "";
    text += launch_lines(report, rule);
  }
  text += '\n';
  for (std::size_t rule = 0; rule < campaign.rules.size(); ++rule) {
    text += sum_line(report, rule);
  }
  if (report.results.played > 0 && report.results.processor_s > 0.0) {
    text += fmt::format("played now: {} events, {:.0f} a second and core\n", report.results.played,
                        static_cast<double>(report.results.played) / report.results.processor_s);
  }
  for (const Requirement& requirement : requirements(report)) {
    text += fmt::format("{}: {}\n", name(requirement.verdict), requirement.sentence);
  }
  text += std::ranges::none_of(campaign.rules, &Rule::judged) ? "not judged: no plan was played that is judged\n" : "";
  for (const std::string& limit : known_limits(report)) {
    text += "known limit: " + limit + '\n';
  }
  return text;
}

}  // namespace fantail::detection
