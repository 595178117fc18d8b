// SPDX-License-Identifier: MIT
#include "detection/rule.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "core/flight_plan_fields.hpp"
#include "input/document.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "text/error.hpp"

namespace fantail::detection {
namespace {

core::FlightPlan plan_of(const std::string& name) {
  if (name != published_launch_2) {
    return input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, name).string()));
  }
  // Nothing is printed of how far the two may differ, nor behind which filter: the defaults.
  const std::array<input::Override, 5> as_printed{
      {{.section = "launch_detection", .key = "low_pass", .value = "false"},
       {.section = "launch_detection", .key = "low_pass_hz", .value = "16"},
       {.section = "launch_detection", .key = "disagreement_g", .value = "0.5"},
       {.section = "guide", .key = "minimum_speed_m_s", .value = "0"},
       {.section = "motion", .key = "height_origin", .value = "\"velocity_only\""}}};
  return input::changed_plan(plan_of("tasha3_launch2"), as_printed);
}

std::vector<std::string> usual_plans() {
  std::vector<std::string> names;
  for (const std::string& name : input::shipped_names(input::Shipped::plan)) {
    if (plan_of(name).run.start == core::Start::launch) {
      names.push_back(name);
    }
  }
  names.emplace_back(published_launch_2);
  return names;
}

}  // namespace

std::string Rule::name() const { return fmt::format("{}", fmt::join(names, ", ")); }

std::string identity_of(const Rule& rule) {
  std::istringstream lines{input::plan_table(rule.plan)};
  std::string result;
  bool counts = false;
  for (std::string line; std::getline(lines, line);) {
    constexpr std::array<std::string_view, 4> sections{"[launch_detection]", "[guide]", "[motion]", "[sensors]"};
    if (line.starts_with('[')) {
      counts = std::ranges::find(sections, line) != sections.end();
    }
    if (counts) {
      result += line.substr(0, line.find('#')) + '\n';
    }
  }
  return result;
}

std::vector<Rule> rules_of(std::span<const std::string> plans) {
  const std::vector<std::string> usual = plans.empty() ? usual_plans() : std::vector<std::string>{};
  std::vector<Rule> rules;
  for (const std::string& name : plans.empty() ? std::span<const std::string>{usual} : plans) {
    Rule rule{.names = {name}, .plan = plan_of(name), .judged = name != published_launch_2};
    // Detection and guide alone are asked here: with a gate a canard moves later, and never where it does not without.
    rule.plan.dormancy.until = core::DormantUntil::guide;
    rule.judged = rule.judged &&
                  (!plans.empty() || rule.plan.launch_detection.accelerometers == core::AccelerometerRule::two_agree);
    if (rule.plan.run.start != core::Start::launch) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        fmt::format("{}: run.start is tunnel; allowed: a plan that starts with launch", name)};
    }
    const auto same = std::ranges::find_if(rules, [&](const Rule& other) {
      return other.judged == rule.judged && identity_of(other) == identity_of(rule);
    });
    if (same == rules.end()) {
      rules.push_back(std::move(rule));
    } else if (std::ranges::find(same->names, name) == same->names.end()) {
      same->names.push_back(name);
    }
  }
  return rules;
}

}  // namespace fantail::detection
