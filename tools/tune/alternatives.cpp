// SPDX-License-Identifier: MIT
#include "tune/alternatives.hpp"

#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

std::string kind_words(const Request& request) {
  const bool observes = request.rejection == core::OffsetRejection::observer;
  return fmt::format("--rejection {}{}",
                     observes                                               ? "observer"
                     : request.rejection == core::OffsetRejection::integral ? "integral"
                                                                            : "none",
                     request.schedule ? " --schedule" : "");
}

}  // namespace

void try_other_kinds(Tuning& t, const sim::Scenario& scenario, const SearchAndFly& search_and_fly) {
  if (scenario.plan.run.start != core::Start::launch ||
      scenario.plan.motion.height_origin == core::HeightOrigin::from_detection) {
    return;  // without a known speed a plan has neither schedule nor observer
  }
  std::optional<double> least_rad;
  for (const auto& [rejection, schedule] : {std::pair{t.request.rejection, true},
                                            {core::OffsetRejection::integral, true},
                                            {core::OffsetRejection::observer, false},
                                            {core::OffsetRejection::observer, true}}) {
    Tuning other = t;
    other.request.rejection = rejection;
    other.request.schedule = schedule;
    other.why_none.clear();
    other.within_reach.reset();
    other.after.reset();
    const std::string words = kind_words(other.request);
    if (words == kind_words(t.request) || t.alternative.find(words + " gives") != std::string::npos) {
      continue;
    }
    search_and_fly(other);
    const Sum flown = other.flown_after();
    if (other.is_better() && (!least_rad || *flown.mean_rad < *least_rad)) {
      least_rad = flown.mean_rad;
      t.alternative = fmt::format(
          "Another kind of law was tried and is better than the old plan: {} gives gains of {}, and {} degrees on "
          "average instead of {}.",
          words, law_words(other.after->plan), fixed(degrees(*flown.mean_rad), 2),
          fixed(degrees(*other.flown_before().mean_rad), 2));
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
        "With lower demands there are gains: {} --margin {} --settling {} gives {}, and {} degrees on average instead "
        "of {}.",
        kind_words(other.request), brief(degrees(other.request.phase_margin_rad), 1),
        brief(other.request.settling_s, 2), law_words(other.after->plan), fixed(degrees(*after.mean_rad), 2),
        fixed(degrees(*before.mean_rad), 2));
  }
}

}  // namespace fantail::tune
