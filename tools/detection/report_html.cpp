// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "detection/bounds_chart.hpp"
#include "detection/report.hpp"
#include "detection/shown_event.hpp"
#include "page/chart.hpp"
#include "page/page.hpp"
#include "text/number.hpp"

namespace fantail::detection {
namespace {

page::Cell number_cell(std::uint64_t value) { return {.text = fmt::format("{}", value)}; }

/// Any is bad where it is judged.
page::Cell bad_if_any(std::uint64_t count, std::uint64_t of, bool judged) {
  return {.text = with_bound(count, of),
          .tone = count == 0 ? page::Tone::good
                  : judged   ? page::Tone::bad
                             : page::Tone::unsure};
}

std::string events_html(const Report& report, std::size_t rule) {
  const std::array<page::Column, 6> columns{{{"event"},
                                             {"accelerometers"},
                                             {"events", true},
                                             {"launch imagined", true},
                                             {"false actuations", true},
                                             {"nearest to the gate", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Kind kind : report.campaign.kinds) {
    for (std::size_t condition = 0; condition < conditions && !is_launch(kind); ++condition) {
      const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][condition];
      if (count.events > 0) {
        rows.push_back(
            {{std::string{info(kind).name}},
             {std::string{condition_names[condition]}},
             {.text = fmt::format("{}", count.events),
              .below = count.flown > 0 ? fmt::format("{} more controlled as they should be", count.flown) : ""},
             {with_bound(count.detected, count.events)},
             bad_if_any(count.controlling, count.events, report.campaign.rules[rule].judged && condition == 0),
             {.text = text::fixed(100.0 * count.worst.value, 0) + " %",
              .below = count.worst.value > 0.0 ? fmt::format("event {}", count.worst.event) : std::string{}}});
      }
    }
  }
  return rows.empty() ? "" : page::table(columns, rows);
}

std::string point_text(const Histogram& histogram, double share, double scale, int decimals) {
  const auto point = histogram.point(share);
  return point ? text::fixed(scale * *point, decimals) : "-";
}

std::string launches_html(const Report& report, std::size_t rule) {
  const std::array<page::Column, 7> columns{{{"launch"},
                                             {"launches", true},
                                             {"missed", true},
                                             {"latency / ms", true},
                                             {"way / m", true},
                                             {"error / m", true},
                                             {"in guide", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Kind kind : report.campaign.kinds) {
    for (std::size_t condition = 0; condition < conditions && is_launch(kind); ++condition) {
      const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][condition];
      if (count.events > 0) {
        const auto three = [](const Histogram& of) {
          return fmt::format("{}, {}, {}", point_text(of, 0.01, 0.01, 1), point_text(of, 0.5, 0.01, 1),
                             point_text(of, 0.99, 0.01, 1));
        };
        rows.push_back({{.text = std::string{info(kind).name}, .below = std::string{condition_names[condition]}},
                        number_cell(count.events),
                        {.text = with_bound(count.events - count.detected, count.events),
                         .below = fmt::format("worst: event {}", count.worst.event)},
                        {fmt::format("{}, {}", point_text(count.latency_ms, 0.5, 1.0, 0),
                                     point_text(count.latency_ms, 0.99, 1.0, 0))},
                        {three(count.distance_cm)},
                        {three(count.error_cm)},
                        {.text = fmt::format("{}", count.inside_guide),
                         .tone = count.inside_guide > 0  ? page::Tone::bad
                                 : count.controlling > 0 ? page::Tone::good
                                                         : page::Tone::unsure,
                         .below = count.controlling > 0 ? bound_text(count.inside_guide, count.controlling)
                                                        : "none was controlled"}});
      }
    }
  }
  return rows.empty()
             ? ""
             : page::table(columns, rows) +
                   page::note(
                       "Latency: from the thrust's first crossing of the threshold, of 50 and 99 % of the launches. "
                       "Way: the true one along the guide at control start, and error what the estimate has more than "
                       "that; of 1, 50 and 99 %. In guide: control starts while the rocket truly is in it.");
}

page::Series shares(const Histogram& histogram, double scale, std::string name, page::Role role) {
  page::Series series{.name = std::move(name), .role = role, .mark = page::Mark::step};
  std::uint64_t sum = 0;
  const auto total = static_cast<double>(histogram.total());
  for (const auto& [value, times] : histogram.counts()) {
    sum += times;
    series.x.push_back(scale * value);
    series.y.push_back(100.0 * static_cast<double>(sum) / total);
  }
  return series;
}

page::Chart by_thrust_chart(const Report& report, Kind kind) {
  page::Chart chart{.label = "Share of the launches that are missed or late, by their thrust",
                    .x_label = "peak thrust over weight / g",
                    .y_label = "missed or late / %"};
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][0];
    page::Series series{.name = report.campaign.rules[rule].name(),
                        .role = roles[rule % roles.size()],
                        .mark = page::Mark::line_and_points};
    for (const auto& [peak_g, all] : count.all_by_peak_g.counts()) {
      const std::uint64_t bad = count.missed_by_peak_g.times(peak_g) + count.late_by_peak_g.times(peak_g);
      series.x.push_back(peak_g + 0.5);
      series.y.push_back(100.0 * static_cast<double>(bad) / static_cast<double>(all));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// Four times the least median: what lies far beyond is rare, and would leave no room for the rest.
std::optional<page::Range> most_of(const std::vector<double>& medians) {
  const double least = medians.empty() ? 0.0 : std::ranges::min(medians);
  return least > 0.0 ? std::optional<page::Range>{{0.0, 4.0 * least}} : std::nullopt;
}

/// Of all rules beside each other, the launches of one kind.
std::string distributions(const Report& report, Kind kind) {
  page::Chart latency{.label = "Share of the launches detected within a time",
                      .x_label = "after the thrust's first crossing / s",
                      .y_label = "detected / %",
                      .width = page::half_page};
  page::Chart way{.label = "Share of the launches whose control has started within a way",
                  .x_label = "true way along the guide / m",
                  .y_label = "in control / %",
                  .width = page::half_page};
  std::vector<double> latencies;
  std::vector<double> ways;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const Count& count = report.results.of_kind[index(kind)]->of_rule[rule][0];
    if (count.controlling > 0) {
      const std::string name = report.campaign.rules[rule].name();
      latencies.push_back(1e-3 * count.latency_ms.point(0.5).value_or(0));
      ways.push_back(1e-2 * count.distance_cm.point(0.5).value_or(0));
      latency.series.push_back(shares(count.latency_ms, 1e-3, name, roles[rule % roles.size()]));
      way.series.push_back(shares(count.distance_cm, 1e-2, name, roles[rule % roles.size()]));
    }
  }
  if (latency.series.empty()) {
    return {};
  }
  latency.x_range = most_of(latencies);
  way.x_range = most_of(ways);
  const std::array<std::string, 2> plots{page::figure(latency), page::figure(way)};
  return page::section(fmt::format("How late: {}", info(kind).name),
                       page::side_by_side(plots) + page::figure(by_thrust_chart(report, kind)));
}

/// The event of a judged rule that came nearest to moving a canard, and the worst launch.
std::string worst_events(const Report& report) {
  std::string body;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    std::optional<Kind> worst;
    Worst at;
    for (const Kind kind : report.campaign.kinds) {
      for (const Count& count : report.results.of_kind[index(kind)]->of_rule[rule]) {
        if (!is_launch(kind) && count.events > 0 && count.worst.value > std::max(0.0, at.value)) {
          worst = kind;
          at = count.worst;
        }
      }
    }
    if (worst) {
      const ShownEvent shown = show_event(report.campaign, *worst, at.event);
      body += page::section(
          fmt::format("Worst event of {}", report.campaign.rules[rule].name()),
          page::paragraph(command_of(report.campaign, *worst, at.event)) + sentences_html(shown) + shown.figures_html);
    }
  }
  return body;
}

std::string models(const Report& report) {
  const std::array<page::Column, 4> columns{{{"kind"}, {"what happens"}, {"source"}, {"weakness"}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const Kind kind : report.campaign.kinds) {
    const KindInfo& of = info(kind);
    rows.push_back(
        {{std::string{of.name}}, {std::string{of.what}}, {std::string{of.source}}, {std::string{of.weakness}}});
  }
  return page::section("Models", page::table(columns, rows));
}

}  // namespace

result::Answer answer(Verdict verdict) {
  return verdict == Verdict::met       ? result::Answer::yes
         : verdict == Verdict::not_met ? result::Answer::no
                                       : result::Answer::undecided;
}

std::string what_was_judged(const Report& report, Verdict verdict) {
  if (std::ranges::none_of(report.campaign.rules, &Rule::judged)) {
    return "No plan was played that is judged.";
  }
  if (verdict == Verdict::not_met) {
    return "At least one judged plan did what it must not.";
  }
  const std::size_t kinds_of_event = static_cast<std::size_t>(
      std::ranges::count_if(report.campaign.kinds, [](Kind kind) { return !is_launch(kind); }));
  const auto judged = std::ranges::find_if(report.campaign.rules, &Rule::judged) - report.campaign.rules.begin();
  const std::uint64_t events = well_events_of(report.results, static_cast<std::size_t>(judged)).events;
  std::string text = events == 0
                         ? std::string{"No event that is no launch was played with both accelerometers well."}
                         : fmt::format("{} events of {} kinds that are no launch, both accelerometers well: {}.",
                                       events, kinds_of_event,
                                       report.false_at_most > 0.0 ? "no more false actuations than asked for"
                                                                  : "no judged plan moved a canard");
  if (const std::optional<Kind> kind = worst_kind_of(report, static_cast<std::size_t>(judged))) {
    const Count& count = report.results.of_kind[index(*kind)]->of_rule[static_cast<std::size_t>(judged)][0];
    const Sum all = well_events_of(report.results, static_cast<std::size_t>(judged));
    text +=
        fmt::format(" {}: of the worst kind, {}, {} of {}; of all kinds together {}.",
                    report.campaign.rules[static_cast<std::size_t>(judged)].name(), info(*kind).name,
                    with_bound(count.controlling, count.events), count.events, with_bound(all.controlling, all.events));
  }
  if (report.at_most && verdict == Verdict::met) {
    text += " No more launches missed than asked for.";
  }
  return text;
}

namespace {}  // namespace

std::string report_html(const Report& report) {
  const std::string bounds = bounds_svg(report, page::full_page);
  std::string body = bounds.empty() ? ""
                                    : page::section("Events that are no launch, both accelerometers well",
                                                    page::figure(bounds, bounds_svg(report, page::half_page), ""));
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    const std::string shown = report.campaign.rules[rule].judged ? "" : " (shown, not judged)";
    body += page::section(report.campaign.rules[rule].name() + shown,
                          events_html(report, rule) + launches_html(report, rule));
  }
  for (const Kind kind : {Kind::launch, Kind::launch_at_2_g}) {
    body += report.results.of_kind[index(kind)] ? distributions(report, kind) : "";
  }
  const std::vector<Requirement> asked = requirements(report);
  const Verdict came = verdict(asked);
  page::Page page{
      .kind = "Fantail campaign of detections",
      .title = "Does it believe that it flies?",
      .subtitle = fmt::format("{} events and launches, seed {}", report.campaign.total(), report.campaign.seed),
      .tone = result::tone(answer(came)),
      .verdict_heading = came == Verdict::met       ? "Met"
                         : came == Verdict::not_met ? "Not met"
                                                    : "Not judged",
      .verdict = what_was_judged(report, came),
      .body_html = body + worst_events(report) + models(report),
      .footer = "Shares \"at most\" are 95 % bounds (Clopper and Pearson, one-sided). Fantail " + report.version};
  for (const Requirement& requirement : asked) {
    page.findings.push_back({.what = fmt::format("{}: ", name(requirement.verdict)), .about = requirement.sentence});
  }
  for (const std::string& limit : known_limits(report)) {
    page.findings.push_back({.what = "known limit, not judged: ", .about = limit});
  }
  return page::html(page);
}

}  // namespace fantail::detection
