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
    case Outcome::ended: return fmt::format("control ended, roll {:.1f} deg off until then", run.apart_deg);
    case Outcome::anything: return fmt::format("roll {:.1f} deg off, not judged", run.apart_deg);
    case Outcome::holds:
    case Outcome::recovers:
    case Outcome::goes_on: break;
  }
  return fmt::format("roll {:.1f} deg off", run.apart_deg);
}

}  // namespace

const char* name(Colour colour) {
  switch (colour) {
    case Colour::green: return "green";
    case Colour::red: return "red";
    case Colour::known_limit: return "known limit";
    case Colour::limit_without_need: return "green, though a limit is listed";
    case Colour::not_judged: return "not judged further";
    case Colour::not_applicable: break;
  }
  return "not applicable";
}

void CellSum::add(const Run& run, const CellLimit& limit) {
  ++flights;
  late += limit.is_late(run) ? 1 : 0;
  if (run.outcome) {
    ++counts[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(*run.outcome)))];
  } else {
    ++red;
    not_excused += limit.excuses(run) ? 0 : 1;
  }
  if (!worst || is_worse(run, *worst)) {
    worst = run;
  }
}

void CellSum::add(const CellSum& later) {
  flights += later.flights;
  red += later.red;
  late += later.late;
  not_excused += later.not_excused;
  for (std::size_t i = 0; i < outcomes; ++i) {
    counts[i] += later.counts[i];
  }
  if (later.worst && (!worst || is_worse(*later.worst, *worst))) {
    worst = later.worst;
  }
}

CellResult conclude(const Cell& cell, const CellSum& sum, const KnownLimit* limit) {
  const bool excused = limit != nullptr && sum.late > 0 && sum.not_excused == 0;
  CellResult result{.cell = cell,
                    .flights = sum.flights,
                    .red = sum.red,
                    .counts = sum.counts,
                    .worst = sum.worst,
                    .limit = excused ? limit : nullptr};
  if (!sum.worst) {
    return result;
  }
  result.figure = figure_of(*result.worst);
  constexpr auto anything = static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(Outcome::anything)));
  if (sum.red > 0) {
    result.colour = excused ? Colour::known_limit : Colour::red;
  } else if (sum.counts[anything] > 0) {
    result.colour = Colour::not_judged;
  } else {
    // Another rocket of the same table may need the limit of one canard.
    result.colour = excused && limit->excuse == Excuse::any ? Colour::limit_without_need : Colour::green;
  }
  return result;
}

CellResult concluded(const Cell& cell, const std::vector<Run>& runs, const CellLimit& limit) {
  CellSum sum;
  for (const Run& run : runs) {
    sum.add(run, limit);
  }
  return conclude(cell, sum, limit.limit);
}

}  // namespace fantail::faults
