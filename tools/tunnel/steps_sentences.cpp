// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "text/number.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {
namespace {

using text::fixed;

std::string sentence(const StepTable& table, const StepSpread& one) {
  const auto& column = one.column;
  const auto& spread = one.spread;
  const auto number = [&](double value) { return fixed(column->printed(value), decimals(table, *column)); };
  if (spread.between == 0.0) {
    return fmt::format(
        "Between the steps {} varies by no more than measurement explains (95 %: at most {} {}): the "
        "estimates scatter by {}, their errors of measurement by {}.",
        column->words, number(spread.high), column->unit, number(spread.seen), number(spread.measurement));
  }
  return fmt::format(
      "Between the steps {} varies by {} {} (95 %: {} to {}); the estimates scatter by {}, their errors "
      "of measurement by {}.",
      column->words, number(spread.between), column->unit, number(spread.low), number(spread.high), number(spread.seen),
      number(spread.measurement));
}

}  // namespace

int decimals(const StepTable& table, const StepColumn& column) {
  const bool is_area_or_length = column.unit == std::string_view{"m2"} || column.unit == std::string_view{"m"};
  return is_area_or_length && std::abs(column.printed(table.mean)) < 1.0 ? 5 : 3;
}

std::string steps_sentence(const StepTable& table) {
  return fmt::format("Mean of {} step{}: damping alpha {} m2, torque beta {} m.", table.steps.size(),
                     table.steps.size() == 1 ? "" : "s", text::brief(table.mean.alpha_m2, 5),
                     text::brief(table.mean.beta_m, 5));
}

std::vector<std::string> spread_sentences(const StepTable& table) {
  std::vector<std::string> all;
  std::ranges::transform(table.spreads, std::back_inserter(all),
                         [&table](const StepSpread& one) { return sentence(table, one); });
  return all;
}

}  // namespace fantail::tunnel
