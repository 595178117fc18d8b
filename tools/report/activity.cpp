// SPDX-License-Identifier: MIT
#include "report/activity.hpp"

#include <algorithm>
#include <cmath>

#include "text/degrees.hpp"

namespace fantail::report {
namespace {

using Rows = std::span<const flight::Row>;

constexpr double window_s = 1.0;
constexpr double window_step_s = 0.5;
constexpr double least_swing_rad = text::radians(1.0);
constexpr int least_swings = 3;
// The second half of a window against its first: less is a swing that dies away.
constexpr double lasts = 0.7;
constexpr double clock_tolerance_s = 1e-6;

double angle_rad(const flight::Row& row) {
  return row.truth && std::isfinite(row.truth->canard_rad) ? row.truth->canard_rad
                                                           : row.canard_rad.value_or(row.command_rad);
}
double command_rad(const flight::Row& row) { return row.command_rad; }
using AngleOf = double (*)(const flight::Row& row);

struct Ends {
  double lowest_rad;
  double highest_rad;
  [[nodiscard]] double middle_rad() const { return 0.5 * (lowest_rad + highest_rad); }
  [[nodiscard]] double swing_rad() const { return 0.5 * (highest_rad - lowest_rad); }
};

Ends ends(Rows rows, AngleOf angle = angle_rad) {
  Ends e{angle(rows.front()), angle(rows.front())};
  for (const flight::Row& row : rows) {
    e.lowest_rad = std::min(e.lowest_rad, angle(row));
    e.highest_rad = std::max(e.highest_rad, angle(row));
  }
  return e;
}

/// Whole swings a second; empty when there are too few. A swing counts when it comes to half of the largest on either
/// side, so that noise about the middle is none.
std::optional<double> swing_frequency_hz(Rows rows, const Ends& e) {
  const double threshold_rad = 0.5 * e.swing_rad();
  std::optional<double> first_s;
  double last_s = 0.0;
  int swings = -1;
  bool below = false;
  for (const flight::Row& row : rows) {
    const double away_rad = angle_rad(row) - e.middle_rad();
    below = below || away_rad < -threshold_rad;
    if (below && away_rad > threshold_rad) {
      below = false;
      first_s = first_s.value_or(row.time_s);
      last_s = row.time_s;
      ++swings;
    }
  }
  if (swings < least_swings - 1 || !first_s || last_s <= *first_s) {
    return std::nullopt;
  }
  return swings / (last_s - *first_s);
}

std::optional<Oscillation> look_at(Rows rows) {
  const Ends all = ends(rows);
  const double before_rad = ends(rows.first(rows.size() / 2)).swing_rad();
  const double after_rad = ends(rows.last(rows.size() / 2)).swing_rad();
  if (std::min(before_rad, after_rad) < least_swing_rad || after_rad < lasts * before_rad) {
    return std::nullopt;
  }
  // Encoders can be noisy. A loop that oscillates does so in what it commands, too.
  if (!rows.front().truth && ends(rows, command_rad).swing_rad() < least_swing_rad) {
    return std::nullopt;
  }
  const std::optional<double> frequency_hz = swing_frequency_hz(rows, all);
  if (!frequency_hz) {
    return std::nullopt;
  }
  return Oscillation{.from_s = rows.front().time_s,
                     .frequency_hz = *frequency_hz,
                     .lowest_rad = all.lowest_rad,
                     .highest_rad = all.highest_rad};
}

/// A stretch without excitation in which everything has settled.
void look_through(Rows quiet, std::optional<Oscillation>& widest) {
  std::size_t begin = 0;
  while (begin < quiet.size()) {
    const double from_s = quiet[begin].time_s;
    const auto at = [&](double time_s) {
      return static_cast<std::size_t>(
          std::ranges::lower_bound(quiet, time_s - clock_tolerance_s, {}, &flight::Row::time_s) - quiet.begin());
    };
    const std::size_t end = at(from_s + window_s);
    if (end >= quiet.size()) {
      return;
    }
    if (const auto found = look_at(quiet.subspan(begin, end - begin))) {
      const double first_s = widest ? widest->from_s : found->from_s;
      if (!widest || found->highest_rad - found->lowest_rad > widest->highest_rad - widest->lowest_rad) {
        widest = found;
      }
      widest->from_s = first_s;
    }
    begin = std::max(begin + 1, at(from_s + window_step_s));
  }
}

}  // namespace

std::optional<Oscillation> find_oscillation(Rows control, double settling_time_s) {
  std::optional<Oscillation> widest;
  std::size_t begin = 0;
  double settled_s = control.empty() ? 0.0 : control.front().time_s + settling_time_s;
  for (std::size_t i = 0; i < control.size(); ++i) {
    const bool disturbed =
        control[i].excitation_rad != 0.0 || (i > 0 && control[i].reference_rad != control[i - 1].reference_rad);
    if (disturbed) {
      look_through(control.subspan(begin, i - begin), widest);
      settled_s = control[i].time_s + settling_time_s;
    }
    if (control[i].time_s < settled_s - clock_tolerance_s) {
      begin = i + 1;
    }
  }
  look_through(control.subspan(begin), widest);
  return widest;
}

}  // namespace fantail::report
