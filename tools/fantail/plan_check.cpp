// SPDX-License-Identifier: MIT
#include "fantail/plan_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "campaign/flown_run.hpp"
#include "fantail/command_line.hpp"
#include "fantail/deliver.hpp"
#include "fantail/plan_against_scenario.hpp"
#include "fantail/plan_outlook.hpp"
#include "fantail/plan_rules.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/terminal.hpp"
#include "fantail/weaker_plan.hpp"
#include "flight/flight.hpp"
#include "fly/fly_scenario.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "json/value.hpp"
#include "protocol/plan_block.hpp"
#include "stability/canard_sense.hpp"
#include "stability/margins_asked.hpp"
#include "stability/speed_range.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

constexpr double comfortable_rad = stability::comfortable_phase_margin_rad;

bool is_shipped(input::Shipped kind, const std::string& name) {
  const std::vector<std::string> all = input::shipped_names(kind);
  return std::ranges::find(all, name) != all.end();
}

/// The name of a shipped plan means the plan, whatever scenarios there are.
bool is_scenario(const std::string& name_or_path) {
  if (is_shipped(input::Shipped::plan, name_or_path)) {
    return false;
  }
  if (is_shipped(input::Shipped::scenario, name_or_path)) {
    return true;
  }
  const input::Document document = input::Document::load(input::find_input(input::Shipped::plan, name_or_path));
  return input::Section{document, ""}.has("plan");
}

struct Subject {
  std::string file{};  ///< of the plan, or of the scenario that has it
  core::FlightPlan plan{};
  std::optional<sim::Scenario> scenario{};
};

Subject subject(const PlanCheck& asked) {
  if (!asked.plan && !asked.scenario) {
    throw UsageError{"PLAN is missing; give it, or --scenario with its own plan"};
  }
  const bool has_plan = asked.plan && !is_scenario(*asked.plan);
  if (asked.plan && asked.scenario && !has_plan) {
    throw UsageError{*asked.plan + " is a scenario, and so is --scenario " + *asked.scenario + "; give one of them"};
  }
  Subject found;
  if (has_plan) {
    found.file = input::find_input(input::Shipped::plan, *asked.plan);
    found.plan = input::read_plan(input::Document::load(found.file));
  }
  if (const auto name = has_plan ? asked.scenario : asked.scenario ? asked.scenario : asked.plan) {
    found.scenario = load({.scenario = *name, .seed = {}, .changes = {}});
    const core::Start own_start = found.scenario->plan.run.start;
    if (has_plan && found.plan.run.start != own_start) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        fmt::format("{}: run.start is not \"{}\", as in the plan of {}", found.file,
                                    own_start == core::Start::launch ? "launch" : "tunnel", found.scenario->name)};
    }
    if (has_plan) {
      found.scenario->plan = found.plan;
    } else {
      found.file = input::find_input(input::Shipped::scenario, *name);
      found.plan = found.scenario->plan;
    }
  }
  return found;
}

/// Never more than it is.
std::string in_degrees(double margin_rad) {
  return text::brief(std::floor(10.0 * text::degrees(margin_rad) + 1e-6) / 10.0, 1) + " degrees";
}

std::string in_words(const stability::SpeedRange& range) {
  const std::string lowest = text::fixed(range.lowest_m_s, 0);
  const std::string highest = text::fixed(range.highest_m_s, 0);
  return lowest == highest ? "at " + lowest + " m/s" : fmt::format("from {} to {} m/s", lowest, highest);
}

std::string gains(const core::FlightPlan& plan) {
  const auto number = [](float value) { return text::brief(static_cast<double>(value), 4); };
  std::string all = fmt::format("proportional_gain = {}, derivative_gain_s = {}",
                                number(plan.controller.proportional_gain), number(plan.controller.derivative_gain_s));
  if (plan.offset.rejection == core::OffsetRejection::integral) {
    all += ", integral_gain_per_s = " + number(plan.offset.integral_gain_per_s);
  } else if (plan.offset.rejection == core::OffsetRejection::observer) {
    all += ", observer_bandwidth_rad_s = " + number(plan.offset.observer_bandwidth_rad_s);
  }
  return all;
}

struct LoopCheck {
  std::optional<stability::SpeedRange> range{};  ///< empty: no scenario, or no control in it
  stability::MarginsInRange margins{};
  std::string sentence{};  ///< what was found, or what is to be warned of
  bool warns = false;
};

LoopCheck check_loop(const Subject& subject) {
  const sim::Scenario& scenario = *subject.scenario;
  const std::vector<double> speeds_m_s = fly::speeds_under_control_m_s(scenario);
  if (speeds_m_s.empty()) {
    return {.sentence = fmt::format("in {}, control never begins, so the loop was not checked", scenario.name),
            .warns = true};
  }
  const stability::SpeedRange range{std::ranges::min(speeds_m_s), std::ranges::max(speeds_m_s)};
  if (const std::string why = stability::why_uncontrollable(scenario);
      !why.empty() && flight::has_gains(subject.plan)) {
    throw text::Error{text::ErrorKind::bad_configuration, fmt::format("{}: {}: with the rocket of {} {}", subject.file,
                                                                      gains(subject.plan), scenario.name, why)};
  }
  LoopCheck found{.range = range, .margins = stability::margins_in_range(scenario, range)};
  const std::string where = in_words(range);
  if (const auto& first = found.margins.first_without) {
    const stability::MarginAtSpeed& worst = *found.margins.least;
    throw text::Error{
        text::ErrorKind::bad_configuration,
        fmt::format(
            "{}: {}: with the rocket of {} the loop is unstable at {} m/s (phase margin {}), and worst at {} m/s "
            "({}); checked {}",
            subject.file, gains(subject.plan), scenario.name, text::fixed(first->speed_m_s, 1),
            in_degrees(first->phase_margin_rad), text::fixed(worst.speed_m_s, 1), in_degrees(worst.phase_margin_rad),
            where)};
  }
  if (!found.margins.least) {
    found.sentence = fmt::format(
        "the loop gain of {} stays below one {}: the loop cannot oscillate, and it holds little", scenario.name, where);
    found.warns = true;
    return found;
  }
  const stability::MarginAtSpeed& least = *found.margins.least;
  found.warns = least.phase_margin_rad < comfortable_rad;
  found.sentence =
      found.warns
          ? fmt::format(
                "with the rocket of {} the phase margin is only {} at {} m/s, less than the recommended {}; checked {}",
                scenario.name, in_degrees(least.phase_margin_rad), text::fixed(least.speed_m_s, 1),
                in_degrees(comfortable_rad), where)
          : fmt::format("with the rocket of {} the phase margin is {} or more {}, least at {} m/s", scenario.name,
                        in_degrees(least.phase_margin_rad), where, text::fixed(least.speed_m_s, 1));
  return found;
}

/// What becomes of the roll when the scenario is flown by this plan.
struct FlightCheck {
  std::string outcome{};  ///< empty: there is no scenario
  std::string verdict{};
  std::optional<double> before_apogee_s{};  ///< control ends so long before it, where it ends early
  std::vector<std::string> warnings{};
  std::string note{};  ///< what the outcome rests on
};

FlightCheck check_flight(const sim::Scenario& scenario) {
  const campaign::JudgedFlight flown = campaign::fly_and_judge(scenario);
  FlightCheck found{.outcome = std::string{report::name(flown.verdict.outcome)}, .verdict = flown.verdict.text};
  const flight::Events& events = flown.flight.events;
  const bool by_plan = !flown.flight.phase_changes.empty() &&
                       flown.flight.phase_changes.back().reason == core::PhaseReason::control_time_over;
  if (flown.verdict.ended_early) {
    found.before_apogee_s = flown.figures.ended_before_apogee_s;
  }
  if (found.before_apogee_s && by_plan) {
    found.warnings.push_back(fmt::format(
        "run.control_time_s = {} ends control {} s before the apogee of {}, which is {} s after control start",
        text::brief(static_cast<double>(core::seconds(scenario.plan.run.control_time)), 3),
        text::fixed(*found.before_apogee_s, 2), scenario.name,
        text::fixed(*events.apogee_s - *events.control_start_s, 2)));
  }
  for (std::string& otherwise : plan_against_scenario(scenario)) {
    found.warnings.push_back(std::move(otherwise));
  }
  if (std::string against = stability::works_against(scenario); !against.empty()) {
    found.warnings.push_back(std::move(against));
  }
  if (flown.verdict.outcome != report::Outcome::held || flown.verdict.begun_on_guide_s) {
    found.warnings.push_back(fmt::format("a flight of {} with this plan: {}", scenario.name, found.verdict));
  } else if (const auto& before_s = flown.verdict.allowed_tilt_end_s) {
    found.note = fmt::format(
        "a flight of {} counts as held, though the tilt limit ends control {} s before apogee: "
        "verdict.tilt_end_before_apogee_s = {} allows that",
        scenario.name, text::fixed(*before_s, 2), text::brief(scenario.tilt_end_before_apogee_s, 2));
  }
  return found;
}

json::Value json_of(const Subject& subject, const LoopCheck& loop, const FlightCheck& flight, const GateCheck& gate) {
  const std::size_t warnings =
      weaker_than_shipped(subject.plan).size() + (loop.warns ? 1U : 0U) + flight.warnings.size() + gate.warnings.size();
  json::Value all{
      {"plan", subject.file}, {"may_fly", true}, {"crc", fmt::format("{:08x}", protocol::plan_crc(subject.plan))}};
  all["weaker_than_shipped"] = json::Value::array();
  for (const std::string& what : weaker_than_shipped(subject.plan)) {
    all["weaker_than_shipped"].push_back(what);
  }
  all["unmet_clauses"] = unmet_clauses(subject.plan);
  all["gate_warnings"] = gate.warnings;
  result::put_answer(all, result::Answer::yes,
                     fmt::format("Every field is known and within its range: the firmware accepts this plan; {}.",
                                 text::counted(warnings, "warning")),
                     made_with({subject.file}));
  if (!subject.scenario) {
    return all;
  }
  const auto& least = loop.margins.least;
  const auto number = [](bool known, double value) {
    return known ? json::Value{json::rounded(value)} : json::Value{};
  };
  all["scenario"] = subject.scenario->name;
  all["lowest_speed_m_s"] = number(loop.range.has_value(), loop.range ? loop.range->lowest_m_s : 0.0);
  all["highest_speed_m_s"] = number(loop.range.has_value(), loop.range ? loop.range->highest_m_s : 0.0);
  all["least_phase_margin_deg"] = number(least.has_value(), least ? text::degrees(least->phase_margin_rad) : 0.0);
  all["at_speed_m_s"] = number(least.has_value(), least ? least->speed_m_s : 0.0);
  all["warning"] = loop.warns ? json::Value{loop.sentence} : json::Value{};
  all["outcome"] = flight.outcome;
  all["verdict"] = flight.verdict;
  all["control_ends_before_apogee_s"] =
      number(flight.before_apogee_s.has_value(), flight.before_apogee_s.value_or(0.0));
  all["flight_warnings"] = flight.warnings;
  all["flight_note"] = flight.note.empty() ? json::Value{} : json::Value{flight.note};
  all["gate"] = gate.json;
  return all;
}

void show_check(const Subject& found, const LoopCheck& loop, const FlightCheck& flight, const GateCheck& gate) {
  const std::string file = text::printable(found.file);
  show("{}: every field is known and within its range: the firmware accepts this plan, checksum {:08x}\n", file,
       protocol::plan_crc(found.plan));
  if (const std::vector<std::string> weaker = weaker_than_shipped(found.plan); !weaker.empty()) {
    show(
        "{}: warning: false launches are more likely than with the shipped plan for two accelerometers, which the "
        "figures of the safety case are for:\n",
        file);
    for (const std::string& what : weaker) {
      show("  {}\n", what);
    }
    show("  measure it: fantail campaign detection --plan {}\n", text::shell_word(found.file));
  }
  for (const std::string& clause : unmet_clauses(found.plan)) {
    show("{}: note: {}\n", file, clause);
  }
  if (!loop.sentence.empty()) {
    show("{}: {}{}\n", file, loop.warns ? "warning: " : "", text::printable(loop.sentence));
  }
  if (!gate.sentence.empty()) {
    show("{}: in {}, {}\n", file, text::printable(found.scenario->name), gate.sentence);
  }
  for (const std::vector<std::string>& all : {flight.warnings, gate.warnings}) {
    for (const std::string& warning : all) {
      show("{}: warning: {}\n", file, text::printable(warning));
    }
  }
  if (!flight.note.empty()) {
    show("{}: note: {}\n", file, text::printable(flight.note));
  }
}

}  // namespace

void check_plan(const PlanCheck& asked) {
  const Subject found = subject(asked);
  const LoopCheck loop = found.scenario ? check_loop(found) : LoopCheck{};
  const FlightCheck flight = found.scenario ? check_flight(*found.scenario) : FlightCheck{};
  const GateCheck gate = check_gate(found.plan, found.scenario);
  const PlanRules rules{asked.rules, found.file, found.plan};
  if (asked.json) {
    fmt::print("{}\n", rules.added_to(json_of(found, loop, flight, gate)).dump());
  } else {
    show_check(found, loop, flight, gate);
  }
  rules.end(!asked.json);
}

}  // namespace fantail::tool
