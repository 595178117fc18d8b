// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "bench/sheet_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
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

std::string allowed(const Check& check, int decimals) {
  if (check.measure == Measure::sign) {
    return "+";
  }
  if (check.measure == Measure::limit_reported) {
    return "yes";
  }
  if (check.lowest && check.highest) {
    return fixed(*check.lowest, decimals) + " to " + fixed(*check.highest, decimals);
  }
  return check.lowest    ? "at least " + fixed(*check.lowest, decimals)
         : check.highest ? "at most " + fixed(*check.highest, decimals)
                         : std::string{};
}

std::optional<SheetRow> row_of(const Sheet& sheet, Measure measure) {
  const MeasureWords about = words(measure);
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
      const std::string here = allowed(*first, about.decimals);
      row.allowed = row.allowed.empty() || row.allowed == here ? here : "each its own";
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

std::optional<double> lag_ms(const Figures& f) { return f.lag_s ? std::optional{1e3 * *f.lag_s} : std::nullopt; }

}  // namespace

std::vector<SheetRow> sheet_rows(const Sheet& sheet) {
  std::vector<SheetRow> rows;
  for (const Measure measure :
       {Measure::sign, Measure::reached_positive, Measure::reached_negative, Measure::limit_kept,
        Measure::limit_reported, Measure::tracking_error, Measure::centring_error, Measure::backlash, Measure::slew,
        Measure::step_time, Measure::noise, Measure::dropouts, Measure::others_moved}) {
    if (auto row = row_of(sheet, measure)) {
      rows.push_back(std::move(*row));
    }
  }
  switch (sheet.kind) {
    case ExerciseKind::limits: rows.push_back(plain_row(sheet, "Lag and delay", "ms", 0, lag_ms)); break;
    case ExerciseKind::step:
      rows.push_back(
          plain_row(sheet, "Told", "deg", 2, [](const Figures& f) { return in_degrees(f.told_positive_rad); }));
      rows.push_back(
          plain_row(sheet, "Reached", "deg", 2, [](const Figures& f) { return in_degrees(f.reached_positive_rad); }));
      rows.push_back(
          plain_row(sheet, "Overshoot", "deg", 2, [](const Figures& f) { return in_degrees(f.overshoot_rad); }));
      rows.push_back(plain_row(sheet, "Lag and delay", "ms", 0, lag_ms));
      break;
    case ExerciseKind::sine:
      rows.push_back(
          plain_row(sheet, "Amplitude, of the command's", "", 3, [](const Figures& f) { return f.amplitude_ratio; }));
      rows.push_back(plain_row(sheet, "Behind the command", "deg of the wave", 1,
                               [](const Figures& f) { return in_degrees(f.phase_lag_rad); }));
      rows.push_back(plain_row(sheet, "Lag and delay", "ms", 0, lag_ms));
      break;
  }
  return rows;
}

std::string sheet_title(ExerciseKind kind) {
  switch (kind) {
    case ExerciseKind::limits: return "Canard limits";
    case ExerciseKind::step: return "Canard step";
    case ExerciseKind::sine: return "Canard sine";
  }
  return "Canards";
}

}  // namespace fantail::bench
