// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <fmt/format.h>

#include "detection/rehearsal.hpp"
#include "detection/report.hpp"
#include "page/chart.hpp"
#include "sim/units.hpp"
#include "text/number.hpp"

namespace fantail::detection {
namespace {

double seconds(std::size_t step) { return 1e-3 * static_cast<double>(step); }

/// The first of a rule's plans stands for them all.
std::string short_name(const Rule& rule) { return rule.names.front() + (rule.names.size() > 1 ? " ..." : ""); }

/// A line across, named by its plan; those of several plans at one value are one line.
void add_level(page::Chart& chart, double value, const std::string& what, const Rule& rule) {
  const auto same = std::ranges::find(chart.levels, value, &page::Level::value);
  if (same != chart.levels.end()) {
    same->label += ", " + short_name(rule);
  } else {
    chart.levels.push_back({.value = value, .label = what + " of " + short_name(rule), .role = page::Role::limit});
  }
}

/// Beyond both lines of the gate control may begin.
void add_gates(page::Chart& speed, page::Chart& way, const std::vector<Rule>& rules) {
  for (const Rule& rule : rules) {
    const core::GuidePlan& guide = rule.plan.guide;
    if (guide.minimum_speed_m_s > 0.0F) {
      add_level(speed, static_cast<double>(guide.minimum_speed_m_s), "gate", rule);
    }
    add_level(way, static_cast<double>(guide.length_m + guide.clearance_m), "gate", rule);
  }
}

std::string names_of(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, "; ")); }

/// Who does what, first those of whom it is bad.
void judge(ShownEvent& shown, Kind kind, const std::vector<Rule>& rules, const std::vector<Answer>& answers,
           bool both_well) {
  const bool launch = is_launch(kind);
  std::vector<std::string> do_it;
  std::vector<std::string> do_not;
  std::vector<std::string> fly_it;
  for (std::size_t rule = 0; rule < rules.size(); ++rule) {
    if (answers[rule].flown) {
      fly_it.push_back(rules[rule].name());
      continue;
    }
    const bool does = launch ? answers[rule].detected.has_value() : answers[rule].controlling.has_value();
    (does ? do_it : do_not).push_back(rules[rule].name());
    shown.is_bad = shown.is_bad || (rules[rule].judged && both_well && does != launch);
  }
  if (launch) {
    shown.verdict = do_not.empty()  ? "Every plan detects this launch."
                    : do_it.empty() ? "No plan detects this launch."
                                    : fmt::format("Detected by {}; missed by {}.", names_of(do_it), names_of(do_not));
    return;
  }
  const char* const what = is_flight(kind) ? "This is the end of a flight" : "This is not a launch";
  if (do_it.empty() || (do_not.empty() && fly_it.empty())) {
    shown.verdict = do_it.empty() ? fmt::format("{}, and no plan moves a canard.", what)
                                  : fmt::format("{}, and every plan moves the canards.", what);
  } else {
    shown.verdict = fmt::format("{}. The canards are moved by {}{}.", what, names_of(do_it),
                                do_not.empty() ? "" : "; not by " + names_of(do_not));
  }
  if (!fly_it.empty()) {
    shown.verdict += fmt::format(" Its launch is correctly detected and controlled by {}.", names_of(fly_it));
  }
}

page::Chart readings_chart(const Rehearsal& rehearsal, const std::vector<Rule>& rules) {
  page::Chart chart{.label = "Specific force along the axis as the accelerometers read it",
                    .x_label = "time / s",
                    .y_label = "axial specific force / g"};
  for (std::size_t which = 0; which < 2; ++which) {
    page::Series series{.name = which == 0 ? "first accelerometer" : "second accelerometer", .role = roles[which]};
    for (std::size_t i = 0; i < rehearsal.motion().length; ++i) {
      const bool measures = rehearsal.readings().quality[which][i] != core::SampleQuality::absent;
      series.x.push_back(seconds(i));
      series.y.push_back(measures ? static_cast<double>(rehearsal.readings().axial_m_s2[which][i]) / sim::gravity_m_s2
                                  : std::numeric_limits<double>::quiet_NaN());
    }
    chart.series.push_back(std::move(series));
  }
  for (const Rule& rule : rules) {
    add_level(chart, static_cast<double>(rule.plan.launch_detection.threshold_m_s2) / sim::gravity_m_s2, "threshold",
              rule);
  }
  return chart;
}

std::string said(const Rule& rule, const Answer& answer, bool launch) {
  if (answer.flown) {
    return fmt::format("{}: correctly detects and controls this flight; the recovery is not played", rule.name());
  }
  if (!answer.detected) {
    return fmt::format("{}: no launch detected", rule.name());
  }
  std::string text = fmt::format("{}: launch detected at {} s", rule.name(), text::fixed(seconds(*answer.detected), 3));
  if (answer.controlling) {
    text += fmt::format(", control from {} s: the canards move", text::fixed(seconds(*answer.controlling), 3));
    if (launch) {
      text += fmt::format("; {} m along the guide, estimate off by {} m",
                          text::fixed(static_cast<double>(answer.distance_m), 2),
                          text::fixed(static_cast<double>(answer.distance_error_m), 2));
    }
    return text;
  }
  if (answer.nearness >= Answer::held_back) {
    return text + ", no control: the gate is open, but the accelerometers disagree";
  }
  return text +
         fmt::format(", no control: {} % of the gate", text::fixed(100.0 * static_cast<double>(answer.nearness), 0));
}

/// When each part of a flight that comes down begins; one that takes no time is left out.
std::string parts_line(const Motion& motion) {
  std::string text;
  for (std::size_t part = 0; part < flight_parts; ++part) {
    const std::size_t begin = motion.part_begin[part];
    if (begin < (part + 1 < flight_parts ? motion.part_begin[part + 1] : motion.length)) {
      text += fmt::format("{}{} {} s", text.empty() ? "parts begin: " : ", ", part_names[part],
                          text::fixed(seconds(begin), 3));
    }
  }
  return text;
}

}  // namespace

ShownEvent show_event(const Campaign& campaign, Kind kind, std::uint64_t event) {
  Rehearsal rehearsal{campaign.rules};
  page::Chart speed{
      .label = "Speed along the guide as each rule estimates it", .x_label = "time / s", .y_label = "speed / m/s"};
  page::Chart way{
      .label = "Distance along the guide as each rule estimates it", .x_label = "time / s", .y_label = "distance / m"};
  for (std::size_t rule = 0; rule < campaign.rules.size(); ++rule) {
    const page::Series series{.name = campaign.rules[rule].name(), .role = roles[rule % roles.size()]};
    speed.series.push_back(series);
    way.series.push_back(series);
  }
  rehearsal.on_tick = [&](std::size_t rule, std::size_t step, const core::TickRecord& record) {
    speed.series[rule].x.push_back(seconds(step));
    speed.series[rule].y.push_back(static_cast<double>(record.motion.speed_m_s));
    way.series[rule].x.push_back(seconds(step));
    way.series[rule].y.push_back(static_cast<double>(record.motion.distance_along_guide_m));
  };
  const std::vector<Answer> answers = rehearsal.play(campaign.seed, kind, event, Path::full);

  const SensorErrors& errors = rehearsal.readings().errors;
  ShownEvent shown;
  const auto say = [&shown](std::string sentence) { shown.sentences.push_back(std::move(sentence)); };
  say(fmt::format("{} {}, seed {}: {} s, {} deg from the vertical", info(kind).name, event, campaign.seed,
                  text::fixed(seconds(rehearsal.motion().length), 3),
                  text::fixed(rehearsal.motion().start_pitch_rad / sim::radians_per_degree, 1)));
  say(fmt::format("range of the kind, from which this event is drawn: {}", info(kind).what));
  if (is_flight(kind)) {
    say(parts_line(rehearsal.motion()));
  }
  say(errors.condition == Condition::well
          ? "both accelerometers healthy"
          : fmt::format("{}: the {} accelerometer, from {} s",
                        condition_names[static_cast<std::size_t>(errors.condition)],
                        errors.bad == 0 ? "first" : "second", text::fixed(seconds(errors.onset), 3)));
  say("gate: control may begin when the estimated distance along the guide exceeds the guide and a clearance, and the "
      "estimated speed reaches the minimum of the plan. The share of the gate is the smaller of the two");
  page::Chart readings = readings_chart(rehearsal, campaign.rules);
  for (std::size_t rule = 0; rule < campaign.rules.size(); ++rule) {
    say(said(campaign.rules[rule], answers[rule], is_launch(kind)));
    if (answers[rule].controlling) {
      readings.levels.push_back({.value = seconds(*answers[rule].controlling),
                                 .label = "control by " + short_name(campaign.rules[rule]),
                                 .upright = true,
                                 .role = page::Role::limit});
    }
  }
  add_gates(speed, way, campaign.rules);
  judge(shown, kind, campaign.rules, answers, errors.condition == Condition::well);
  shown.pictures = {result::Picture{readings}, result::Picture{speed}, result::Picture{way}};
  return shown;
}

result::Document event_answer(const Campaign& campaign, Kind kind, std::uint64_t event, const result::Made& made) {
  const ShownEvent shown = show_event(campaign, kind, event);
  return {.kind = "detection campaign",
          .title = fmt::format("{} {}", info(kind).name, event),
          .subtitle = command_of(campaign, kind, event),
          .verdict = {.answer = shown.is_bad ? result::Answer::no : result::Answer::none,
                      .heading = "Result",
                      .sentence = shown.verdict},
          .facts = {{"kind", "", info(kind).name}, {"event", "", event}, {"seed", "", campaign.seed}},
          .sections = {{"What happens", {result::Sentences{"what_happens", shown.sentences}}},
                       {"Force, speed and distance",
                        std::vector<result::Block>(shown.pictures.begin(), shown.pictures.end())}},
          .made = made};
}

std::optional<result::Section> worst_event(const Report& report, std::size_t rule) {
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
  if (!worst) {
    return {};
  }
  const ShownEvent shown = show_event(report.campaign, *worst, at.event);
  result::Section section{fmt::format("Worst event of {}", report.campaign.rules[rule].name()),
                          {command_of(report.campaign, *worst, at.event), result::Sentences{.all = shown.sentences}},
                          result::Readers::files};
  section.blocks.insert(section.blocks.end(), shown.pictures.begin(), shown.pictures.end());
  return section;
}

}  // namespace fantail::detection
