// SPDX-License-Identifier: MIT
#include "sil/plain_judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <fmt/core.h>

namespace fantail::sil {
namespace {

constexpr double in_degrees = 180.0 / std::numbers::pi;
// The demands, as a person would make them, and what rounding may do to them.
constexpr double steady_within_deg = 10.0;
constexpr double least_judged_s = 1.0;
constexpr double nobody_minds_s = 0.5;
constexpr double model_ends_at_mach = 0.8;
constexpr double rounding_deg = 0.02;
constexpr double rounding_s = 0.003;
constexpr double rounding_mach = 0.002;

/// ISO 2533, up to 11 km and in the isothermal layer above.
double speed_of_sound_m_s(double height_m) { return 20.0468 * std::sqrt(std::max(216.65, 288.15 - 0.0065 * height_m)); }

/// Of one reference.
struct Stretch {
  double begin_s = 0.0;
  double sum_deg = 0.0;
  std::size_t rows = 0;
  double last_s = 0.0;

  [[nodiscard]] double judged_s() const { return rows > 1 ? last_s - begin_s - 1.0 : 0.0; }
};

void close(PlainTruth& truth, const std::optional<Stretch>& stretch) {
  if (!stretch) {
    return;
  }
  truth.judged_s += std::max(0.0, stretch->judged_s());
  if (stretch->judged_s() >= 1.0) {
    truth.rest_deg = std::max(truth.rest_deg, std::abs(stretch->sum_deg / static_cast<double>(stretch->rows)));
  }
}

}  // namespace

PlainTruth look_plainly(std::span<const flight::Row> rows, double elevation_m) {
  PlainTruth truth;
  std::size_t top = 0;
  std::optional<std::size_t> end;
  double zero_deg = 0.0;
  double reference_deg = 0.0;
  double sum_deg = 0.0;
  std::size_t controlled = 0;
  std::optional<Stretch> stretch;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const flight::Row& row = rows[i];
    const flight::Truth& is = row.truth.value();
    top = is.height_m > rows[top].truth->height_m ? i : top;
    truth.top_mach = std::max(truth.top_mach, is.speed_m_s / speed_of_sound_m_s(is.height_m + elevation_m));
    if (row.phase == core::Phase::launched && (i == 0 || rows[i - 1].phase != core::Phase::launched)) {
      zero_deg = in_degrees * is.roll_angle_rad;
    }
    if (row.phase != core::Phase::controlling) {
      continue;
    }
    end = i;
    const double wanted_deg = in_degrees * row.reference_rad;
    const double away_deg = in_degrees * is.roll_angle_rad - zero_deg - wanted_deg;
    sum_deg += std::abs(away_deg);
    controlled += 1;
    if (!stretch || wanted_deg != reference_deg) {
      close(truth, stretch);
      stretch = Stretch{.begin_s = row.time_s};
      reference_deg = wanted_deg;
    }
    stretch->last_s = row.time_s;
    if (row.time_s - stretch->begin_s >= 1.0) {
      stretch->sum_deg += away_deg;
      stretch->rows += 1;
      truth.farthest_deg = std::max(truth.farthest_deg, std::abs(away_deg));
    }
  }
  close(truth, stretch);
  if (!end) {
    return truth;
  }
  truth.controlled = true;
  truth.mean_deg = sum_deg / static_cast<double>(controlled);
  truth.end_early_s = rows[top].time_s - rows[*end].time_s;
  for (std::size_t i = *end; i <= top; ++i) {
    const double turned_rad = rows[i].truth->roll_angle_rad - rows[*end].truth->roll_angle_rad;
    truth.turned_deg = std::max(truth.turned_deg, in_degrees * std::abs(turned_rad));
  }
  return truth;
}

std::vector<std::string> not_steady_because(const PlainTruth& truth) {
  std::vector<std::string> all;
  if (!truth.controlled) {
    all.emplace_back("control never began");
  }
  if (truth.judged_s < least_judged_s - rounding_s) {
    all.push_back(fmt::format("it was settled for {:.3f} s", truth.judged_s));
  }
  if (truth.end_early_s > nobody_minds_s + rounding_s) {
    all.push_back(fmt::format("control ended {:.2f} s before the top", truth.end_early_s));
  }
  return all;
}

std::vector<std::string> not_held_because(const PlainTruth& truth, double limit_deg) {
  std::vector<std::string> all = not_steady_because(truth);
  if (truth.rest_deg > limit_deg + rounding_deg) {
    all.push_back(fmt::format("it rested {:.2f} deg from R, and {:.2f} are the limit", truth.rest_deg, limit_deg));
  }
  if (truth.farthest_deg > steady_within_deg + limit_deg + rounding_deg) {
    all.push_back(fmt::format("it was {:.2f} deg from R, settled, and {:.2f} are the limit of its rest",
                              truth.farthest_deg, limit_deg));
  }
  if (truth.top_mach > model_ends_at_mach + rounding_mach) {
    all.push_back(fmt::format("it flew at Mach {:.3f}", truth.top_mach));
  }
  return all;
}

}  // namespace fantail::sil
