// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bench/sheet_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::fixed;
using text::in_degrees;

const Check* find(const std::optional<TurnResult>& turn, Measure measure) {
  if (!turn) {
    return nullptr;
  }
  const auto found = std::ranges::find(turn->checks, measure, &Check::measure);
  return found == turn->checks.end() ? nullptr : &*found;
}

std::string shown(const Check& check, int decimals) {
  if (!check.value) {
    return "none";
  }
  if (check.measure == Measure::sign) {
    return *check.value > 0.0 ? "+" : *check.value < 0.0 ? "-" : "still";
  }
  if (check.measure == Measure::limit_reported) {
    return *check.value > 0.0 ? "yes" : "no";
  }
  return fixed(*check.value, decimals);
}

std::optional<SheetRow> row_of(const Sheet& sheet, Measure measure) {
  const MeasureText& about = text_of(measure);
  SheetRow row{.label = std::string{about.label}, .unit = std::string{about.unit}};
  bool any = false;
  for (const CanardResult& result : sheet.canards) {
    const Check* alone = find(result.alone, measure);
    const Check* together = find(result.together, measure);
    Cell cell;
    const Check* first = alone ? alone : together;
    if (first) {
      any = true;
      cell.alone = shown(*first, about.decimals);
      cell.alone_passed = first->passed;
      const std::string here = allowed_text(*first);
      row.allowed = row.allowed.empty() || row.allowed == here ? here : "per canard";
    }
    if (alone && together) {
      cell.together = shown(*together, about.decimals);
      cell.together_passed = together->passed;
    }
    row.cells.push_back(cell);
  }
  return any ? std::optional{row} : std::nullopt;
}

// Figures without a tolerance.
SheetRow plain_row(const Sheet& sheet, std::string label, std::string unit, int decimals,
                   std::optional<double> (*value)(const Figures&)) {
  SheetRow row{.label = std::move(label), .unit = std::move(unit)};
  const auto text = [&](const std::optional<double>& v) { return v ? fixed(*v, decimals) : std::string{"none"}; };
  for (const CanardResult& result : sheet.canards) {
    Cell cell;
    cell.alone = text(value(result.alone ? result.alone->figures : result.together->figures));
    if (result.alone && result.together) {
      cell.together = text(value(result.together->figures));
    }
    row.cells.push_back(cell);
  }
  return row;
}

}  // namespace

Finding finding(const Sheet& sheet, const CanardResult& result, bool judged) {
  if (!judged) {
    return {.name = "not_judged", .text = "is not judged"};
  }
  const Cause cause = result.diagnosis.cause;
  if (sheet.kind != ExerciseKind::limits && cause == Cause::healthy) {
    return {.name = "no_fault_seen", .text = "shows no fault here"};
  }
  return {.name = name(cause), .text = cause_text(cause)};
}

std::string title(const Heading& heading) { return heading.vehicle.empty() ? "Unnamed rocket" : heading.vehicle; }

std::vector<SheetRow> sheet_rows(const Sheet& sheet) {
  std::vector<SheetRow> rows;
  for (int measure = 0; measure <= static_cast<int>(Measure::others_moved); ++measure) {
    if (auto row = row_of(sheet, static_cast<Measure>(measure))) {
      rows.push_back(std::move(*row));
    }
  }
  const auto add = [&](std::string label, std::string unit, int decimals,
                       std::optional<double> (*value)(const Figures&)) {
    rows.push_back(plain_row(sheet, std::move(label), std::move(unit), decimals, value));
  };
  if (sheet.kind == ExerciseKind::step) {
    add("Commanded", "deg", 2, [](const Figures& f) { return in_degrees(f.told_positive_rad); });
    add("Overshoot", "deg", 2, [](const Figures& f) { return in_degrees(f.overshoot_rad); });
  } else if (sheet.kind == ExerciseKind::sine) {
    add("Phase lag", "deg", 1, [](const Figures& f) { return in_degrees(f.phase_lag_rad); });
  }
  add("Lag and delay, sum", "ms", 0,
      [](const Figures& f) { return f.lag_s ? std::optional{1e3 * *f.lag_s} : std::nullopt; });
  return rows;
}

}  // namespace fantail::bench
