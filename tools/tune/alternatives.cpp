// SPDX-License-Identifier: MIT
#include "tune/alternatives.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

std::string command_of(const Request& request) {
  const bool observes = request.rejection == core::OffsetRejection::observer;
  std::string command = fmt::format("{} --rejection {}{}", request.scenario_command,
                                    observes                                               ? "observer"
                                    : request.rejection == core::OffsetRejection::integral ? "integral"
                                                                                           : "none",
                                    request.schedule ? " --schedule" : "");
  const Request usual;
  const auto add = [&command](const char* option, double value, double usual_value) {
    command += value == usual_value ? "" : fmt::format(" {} {}", option, brief(value, 3));
  };
  add("--margin", degrees(request.phase_margin_rad), degrees(usual.phase_margin_rad));
  add("--settling", request.settling_s, usual.settling_s);
  add("--spread", request.spread, usual.spread);
  add("--flights", static_cast<double>(request.flights), static_cast<double>(usual.flights));
  return command + (request.replaces ? " --force" : "");
}

}  // namespace

void try_other_kinds(Tuning& t, const sim::Scenario& scenario, const SearchAndFly& search_and_fly) {
  if (scenario.plan.run.start != core::Start::launch ||
      scenario.plan.motion.height_origin == core::HeightOrigin::from_detection) {
    return;  // without a known speed a plan has neither schedule nor observer
  }
  std::optional<double> least_rad;
  Request asked = t.request;
  asked.replaces = asked.replaces || t.is_proposed();  // its plan will be there
  std::vector<std::string> tried{command_of(asked)};
  for (const auto& [rejection, schedule] : {std::pair{t.request.rejection, true},
                                            {core::OffsetRejection::integral, false},
                                            {core::OffsetRejection::integral, true},
                                            {core::OffsetRejection::observer, false},
                                            {core::OffsetRejection::observer, true}}) {
    Tuning other = t;
    other.request = asked;
    other.request.rejection = rejection;
    other.request.schedule = schedule;
    other.why_none.clear();
    other.within_reach.reset();
    other.after.reset();
    const std::string command = command_of(other.request);
    if (std::ranges::find(tried, command) != tried.end()) {
      continue;
    }
    tried.push_back(command);
    search_and_fly(other);
    const Sum flown = other.flown_after();
    if (other.is_better() && (!least_rad || *flown.mean_rad < *least_rad)) {
      least_rad = flown.mean_rad;
      t.alternative = fmt::format(
          "Another kind of law flies better: gains of {}, and {} degrees from the reference on average instead of {}. "
          "Its command: {}",
          law_words(other.after->plan), fixed(degrees(*flown.mean_rad), 2),
          fixed(degrees(*other.flown_before().mean_rad), 2), command);
    }
  }
}

void try_lower_demands(Tuning& t, const SearchAndFly& search_and_fly) {
  Tuning other = t;
  for (int tries = 0; tries < 2 && other.within_reach; ++tries) {
    other.request = *other.within_reach;
    other.why_none.clear();
    other.within_reach.reset();
    search_and_fly(other);
  }
  const Sum before = other.flown_before();
  const Sum after = other.flown_after();
  if (other.is_proposed() && before.mean_rad && after.mean_rad) {
    t.alternative = fmt::format(
        "With lower demands there is a law: gains of {}, and {} degrees from the reference on average instead of {}. "
        "Its command: {}",
        law_words(other.after->plan), fixed(degrees(*after.mean_rad), 2), fixed(degrees(*before.mean_rad), 2),
        command_of(other.request));
  }
}

}  // namespace fantail::tune
