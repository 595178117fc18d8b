// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>

#include <fmt/core.h>

#include "faults/campaign.hpp"

namespace fantail::faults {
namespace {

/// Of two flights of a cell, the one to look at.
bool is_worse(const Run& a, const Run& b) {
  if (a.outcome.has_value() != b.outcome.has_value()) {
    return !a.outcome;
  }
  const auto measure = [](const Run& run) {
    const bool is_over = run.outcome == Outcome::over || run.outcome == Outcome::no_control;
    return is_over ? std::max(run.trim_after_s, run.stands_after_s) : run.apart_deg;
  };
  return measure(a) > measure(b);
}

std::string figure_of(const Run& run) {
  if (!run.outcome) {
    return run.what;
  }
  switch (*run.outcome) {
    case Outcome::not_armed: return "not armed";
    case Outcome::no_control: return "no control";
    case Outcome::over:
      return fmt::format("at trim after {:.3f} s, canards after {:.3f} s", run.trim_after_s, run.stands_after_s);
    case Outcome::anything: return fmt::format("{:.1f} deg apart, of which nothing is asked", run.apart_deg);
    case Outcome::holds:
    case Outcome::recovers:
    case Outcome::goes_on: break;
  }
  return fmt::format("{:.1f} deg apart", run.apart_deg);
}

}  // namespace

const char* name(Colour colour) {
  switch (colour) {
    case Colour::green: return "green";
    case Colour::red: return "red";
    case Colour::known_limit: return "known limit";
    case Colour::limit_without_need: return "green, though a limit is listed";
    case Colour::not_applicable: break;
  }
  return "not applicable";
}

CellResult concluded(const Cell& cell, const std::vector<Run>& runs, const KnownLimit* limit, int excused_from_ms) {
  const auto is_late = [&](const Run& run) { return run.begin_ms >= excused_from_ms; };
  bool excused = limit != nullptr && std::ranges::any_of(runs, is_late);
  CellResult result{.cell = cell, .flights = runs.size(), .limit = excused ? limit : nullptr};
  if (runs.empty()) {
    return result;
  }
  for (const Run& run : runs) {
    if (run.outcome) {
      ++result.counts[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(*run.outcome)))];
    } else {
      ++result.red;
      excused = excused && is_late(run);
    }
    if (!result.worst || is_worse(run, *result.worst)) {
      result.worst = run;
    }
  }
  result.figure = figure_of(*result.worst);
  if (result.red > 0) {
    result.colour = excused ? Colour::known_limit : Colour::red;
    result.limit = excused ? limit : nullptr;
  } else {
    result.colour = result.limit != nullptr ? Colour::limit_without_need : Colour::green;
  }
  return result;
}

}  // namespace fantail::faults
