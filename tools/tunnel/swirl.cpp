// SPDX-License-Identifier: MIT
#include "tunnel/swirl.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "text/error.hpp"

namespace fantail::tunnel {
namespace {

// Set points of two sessions whose speeds differ by less than this share are one and the same.
constexpr double same_speed = 0.03;

double squared(double value) { return value * value; }

std::span<const double> between(const std::vector<double>& values, const std::vector<double>& time_s,
                                const SteadySegment& segment) {
  if (values.empty()) {
    return {};
  }
  const auto first = std::ranges::lower_bound(time_s, segment.begin_s) - time_s.begin();
  const auto last = std::ranges::upper_bound(time_s, segment.end_s) - time_s.begin();
  return std::span{values}.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
}

// Readings that all show the same value say no more than that the speed is within one step.
KnownMean mean_speed(const RollSession& session, const SteadySegment& segment) {
  KnownMean speed = known_mean(std::span{session.wind.wind_speed_m_s}.subspan(segment.first, segment.count));
  const double of_rounding = rounding_deviation(rounding_of(session.wind.wind_speed_m_s));
  if (speed.standard_deviation < of_rounding) {
    speed.standard_error = std::max(speed.standard_error, of_rounding);
  }
  return speed;
}

OffsetPoint examine(const RollSession& session, const SteadySegment& segment, const SwirlOptions& options) {
  OffsetPoint point{.segment = segment, .speed_m_s = mean_speed(session, segment)};
  const auto at = fmt::format("from {:g} to {:g} s", segment.begin_s, segment.end_s);
  if (point.speed_m_s.mean <= 0.0) {
    text::refuse(fmt::format("{}: mean wind speed {:g} m/s {}; an offset needs moving air", session.wind.name,
                             point.speed_m_s.mean, at));
  }
  const std::span<const double> rate = between(session.roll.roll_rate_rad_s, session.roll.time_s, segment);
  if (rate.size() < 2) {
    text::refuse(fmt::format("{}: no roll rates {}, where the wind was steady; the log lasts from {:g} to {:g} s",
                             session.roll.name, at, session.roll.time_s.front(), session.roll.time_s.back()));
  }
  point.rate_rad_s = known_mean(rate);
  const std::span<const double> canard = between(session.roll.canard_rad, session.roll.time_s, segment);
  double canard_error_rad = 0.0;
  if (!canard.empty() && std::ranges::all_of(canard, [](double angle) { return std::isfinite(angle); })) {
    const KnownMean mean = known_mean(canard);
    point.canard_rad = mean.mean;
    canard_error_rad = mean.standard_error;
  }
  const double rolls_as_rad =
      options.roll.alpha_m2 * point.rate_rad_s.mean / (options.roll.beta_m * point.speed_m_s.mean);
  point.offset_rad = rolls_as_rad - point.canard_rad;
  point.standard_error_rad = std::sqrt(
      squared(options.roll.alpha_m2 * point.rate_rad_s.standard_error / (options.roll.beta_m * point.speed_m_s.mean)) +
      squared(rolls_as_rad * point.speed_m_s.standard_error / point.speed_m_s.mean) + squared(canard_error_rad));
  return point;
}

std::vector<OffsetPoint> examine(const RollSession& session, const SwirlOptions& options, Swirl& swirl) {
  if (session.steady.found.empty()) {
    text::refuse(session.wind.name + ": the wind was not steady at any set point of the fan" +
                 (session.steady.left_out.empty() ? "" : "; " + session.steady.left_out.front()));
  }
  std::vector<OffsetPoint> points;
  points.reserve(session.steady.found.size());
  for (const SteadySegment& segment : session.steady.found) {
    points.push_back(examine(session, segment, options));
  }
  std::ranges::sort(points, {}, [](const OffsetPoint& point) { return point.speed_m_s.mean; });
  for (const auto* sentences : {&session.steady.left_out, &session.roll.warnings}) {
    for (const std::string& sentence : *sentences) {
      swirl.remarks.push_back(session.roll.name + ": " + sentence);
    }
  }
  return points;
}

struct Known {
  double value;
  double standard_error;
};

// The curve at a speed: the set point there, or on the straight line between its neighbours.
std::optional<Known> offset_at(const std::vector<OffsetPoint>& curve, double speed_m_s) {
  const auto nearest = std::ranges::min_element(
      curve, {}, [&](const OffsetPoint& point) { return std::abs(point.speed_m_s.mean - speed_m_s); });
  if (std::abs(nearest->speed_m_s.mean - speed_m_s) <= same_speed * speed_m_s) {
    return Known{nearest->offset_rad, nearest->standard_error_rad};
  }
  const auto above = std::ranges::find_if(curve, [&](const OffsetPoint& p) { return p.speed_m_s.mean > speed_m_s; });
  if (above == curve.begin() || above == curve.end()) {
    return std::nullopt;
  }
  const OffsetPoint& below = *std::prev(above);
  const double share = (speed_m_s - below.speed_m_s.mean) / (above->speed_m_s.mean - below.speed_m_s.mean);
  return Known{
      .value = (1.0 - share) * below.offset_rad + share * above->offset_rad,
      .standard_error = std::hypot((1.0 - share) * below.standard_error_rad, share * above->standard_error_rad)};
}

std::vector<OffsetDifference> subtract(const Swirl& swirl) {
  std::vector<OffsetDifference> differences;
  for (const OffsetPoint& point : swirl.without) {
    if (const auto with = offset_at(swirl.with, point.speed_m_s.mean)) {
      differences.push_back({.speed_m_s = point.speed_m_s.mean,
                             .without_rad = point.offset_rad,
                             .with_rad = with->value,
                             .difference_rad = point.offset_rad - with->value,
                             .standard_error_rad = std::hypot(point.standard_error_rad, with->standard_error),
                             .counted = point.speed_m_s.mean >= swirl.options.from_speed_m_s});
    }
  }
  return differences;
}

std::optional<SwirlOffset> mean_of(const std::vector<OffsetDifference>& differences) {
  std::vector<double> counted;
  double squares = 0.0;
  for (const OffsetDifference& one : differences) {
    if (one.counted) {
      counted.push_back(one.difference_rad);
      squares += squared(one.standard_error_rad);
    }
  }
  if (counted.empty()) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(counted.size());
  SwirlOffset swirl{
      .offset_rad = mean(counted), .standard_error_rad = std::sqrt(squares) / count, .speeds = counted.size()};
  if (counted.size() > 1) {
    swirl.deviation_rad = moments(counted).standard_deviation;
    swirl.standard_error_rad = std::max(swirl.standard_error_rad, *swirl.deviation_rad / std::sqrt(count));
  }
  return swirl;
}

}  // namespace

OwnRoll published_roll() {
  return {.alpha_m2 = 19.4, .beta_m = 9.6, .source = "the means of the published tunnel steps of Tasha III"};
}

Swirl examine_swirl(const RollSession& without, const RollSession& with, const SwirlOptions& options) {
  Swirl swirl{.options = options};
  swirl.without = examine(without, options, swirl);
  swirl.with = examine(with, options, swirl);
  swirl.differences = subtract(swirl);
  swirl.swirl = mean_of(swirl.differences);
  if (!swirl.swirl) {
    swirl.remarks.push_back(fmt::format("The sessions have no common speed of {:g} m/s or more: the swirl is unknown.",
                                        options.from_speed_m_s));
  }
  return swirl;
}

}  // namespace fantail::tunnel
