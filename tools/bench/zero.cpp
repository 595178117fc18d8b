// SPDX-License-Identifier: MIT
#include "bench/zero.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "distributions/quantiles.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::fixed;

// Outside of this it is no scale but a horn that slips, or a wrong linkage.
constexpr double smallest_scale = 0.8;
constexpr double largest_scale = 1.25;
const double half_bus_step_rad = text::radians(0.005);
// Less than the last digit of an encoder that is read at all.
const double no_scatter_rad = text::radians(0.001);

bool forbids_zero(Cause cause) {
  switch (cause) {
    case Cause::healthy:
    case Cause::slipping:  // its scale is looked at
    case Cause::wrong_trim:
    case Cause::out_of_tolerance: return false;
    default: return true;
  }
}

std::string refused(std::size_t canard, const std::string& why) {
  return fmt::format("Canard {} is not measured: {}.", canard + 1, why);
}

std::optional<std::string> does_not_follow(const Figures& f) {
  if (f.received_ticks > 0 && 2 * f.dropouts > f.received_ticks) {
    return "its encoder gives no valid reading for more than half of the time";
  }
  if (f.sign == -1) {
    return "its encoder moves against the command. Look at the canard: either the servo turns the wrong way (sign of "
           "pulse_per_degree_us), or the encoder counts the wrong way (its magnet or mounting)";
  }
  if (f.sign == 0 && f.noise_rad && *f.noise_rad < no_scatter_rad) {
    return fmt::format(
        "its encoder reads {} deg for every command, without any scatter: the encoder is stuck, or the canard does not "
        "move",
        fixed(degrees(f.stands_at_rad.value_or(0.0)), 2));
  }
  if (f.sign == 0) {
    return fmt::format("it did not move: its encoder stays at {} deg",
                       fixed(degrees(f.stands_at_rad.value_or(0.0)), 2));
  }
  return std::nullopt;
}

Measured mean_of(std::span<const ZeroRun> runs, double ZeroRun::* value, double resolution) {
  const auto n = static_cast<double>(runs.size());
  double mean = 0.0;
  for (const ZeroRun& run : runs) {
    mean += run.*value / n;
  }
  double squares = 0.0;
  for (const ZeroRun& run : runs) {
    squares += (run.*value - mean) * (run.*value - mean);
  }
  const double deviation = std::sqrt(squares / (n - 1.0));
  return {.value = mean, .plus_minus = distributions::student_975(n - 1.0) * deviation / std::sqrt(n) + resolution};
}

double wrapped_deg(double angle_deg) { return angle_deg - 360.0 * std::round(angle_deg / 360.0); }

}  // namespace

ZeroReading zero_reading(const Sheet& sheet, std::size_t canard) {
  const auto found = std::ranges::find(sheet.canards, canard, &CanardResult::canard);
  if (found == sheet.canards.end() || !found->alone) {
    return {.refusal = refused(canard, "it was not exercised alone")};
  }
  if (too_little_travel(sheet.bounds, canard)) {
    return {.refusal = refused(canard, fmt::format("its limit of {} deg is less than {} deg beyond its trim of {} deg",
                                                   fixed(degrees(sheet.bounds.limit_rad[canard]), 2),
                                                   fixed(degrees(least_travel_rad()), 1),
                                                   fixed(degrees(sheet.bounds.centre_rad[canard]), 2)))};
  }
  const Figures& f = found->alone->figures;
  const Diagnosis& diagnosis = found->alone->diagnosis;
  if (diagnosis.cause != Cause::limit_not_kept && diagnosis.cause != Cause::wrong_canard_moves) {
    if (const auto why = does_not_follow(f)) {
      return {.refusal = refused(canard, *why)};
    }
  }
  if (forbids_zero(diagnosis.cause)) {
    return {.refusal = refused(canard, sentence(canard, diagnosis))};
  }
  if (!f.reached_positive_rad || !f.reached_negative_rad || !f.told_positive_rad || !f.told_negative_rad ||
      !f.from_above_rad || !f.from_below_rad || f.saturated) {
    return {.refusal = refused(canard, "it could not be read at rest at its trim and at both limits")};
  }
  // Whoever comes from the centre stops half the play short.
  const double play_rad = *f.from_above_rad - *f.from_below_rad;
  const double way_rad = *f.told_positive_rad - *f.told_negative_rad;
  const double scale = (*f.reached_positive_rad - *f.reached_negative_rad + play_rad) / way_rad;
  if (scale < smallest_scale || scale > largest_scale) {
    return {.refusal =
                refused(canard, fmt::format("it moves {} deg for each degree commanded; {} to {} is allowed. Look for "
                                            "a horn that slips, a stop or a wrong linkage",
                                            fixed(scale, 4), fixed(smallest_scale, 2), fixed(largest_scale, 2)))};
  }
  const double trim_rad = sheet.bounds.centre_rad[canard];
  const double at_trim_rad = trim_rad + *f.centring_error_rad;
  const double by_ends_rad = 0.5 * (*f.reached_positive_rad + *f.reached_negative_rad) +
                             scale * (trim_rad - 0.5 * (*f.told_positive_rad + *f.told_negative_rad));
  if (std::abs(at_trim_rad - by_ends_rad) > sheet.tolerances.reach_rad) {
    return {.refusal = refused(canard, fmt::format("its trim is {} deg off the line through both limits: it runs into "
                                                   "a stop, or its linkage is not linear",
                                                   fixed(degrees(at_trim_rad - by_ends_rad), 2)))};
  }
  // Least squares through three places of which the ends give the slope; the line passes the mean of all three.
  const double mean_command_rad = (trim_rad + *f.told_positive_rad + *f.told_negative_rad) / 3.0;
  const double mean_encoder_rad = (at_trim_rad + *f.reached_positive_rad + *f.reached_negative_rad) / 3.0;
  return {.run = ZeroRun{.centre_rad = mean_encoder_rad - scale * mean_command_rad,
                         .scale = scale,
                         .play_rad = std::abs(play_rad)}};
}

CanardZero combined(std::span<const ZeroRun> runs) {
  const auto widest = std::ranges::max_element(runs, {}, &ZeroRun::play_rad);
  // The two ends of the way, of at least some degrees, are half a step of the bus wrong each.
  constexpr double scale_resolution = 0.001;
  return {.centre_rad = mean_of(runs, &ZeroRun::centre_rad, half_bus_step_rad),
          .scale = mean_of(runs, &ZeroRun::scale, scale_resolution),
          .play_rad = widest->play_rad};
}

ZeroFields present_fields(const core::CanardPlan& canard) {
  return {.pulse_centre_us = {.value = static_cast<double>(canard.pulse_centre_us)},
          .pulse_per_degree_us = {.value = text::radians(static_cast<double>(canard.pulse_per_radian_us))},
          .encoder_zero_deg = {.value = static_cast<double>(canard.encoder_zero.degrees())}};
}

ZeroFields measured_fields(const core::CanardPlan& canard, const CanardZero& zero, Trusted trusted) {
  ZeroFields fields = present_fields(canard);
  const double per_degree_us = fields.pulse_per_degree_us.value / zero.scale.value;
  fields.pulse_per_degree_us = {.value = per_degree_us,
                                .plus_minus = std::abs(per_degree_us) * zero.scale.plus_minus / zero.scale.value};
  const double centre_deg = degrees(zero.centre_rad.value);
  const double plus_minus_deg = degrees(zero.centre_rad.plus_minus);
  if (trusted == Trusted::encoder) {
    fields.pulse_centre_us = {.value = fields.pulse_centre_us.value - per_degree_us * centre_deg,
                              .plus_minus = std::abs(per_degree_us) * plus_minus_deg};
  } else {
    fields.encoder_zero_deg = {.value = wrapped_deg(fields.encoder_zero_deg.value + centre_deg),
                               .plus_minus = plus_minus_deg};
  }
  return fields;
}

std::string what_an_encoder_cannot_show() {
  return "An encoder measures the shaft angle from its own zero. Only a gauge at the fin (fantail bench hold N 0) "
         "shows where its roll moment is zero, and whether servo, encoder or both are off.";
}

}  // namespace fantail::bench
