// SPDX-License-Identifier: MIT
#include "rare/sentences.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/criteria.hpp"
#include "campaign/results.hpp"
#include "text/number.hpp"

namespace fantail::rare {
namespace {

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
  constexpr double worth_saying = 0.5;
  std::string all;
  for (std::size_t i = 0; i < std::min<std::size_t>(mode.quantities.size(), 3); ++i) {
    const Quantity& quantity = mode.quantities[i];
    const bool one_way = std::abs(quantity.mean_sigmas) > 0.7 * quantity.far_sigmas();
    if (one_way ? std::abs(quantity.mean_sigmas) >= worth_saying : quantity.far_sigmas() >= 1.0 + worth_saying) {
      all += fmt::format("{}{} {}", all.empty() ? "" : ", ", campaign::column_words(quantity.name).words,
                         one_way ? fmt::format("{:+.1f}", quantity.mean_sigmas)
                                 : fmt::format("{:.1f} either way", quantity.far_sigmas()));
    }
  }
  return all;
}

/// " By: control never began 62 % (imu: rate bias 3.3 either way), ...".
std::string modes_text(const Study& study) {
  constexpr std::size_t most = 3;
  std::string all;
  for (std::size_t i = 0; i < std::min(most, study.modes.size()); ++i) {
    const Mode& mode = study.modes[i];
    const std::string how = how_it_is_lost(mode);
    all += fmt::format("{}{}, {} %{}", all.empty() ? " It fails by: " : "; ", words_of(mode.criterion),
                       fixed(100.0 * mode.share, 0), how.empty() ? "" : " (" + how + ")");
  }
  return all.empty() ? "" : all + ". In brackets: standard deviations from the mean of all flights.";
}

}  // namespace

std::string words_of(const std::string& criterion) {
  const campaign::Criterion* found = campaign::find_criterion(criterion);
  return found == nullptr ? "the bound of the question is not met" : std::string{found->words};
}
Answer answer_of(const Study& study) {
  const Estimate& found = study.estimate;
  if (!study.options.at_most) {
    return Answer::none;
  }
  if (found.end == End::always_fails) {
    return Answer::no;
  }
  if (found.end != End::found) {
    return Answer::undecided;
  }
  const double required = *study.options.at_most;
  return found.low > required                                                      ? Answer::no
         : found.high <= required && study.events_unseen.value_or(0.0) <= required ? Answer::yes
                                                                                   : Answer::undecided;
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
      if (study.events_unseen && *study.events_unseen > found.low) {
        all += fmt::format(
            " Failures that no figure announces are not in it: none of {} plain flights had one, so they can be as "
            "frequent as {}.",
            found.plain_margins.size(), chance(*study.events_unseen));
      }
      all += modes_text(study);
      return all;
    }
    case End::never_fails:
      return fmt::format(
          "In {} no failure of \"{}\" was reached: the search ended at a margin that {} fall below. A failure that "
          "no margin announces would not be seen.",
          flights, question, of_flights(found.probability));
    case End::always_fails: return fmt::format("All of {} fail \"{}\": this is not rare.", flights, question);
    case End::does_not_advance: break;
  }
  return fmt::format(
      "The search for failures of \"{}\" stopped after {}. More than half of the flights of a level have the same "
      "margin, "
      "{:.4g}, so no flight leads to the next. {} fall below the last level that was reached{}.",
      question, flights, found.stuck_at, of_flights(found.probability),
      found.failing.empty() ? "" : fmt::format("; {} of its flights failed", found.failing.size()));
}

std::vector<std::string> limits(const Study& study) {
  const Estimate& found = study.estimate;
  std::vector<std::string> all{
      "The probability follows from the tables [[spread]] of the scenario, far out in their tails, where no "
      "measurement reaches. What the file does not vary is exactly as it says."};
  if (study.with_heavier_tails) {
    all.push_back(fmt::format(
        "If every normal law had the tails of Student's t distribution with five degrees of freedom, it would be about "
        "{} (probability {:.1g}). This is estimated from the direction of the failures, not flown.",
        chance(*study.with_heavier_tails), *study.with_heavier_tails));
  } else if (found.end == End::found && found.levels.size() > 1) {
    all.emplace_back("Heavier tails than these can make failures more frequent; by how much is not estimated here.");
  }
  if (study.options.question.relation == campaign::Relation::is) {
    all.emplace_back(
        "The search follows hold error, rest error, Mach number and gyro bias. Failures by something without a figure, "
        "such as canards that oscillate, are found by chance only.");
  }
  if (study.events_share > 0.0) {
    const std::string share = fixed(100.0 * study.events_share, 0);
    if (study.options.question.relation == campaign::Relation::is) {
      all.back() += fmt::format(" {} % of the failed flights failed so.", share);
    } else {
      all.push_back(share + " % of the failed flights have no such figure.");
    }
  }
  if (!study.discrete.empty()) {
    all.push_back(
        fmt::format("{} {} drawn from rows of a table: no row is rarer than 1 in the number of rows, and the "
                    "margin jumps from row to row.",
                    fmt::join(study.discrete, ", "), study.discrete.size() == 1 ? "is" : "are"));
  }
  if (found.end == End::found && found.levels.size() == 1) {
    all.emplace_back("This is not rare: `fantail campaign` answers it with the same flights, and shows more.");
  }
  return all;
}

}  // namespace fantail::rare
