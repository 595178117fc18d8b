// SPDX-License-Identifier: MIT
#include "campaign/question.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "campaign/results.hpp"
#include "report/verdict.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::campaign {
namespace {

using report::Outcome;

[[noreturn]] void refuse(std::string_view text, const std::string& allowed) {
  throw text::Error{text::ErrorKind::usage, fmt::format("\"{}\" is not a question; allowed: {}", text, allowed)};
}

Question outcome_question(std::string_view text, std::string_view outcome) {
  std::string allowed;
  for (const Outcome one : report::outcomes) {
    if (report::name(one) == outcome) {
      return {.outcome = std::string{outcome}};
    }
    allowed += fmt::format("{}outcome={}", allowed.empty() ? "" : ", ", report::name(one));
  }
  refuse(text, allowed);
}

}  // namespace

Question parse_question(std::string_view text) {
  constexpr std::string_view outcome = "outcome=";
  if (text.starts_with(outcome)) {
    return outcome_question(text, text.substr(outcome.size()));
  }
  const std::size_t sign = text.find_first_of("<>");
  const std::string_view column = text.substr(0, sign);
  const auto* const figure = std::ranges::find(figure_columns, column);
  if (sign == std::string_view::npos || figure == figure_columns.end() || text.substr(sign + 1, 1) != "=") {
    refuse(text, fmt::format("outcome=held, or one of {} with >= or <= and a number", fmt::join(figure_columns, ", ")));
  }
  const std::optional<double> bound = text::number(text.substr(sign + 2));
  if (!bound) {
    refuse(text, fmt::format("{} and a number", text.substr(0, sign + 2)));
  }
  return {.relation = text[sign] == '>' ? Relation::at_least : Relation::at_most,
          .figure = static_cast<std::size_t>(figure - figure_columns.begin()),
          .bound = *bound};
}

std::string objection_to_question(const std::string& text) {
  try {
    (void)parse_question(text);
    return "";
  } catch (const text::Error& error) {
    return error.what();
  }
}

bool Question::is_met_by(const FlownRun& run) const {
  if (run.outcome == "not_finite") {
    return false;  // some of its figures may be numbers, but nobody can trust them
  }
  switch (relation) {
    case Relation::is: return run.outcome == outcome;
    case Relation::at_least: return run.figures[figure] && *run.figures[figure] >= bound;
    case Relation::at_most: break;
  }
  return run.figures[figure] && *run.figures[figure] <= bound;
}

bool Question::is_failed_by(const FlownRun& run) const {
  return (relation == Relation::is && outcome != report::name(Outcome::held)) == is_met_by(run);
}

std::string Question::text() const {
  return relation == Relation::is
             ? "outcome=" + outcome
             : fmt::format("{}{}{}", figure_columns[figure], relation == Relation::at_least ? ">=" : "<=", bound);
}

std::string Question::words() const {
  if (relation == Relation::is) {
    return "Outcome " + outcome_words(outcome);
  }
  ColumnWords column = column_words(figure_columns[figure]);
  column.words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(column.words.front())));
  return fmt::format("{} at {} {}{}{}", column.words, relation == Relation::at_least ? "least" : "most", bound,
                     column.unit.empty() ? "" : " ", column.unit);
}

}  // namespace fantail::campaign
