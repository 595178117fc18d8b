// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "detection/report.hpp"
#include "text/number.hpp"

// What is asked of a rule, and what came of it.
namespace fantail::detection {
namespace {

constexpr std::array<Kind, 3> launches_of_well{Kind::launch, Kind::launch_at_2_g, Kind::stirred_launch};

void add(Sum& sum, const Count& count) {
  sum.events += count.events;
  sum.detected += count.detected;
  sum.controlling += count.controlling;
}

std::string percent(double share) { return text::brief(100.0 * share, 6) + " %"; }

/// A bound of all kinds together says little of the one that comes near.
std::string of_worst_kind(const Report& report, std::size_t rule) {
  const std::optional<Kind> kind = worst_kind_of(report, rule);
  if (!kind) {
    return {};
  }
  const Count& count = report.results.of_kind[index(*kind)]->of_rule[rule][0];
  return fmt::format("; worst kind alone: {}, {} in {}", info(*kind).name, with_bound(count.controlling, count.events),
                     count.events);
}

Requirement no_false_actuation(const Report& report, std::size_t rule) {
  const std::string name = report.campaign.rules[rule].name();
  const Sum events = well_events_of(report.results, rule);
  if (events.events == 0) {
    return {.sentence = name + ": no event other than launches was played with both accelerometers healthy"};
  }
  const bool is_asked = report.false_at_most.has_value();
  // Nothing in a handful of events says nothing.
  constexpr double says_nothing = 0.1;
  const double bound = upper_bound_95(events.controlling, events.events);
  if (events.controlling == 0 && !is_asked && bound > says_nothing) {
    return {.sentence = fmt::format("{}: false actuations {} in {} with both accelerometers healthy: too few to judge",
                                    name, with_bound(0, events.events), text::counted(events.events, "event"))};
  }
  const bool is_met = is_asked ? bound <= *report.false_at_most : events.controlling == 0;
  return {.verdict = is_met ? Verdict::met : Verdict::not_met,
          .sentence =
              fmt::format("{}: false actuations {} in {} with both accelerometers healthy{}{}", name,
                          with_bound(events.controlling, events.events), text::counted(events.events, "event"),
                          is_asked ? "; required: at most " + percent(*report.false_at_most) + " over all kinds" : "",
                          of_worst_kind(report, rule))};
}

Requirement launches_missed(const Report& report, std::size_t rule) {
  const std::string name = report.campaign.rules[rule].name();
  const Sum launches = launches_of(report.results, rule);
  if (launches.events == 0) {
    return {.sentence = name + ": no launch was played with both accelerometers healthy"};
  }
  const std::uint64_t missed = launches.events - launches.detected;
  const bool is_met = upper_bound_95(missed, launches.events) <= *report.at_most;
  const bool may_be = static_cast<double>(missed) <= *report.at_most * static_cast<double>(launches.events);
  return {.verdict = is_met ? Verdict::met : Verdict::not_met,
          .sentence = fmt::format("{}: missed {} of {} launches; required: at most {}{}", name,
                                  with_bound(missed, launches.events), launches.events, percent(*report.at_most),
                                  !is_met && may_be ? "; more launches may show that it is met" : "")};
}

/// Of flights that come down, one accelerometer bad.
Sum bad_flights_of(const Results& results, std::size_t rule) {
  Sum sum;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    if (results.of_kind[kind] && is_flight(static_cast<Kind>(kind))) {
      const Sum one_bad = one_bad_of(*results.of_kind[kind], rule);
      sum.events += one_bad.events;
      sum.controlling += one_bad.controlling;
    }
  }
  return sum;
}

bool judges(const Campaign& campaign, bool launches) {
  return std::ranges::any_of(campaign.rules, &Rule::judged) && std::ranges::any_of(campaign.kinds, [&](Kind kind) {
           return campaign.number_of(kind) > 0 && is_launch(kind) == launches && kind != Kind::launch_one_bad &&
                  kind != Kind::raised_rail;
         });
}

}  // namespace

Sum one_bad_of(const Tally& tally, std::size_t rule) {
  Sum sum;
  for (std::size_t condition = 1; condition < conditions; ++condition) {
    add(sum, tally.of_rule[rule][condition]);
  }
  return sum;
}

Sum events_of(const Results& results, std::size_t rule) {
  Sum sum;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    if (results.of_kind[kind] && !is_launch(static_cast<Kind>(kind))) {
      for (const Count& count : results.of_kind[kind]->of_rule[rule]) {
        add(sum, count);
      }
    }
  }
  return sum;
}

Sum well_events_of(const Results& results, std::size_t rule) {
  Sum sum;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    if (results.of_kind[kind] && !is_launch(static_cast<Kind>(kind))) {
      add(sum, results.of_kind[kind]->of_rule[rule][0]);
    }
  }
  return sum;
}

std::optional<Kind> worst_kind_of(const Report& report, std::size_t rule) {
  std::optional<Kind> worst;
  std::pair<double, float> most{};
  std::size_t played = 0;
  for (const Kind kind : report.campaign.kinds) {
    const auto& tally = report.results.of_kind[index(kind)];
    if (is_launch(kind) || !tally || tally->of_rule[rule][0].events == 0) {
      continue;
    }
    const Count& count = tally->of_rule[rule][0];
    const std::pair<double, float> bad{upper_bound_95(count.controlling, count.events), count.worst.value};
    ++played;
    if (!worst || bad > most) {
      worst = kind;
      most = bad;
    }
  }
  return played > 1 ? worst : std::nullopt;
}

Sum bad_events_of(const Results& results, std::size_t rule) {
  const Sum all = events_of(results, rule);
  const Sum well = well_events_of(results, rule);
  return {.events = all.events - well.events,
          .detected = all.detected - well.detected,
          .controlling = all.controlling - well.controlling};
}

Sum launches_of(const Results& results, std::size_t rule) {
  Sum sum;
  for (const Kind kind : launches_of_well) {
    if (results.of_kind[index(kind)]) {
      add(sum, results.of_kind[index(kind)]->of_rule[rule][0]);
    }
  }
  return sum;
}

const char* name(Verdict verdict) {
  return verdict == Verdict::met ? "met" : verdict == Verdict::not_met ? "not met" : "not judged";
}

std::vector<Requirement> requirements(const Report& report) {
  std::vector<Requirement> all;
  for (std::size_t rule = 0; rule < report.campaign.rules.size(); ++rule) {
    if (report.campaign.rules[rule].judged) {
      all.push_back(no_false_actuation(report, rule));
      if (report.at_most) {
        all.push_back(launches_missed(report, rule));
      }
    }
  }
  return all;
}

Verdict verdict(const std::vector<Requirement>& requirements) {
  const auto any = [&](Verdict one) {
    return std::ranges::find(requirements, one, &Requirement::verdict) != requirements.end();
  };
  return any(Verdict::not_met) ? Verdict::not_met : any(Verdict::met) ? Verdict::met : Verdict::not_judged;
}

std::vector<std::string> failures(const Report& report) {
  std::vector<std::string> sentences;
  for (const Requirement& requirement : requirements(report)) {
    if (requirement.verdict == Verdict::not_met) {
      sentences.push_back(requirement.sentence);
    }
  }
  return sentences;
}

std::vector<std::string> known_limits(const Report& report) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < report.campaign.rules.size(); ++i) {
    const Rule& rule = report.campaign.rules[i];
    if (!rule.judged) {
      continue;
    }
    const Sum flights = bad_flights_of(report.results, i);
    if (flights.controlling > 0) {
      sentences.push_back(fmt::format(
          "{}: false actuations {} in {} recoveries with one bad accelerometer, after an uncontrolled flight",
          rule.name(), with_bound(flights.controlling, flights.events), flights.events));
    }
    Sum bad = bad_events_of(report.results, i);
    bad.events -= flights.events;
    bad.controlling -= flights.controlling;
    if (bad.controlling > 0) {
      const bool is_one = rule.plan.launch_detection.accelerometers == core::AccelerometerRule::one;
      sentences.push_back(fmt::format(
          "{}: false actuations {} in {} events with one bad accelerometer: {}", rule.name(),
          with_bound(bad.controlling, bad.events), bad.events,
          is_one ? "it relies on one accelerometer alone"
                 : "a reading that stands still briefly agrees with one that is shaken, and then looks like thrust"));
    }
  }
  return sentences;
}

bool judges_launches(const Campaign& campaign) { return judges(campaign, true); }

bool judges_events(const Campaign& campaign) { return judges(campaign, false); }

result::Answer answer_of(Verdict verdict) {
  return verdict == Verdict::met       ? result::Answer::yes
         : verdict == Verdict::not_met ? result::Answer::no
                                       : result::Answer::undecided;
}

std::string what_was_judged(const Report& report, Verdict verdict) {
  if (std::ranges::none_of(report.campaign.rules, &Rule::judged)) {
    return "No plan that is judged was played.";
  }
  if (verdict == Verdict::not_met) {
    return "At least one judged plan failed a requirement, or was played too rarely to show that it meets it.";
  }
  const std::size_t kinds_of_event = static_cast<std::size_t>(
      std::ranges::count_if(report.campaign.kinds, [](Kind kind) { return !is_launch(kind); }));
  const auto judged = std::ranges::find_if(report.campaign.rules, &Rule::judged) - report.campaign.rules.begin();
  const std::uint64_t events = well_events_of(report.results, static_cast<std::size_t>(judged)).events;
  std::string text = events == 0
                         ? std::string{"No event other than launches was played with both accelerometers healthy."}
                         : fmt::format("{} of {} that are not launches, both accelerometers healthy: {}.",
                                       text::counted(events, "event"), text::counted(kinds_of_event, "kind"),
                                       report.false_at_most > 0.0 ? "no more false actuations than permitted"
                                                                  : "no judged plan moved a canard");
  if (const std::optional<Kind> kind = worst_kind_of(report, static_cast<std::size_t>(judged))) {
    const Count& count = report.results.of_kind[index(*kind)]->of_rule[static_cast<std::size_t>(judged)][0];
    const Sum all = well_events_of(report.results, static_cast<std::size_t>(judged));
    text +=
        fmt::format(" {}: the worst kind is {}, {} of {}; all kinds together: {}.",
                    report.campaign.rules[static_cast<std::size_t>(judged)].name(), info(*kind).name,
                    with_bound(count.controlling, count.events), count.events, with_bound(all.controlling, all.events));
  }
  if (report.at_most && verdict == Verdict::met) {
    text += " No more launches were missed than permitted.";
  }
  return text;
}

}  // namespace fantail::detection
