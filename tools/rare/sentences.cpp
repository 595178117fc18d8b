// SPDX-License-Identifier: MIT
#include "rare/sentences.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/criteria.hpp"
#include "campaign/results.hpp"
#include "distributions/shares.hpp"
#include "rare/margin.hpp"
#include "text/number.hpp"

namespace fantail::rare {
namespace {

/// What the plain flights that failed without a figure show at least.
double events_low(const Study& study) {
  const auto& plain = study.estimate.plain_margins;
  return study.events == 0 ? 0.0 : distributions::wilson(study.events, plain.size()).low;
}

using result::Answer;
using text::fixed;

/// Two digits, and people's words for it.
std::string chance(double probability) {
  if (probability >= 0.01) {
    return fmt::format("{} %", text::brief(100.0 * probability, 1));
  }
  const double digits = std::pow(10.0, std::floor(std::log10(1.0 / probability)) - 1.0);
  const double of = std::round(1.0 / probability / digits) * digits;
  std::string grouped = fmt::format("{:.0f}", of);
  for (int at = static_cast<int>(grouped.size()) - 3; at > 0; at -= 3) {
    grouped.insert(static_cast<std::size_t>(at), " ");
  }
  return "1 in " + grouped;
}

std::string of_flights(double probability) {
  return chance(probability) + (probability >= 0.01 ? " of flights" : " flights");
}

/// "disturbance -3.2, trim 1.5 either way"; empty: no quantity moved much.
std::string how_it_is_lost(const Mode& mode) {
  std::string all;
  for (std::size_t i = 0; i < std::min<std::size_t>(mode.quantities.size(), 3); ++i) {
    const Quantity& quantity = mode.quantities[i];
    if (quantity.has_moved()) {
      all += fmt::format("{}{} {}", all.empty() ? "" : ", ", campaign::column_words(quantity.name).words,
                         quantity.is_one_way() ? fmt::format("{:+.1f}", quantity.mean_sigmas)
                                               : fmt::format("{:.1f} either way", quantity.far_sigmas()));
    }
  }
  return all;
}

/// " It fails by: control never began, 62 % (imu: rate bias 3.3 either way); ...".
std::string modes_text(const Study& study) {
  constexpr std::size_t most = 3;
  constexpr const char* in_sigmas = " standard deviations from the mean of all flights";
  if (study.options.question.relation != campaign::Relation::is) {
    const std::string how = study.modes.empty() ? "" : how_it_is_lost(study.modes.front());
    return how.empty() ? "" : fmt::format(" Failed flights have, in{}: {}.", in_sigmas, how);
  }
  std::string all;
  for (std::size_t i = 0; i < std::min(most, study.modes.size()); ++i) {
    const Mode& mode = study.modes[i];
    const std::string how = how_it_is_lost(mode);
    all += fmt::format("{}{}, {} %{}", all.empty() ? " It fails by: " : "; ", words_of(mode.criterion),
                       fixed(100.0 * mode.share, 0), how.empty() ? "" : " (" + how + ")");
  }
  return all.empty() ? "" : fmt::format("{}. In brackets:{}.", all, in_sigmas);
}

/// So many plain flights without a failure bound failures to this.
std::uint64_t flights_for(double probability) {
  std::uint64_t flights = 1;
  while (distributions::upper_bound_95(0, flights) > probability) {
    flights += 1 + flights / 20;
  }
  return flights;
}

std::string required_text(const Study& study) {
  if (!study.options.at_most) {
    return "";
  }
  const double required = *study.options.at_most;
  const std::string asked = fmt::format(" Required: at most {:.4g}. ", required);
  const Estimate& found = study.estimate;
  switch (answer_of(study)) {
    case Answer::yes: return asked + "Met.";
    case Answer::no: return asked + "Not met.";
    default: break;
  }
  if (found.end == End::found && found.high > required) {
    return asked + "Not decided: it lies within the interval.";
  }
  const std::string why = found.end != End::found
                              ? fmt::format("the plain flights bound failures to {} only", chance(plain_bound(study)))
                              : fmt::format(
                                    "the interval meets it, but flights that fail without a figure are only "
                                    "known to be rarer than {}",
                                    chance(events_bound(study)));
  constexpr std::uint64_t most_flights = 1'000'000;
  const double left = found.end == End::found ? required - found.high : required;
  const std::uint64_t needed = left > 1e-7 ? flights_for(left) : most_flights + 1;
  return fmt::format("{}Not decided: {}.{}", asked, why,
                     needed > most_flights || found.end == End::does_not_advance || study.events > 0
                         ? ""
                         : fmt::format(" With --flights {} that can be decided.", needed));
}

}  // namespace

double plain_bound(const Study& study) {
  const auto is_failed = [](double margin) { return margin < 0.0 || margin == failed_by_an_event; };
  const auto& plain = study.estimate.plain_margins;
  return distributions::upper_bound_95(static_cast<std::uint64_t>(std::ranges::count_if(plain, is_failed)),
                                       plain.size());
}

double events_bound(const Study& study) {
  const auto& plain = study.estimate.plain_margins;
  return plain.empty() ? 1.0 : distributions::upper_bound_95(study.events, plain.size());
}

std::string words_of(const std::string& criterion) {
  const campaign::Criterion* found = campaign::find_criterion(criterion);
  return found == nullptr ? "the bound of the question is not met" : std::string{found->words};
}

Answer answer_of(const Study& study) {
  const Estimate& found = study.estimate;
  if (!study.options.at_most) {
    return Answer::none;
  }
  const double required = *study.options.at_most;
  switch (found.end) {
    case End::found:
      return found.low > required || events_low(study) > required ? Answer::no
             : found.high + events_bound(study) <= required       ? Answer::yes
                                                                  : Answer::undecided;
    case End::never_fails: return plain_bound(study) <= required ? Answer::yes : Answer::undecided;
    case End::always_fails: return required < 1.0 ? Answer::no : Answer::yes;
    case End::does_not_advance: break;
  }
  return Answer::undecided;
}

std::string heading(const Study& study) {
  switch (study.estimate.end) {
    case End::found: return chance(study.estimate.probability);
    case End::never_fails: return "No failure found";
    case End::always_fails: return "Every flight fails";
    case End::does_not_advance: break;
  }
  return "Not found";
}

std::string sentence(const Study& study) {
  const Estimate& found = study.estimate;
  const std::string question = study.options.question.words();
  const std::string flights = text::counted(found.points, "flight");
  switch (found.end) {
    case End::found: {
      std::string all =
          fmt::format("\"{}\" fails in {} (probability {:.2g}, 95 % interval {:.2g} to {:.2g}), by {}.", question,
                      of_flights(found.probability), found.probability, found.low, found.high, flights);
      if (events_bound(study) > found.low) {
        all += fmt::format(
            " Flights that fail without a figure {} are not in it: {} of {} plain flights did, so they can be as "
            "frequent as {}.",
            study.options.question.relation == campaign::Relation::is ? "that announces it" : "of the question",
            study.events == 0 ? std::string{"none"} : std::to_string(study.events), found.plain_margins.size(),
            chance(events_bound(study)));
      }
      return all + modes_text(study) + required_text(study);
    }
    case End::never_fails:
      return fmt::format(
          "In {} no failure of \"{}\" was found by a figure. The first {} were drawn plainly, and {} of them failed "
          "without one: failures are rarer than {} (95 %). The others were led towards {}, without reaching one. How "
          "rare a failure of another kind is they do not tell.{}",
          flights, question, found.plain_margins.size(),
          study.events == 0 ? std::string{"none"} : std::to_string(study.events), chance(plain_bound(study)),
          study.led_to ? "the limit of " + *study.led_to : "the bound", required_text(study));
    case End::always_fails:
      return fmt::format("All of {} fail \"{}\": this is not rare.{}", flights, question, required_text(study));
    case End::does_not_advance: break;
  }
  const std::string required =
      study.options.at_most ? fmt::format(" Required: at most {:.4g}. Not decided.", *study.options.at_most) : "";
  if (found.stuck_at == failed_by_an_event) {
    return fmt::format("{} of {} plain flights failed \"{}\" by something that no figure measures: this is not rare.{}",
                       study.events, found.plain_margins.size(), question, required);
  }
  return fmt::format(
      "The search for failures of \"{}\" stopped after {}. More than half of the flights of a level have the same "
      "margin, {:.4g}, so no flight leads to the next.{}{}{}",
      question, flights, std::abs(found.stuck_at) < 1e-300 ? 0.0 : found.stuck_at,
      found.levels.empty() ? "" : fmt::format(" {} came so far.", of_flights(found.probability)),
      found.failing.empty() ? " None of its flights failed by a figure."
                            : fmt::format(" {} of its flights failed.", found.failing.size()),
      required);
}

std::vector<std::string> limits(const Study& study) {
  const Estimate& found = study.estimate;
  if (found.end == End::always_fails) {
    return {"What the file does not vary is exactly as it says."};
  }
  std::vector<std::string> all{
      "The probability follows from the tables [[spread]] of the scenario, far out in their tails, where no "
      "measurement reaches. What the file does not vary is exactly as it says."};
  if (study.with_heavier_tails) {
    all.push_back(fmt::format(
        "If every normal law had the tails of Student's t distribution with five degrees of freedom, and the same "
        "standard deviation, it would be about {} (probability {:.2g}). This is estimated from the direction of the "
        "failures, not flown.",
        chance(*study.with_heavier_tails), *study.with_heavier_tails));
  } else if (found.end == End::found && found.levels.size() > 1) {
    all.emplace_back(
        "Heavier tails than these can make failures more frequent. By how much is not estimated here: failures do not "
        "lie in one direction, or no law has tails.");
  }
  if (study.options.question.relation == campaign::Relation::is) {
    all.emplace_back(
        "The search follows hold error, rest error, fin offset, phase margin, tilt, Mach number, angle of attack and "
        "gyro bias. Failures by something else, or that come at once, are found by chance only.");
  }
  if (!study.discrete.empty()) {
    all.push_back(
        fmt::format("{} {} drawn from rows of a table: no row is rarer than 1 in the number of rows, and the "
                    "margin jumps from row to row.",
                    fmt::join(study.discrete, ", "), study.discrete.size() == 1 ? "is" : "are"));
  }
  if (found.end == End::found && found.levels.size() == 1) {
    all.emplace_back("This is not rare: `fantail campaign` answers it with as many flights, and shows more.");
  }
  return all;
}

}  // namespace fantail::rare
