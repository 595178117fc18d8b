// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "paper/print.hpp"

namespace fantail::paper {
namespace {

using P = const Print&;
using N = Number;

double percent(double part, double whole) { return 100.0 * part / whole; }

double mean_of(P print, double PublishedStep::* member) {
  double sum = 0.0;
  for (const PublishedStep& row : print.steps) {
    sum += row.*member;
  }
  return sum / static_cast<double>(print.steps.size());
}

double step_error_percent(P print, bool largest) {
  const auto [least, most] = std::ranges::minmax(print.steps, {}, &PublishedStep::mean_abs_angle_error_deg);
  return percent((largest ? most : least).mean_abs_angle_error_deg, print[N::tunnel_step_deg]);
}

std::array<double, 4> flight_errors_deg(P print) {
  return {print[N::angle_error_open_deg], print[N::angle_error_closed_deg], print[N::launch_angle_error_deg],
          print[N::coast_angle_error_deg]};
}

// "Relative to the launch's value; relative to the tunnel's it is 18.6 %."
std::string denominator(const char* taken, const char* other, double difference, double other_value) {
  return fmt::format(
      "Relative to the {} value; relative to the {} it is {:.1f} %. The three errors of this section do not all have "
      "the same denominator.",
      taken, other, percent(difference, other_value));
}

constexpr const char* other_mean = "The eight rows have another mean; \u22125.47 is the entry of step 8.";

constexpr Computed computed_rows[] = {
    {.place = "Section 4.1.2",
     .what = "Reduction of the bare fins' roll rate by the straightener, 87.0 to 25.7 deg/s",
     .theirs = N::bare_fins_reduction_percent,
     .ours =
         [](P p) {
           return percent(p[N::bare_fins_without_deg_s] - p[N::bare_fins_with_deg_s], p[N::bare_fins_without_deg_s]);
         },
     .tolerance = 0.5,
     .why_otherwise = "A reduction cannot exceed 100 %. 87.0 / 25.7 is 3.4: the rate fell to 30 %."},
    {.place = "Section 4.2",
     .what = "Hold of the launch detection: control start after lift-off, 0.63 s, less T_PD of Eq 31",
     .theirs = N::detection_hold_s,
     .ours = [](P p) { return p[N::control_start_s] - p[N::control_delay_s]; },
     .unit = "s",
     .decimals = 2,
     .tolerance = 0.015,
     .remark =
         [](P) { return std::string{"The printed times are rounded, and the thrust takes time to rise to 2 g."}; }},
    {.place = "Section 4.2",
     .what = "Error of the modelled drop, 26.15 of 27.2 degrees: less than",
     .theirs = N::drop_error_percent,
     .ours = [](P p) { return percent(p[N::measured_drop_deg] - p[N::modelled_drop_deg], p[N::measured_drop_deg]); },
     .tolerance = 0.2},
    {.place = "Section 4.2",
     .what = "Difference of the loops' mean rate errors, 9.82 (Eq 38) and 9.76 (Eq 41)",
     .theirs = N::rate_error_apart_deg_s,
     .ours = [](P p) { return p[N::rate_error_open_deg_s] - p[N::rate_error_closed_deg_s]; },
     .unit = "deg/s",
     .decimals = 2,
     .tolerance = 0.005},
    {.place = "Section 4.2",
     .what = "Difference of the loops' mean angle errors, 1.51 (Eq 39) and 1.50 (Eq 42)",
     .theirs = N::angle_error_apart_deg,
     .ours = [](P p) { return p[N::angle_error_open_deg] - p[N::angle_error_closed_deg]; },
     .unit = "deg",
     .decimals = 2,
     .tolerance = 0.005},
    {.place = "Abstract",
     .what = "Smallest mean angle error of the flights: of 1.51, 1.50, 0.26 and 0.99 (Eq 39, 42, 49, 52)",
     .theirs = N::smallest_error_deg,
     .ours = [](P p) { return std::ranges::min(flight_errors_deg(p)); },
     .unit = "deg",
     .decimals = 2,
     .tolerance = 0.005},
    {.place = "Abstract",
     .what = "Largest of them",
     .theirs = N::largest_error_deg,
     .ours = [](P p) { return std::ranges::max(flight_errors_deg(p)); },
     .unit = "deg",
     .decimals = 2},
    {.place = "Table 2, mean",
     .what = "Mean damping",
     .theirs = N::mean_alpha_m2,
     .ours = [](P p) { return mean_of(p, &PublishedStep::alpha_m2); },
     .unit = "m2",
     .decimals = 2,
     .tolerance = 0.051},
    {.place = "Table 2, mean",
     .what = "Mean torque constant",
     .theirs = N::mean_beta_m,
     .ours = [](P p) { return mean_of(p, &PublishedStep::beta_m); },
     .unit = "m",
     .decimals = 2,
     .tolerance = 0.051},
    {.place = "Table 2, mean",
     .what = "Mean offset at the begin",
     .theirs = N::mean_offset_begin_deg,
     .ours = [](P p) { return mean_of(p, &PublishedStep::disturbance_begin_deg); },
     .unit = "deg",
     .decimals = 3,
     .tolerance = 0.0051,
     .why_otherwise = other_mean},
    {.place = "Table 2, mean",
     .what = "Mean offset at the end",
     .theirs = N::mean_offset_end_deg,
     .ours = [](P p) { return mean_of(p, &PublishedStep::disturbance_end_deg); },
     .unit = "deg",
     .decimals = 3,
     .tolerance = 0.0051,
     .remark = [](P) { return std::string{"Printed without its minus sign."}; }},
    {.place = "Table 2, mean, and section 4.3.1",
     .what = "Mean angle error",
     .theirs = N::mean_angle_error_deg,
     .ours = [](P p) { return mean_of(p, &PublishedStep::mean_abs_angle_error_deg); },
     .unit = "deg",
     .decimals = 3,
     .tolerance = 0.0051},
    {.place = "Table 2, mean, and section 4.3.1",
     .what = "Mean rate error",
     .theirs = N::mean_rate_error_deg_s,
     .ours = [](P p) { return mean_of(p, &PublishedStep::mean_abs_rate_error_deg_s); },
     .unit = "deg/s",
     .decimals = 3,
     .tolerance = 0.0051},
    {.place = "Section 4.3.1",
     .what = "Smallest mean angle error of Table 2 over the step of 45 degrees",
     .theirs = N::smallest_step_error_percent,
     .ours = [](P p) { return step_error_percent(p, false); }},
    {.place = "Section 4.3.1",
     .what = "Largest of them",
     .theirs = N::largest_step_error_percent,
     .ours = [](P p) { return step_error_percent(p, true); }},
    {.place = "Section 4.3.1",
     .what = "Average fin offset over all steps",
     .theirs = N::tunnel_offset_deg,
     .ours =
         [](P p) {
           return 0.5 *
                  (mean_of(p, &PublishedStep::disturbance_begin_deg) + mean_of(p, &PublishedStep::disturbance_end_deg));
         },
     .unit = "deg",
     .decimals = 2,
     .tolerance = 0.051},
    {.place = "Section 4.3.1",
     .what = "The same without the 2 degrees of swirl of section 4.1.2",
     .theirs = N::tunnel_offset_in_still_air_deg,
     .ours = [](P p) { return p[N::tunnel_offset_deg] + p[N::swirl_deg]; },
     .unit = "deg",
     .decimals = 2},
    {.place = "Section 4.3.2",
     .what = "Launch 2's damping, 23, against the tunnel's mean, 19.4",
     .theirs = N::alpha_error_percent,
     .ours = [](P p) { return percent(p[N::launch_alpha_m2] - p[N::mean_alpha_m2], p[N::launch_alpha_m2]); },
     .remark =
         [](P p) {
           return denominator("launch's", "tunnel's", p[N::launch_alpha_m2] - p[N::mean_alpha_m2], p[N::mean_alpha_m2]);
         }},
    {.place = "Section 4.3.2",
     .what = "Launch 2's torque constant, 9, against the tunnel's mean, 9.6",
     .theirs = N::beta_error_percent,
     .ours = [](P p) { return percent(p[N::mean_beta_m] - p[N::launch_beta_m], p[N::mean_beta_m]); },
     .why_otherwise = "It is 6.2 % of the tunnel's and 6.7 % of the launch's value."},
    {.place = "Section 4.3.2",
     .what = "Mean offset of the launch, 4.9, against the tunnel's, 4.1",
     .theirs = N::offset_apart_deg,
     .ours = [](P p) { return p[N::launch_offset_deg] - p[N::predicted_offset_deg]; },
     .unit = "deg"},
    {.place = "Section 4.3.2",
     .what = "The same in percent",
     .theirs = N::offset_error_percent,
     .ours = [](P p) { return percent(p[N::launch_offset_deg] - p[N::predicted_offset_deg], p[N::launch_offset_deg]); },
     .remark =
         [](P p) {
           return denominator("launch's", "tunnel's", p[N::launch_offset_deg] - p[N::predicted_offset_deg],
                              p[N::predicted_offset_deg]);
         }},
    {.place = "Section 4.3.2",
     .what = "Second window's torque constant, 8, against the tunnel's mean, 9.6",
     .theirs = N::coast_beta_error_percent,
     .ours = [](P p) { return percent(p[N::mean_beta_m] - p[N::coast_beta_m], p[N::mean_beta_m]); },
     .remark =
         [](P p) {
           return denominator("tunnel's", "launch's", p[N::mean_beta_m] - p[N::coast_beta_m], p[N::coast_beta_m]);
         }},
    {.place = "Section 4.3.2, figure 27",
     .what = "Start of the second window: 2 s after control start at 2.4 \u2212 0.4 s, about",
     .theirs = N::second_window_figure_s,
     .ours = [](P p) { return p[N::first_window_figure_s] - p[N::excitation_delay_s] + p[N::second_set_point_s]; },
     .unit = "s"},
    {.place = "Section 5",
     .what = "Launch 2's fin offset after burn-out: about, where section 4.3.2 has 4.7",
     .theirs = N::offset_after_burnout_deg,
     .ours = [](P p) { return p[N::coast_offset_deg]; },
     .unit = "deg",
     .tolerance = 0.5},
};

}  // namespace

std::span<const Computed> computed() { return computed_rows; }

Claim worked_out(const Computed& row, const Print& print) {
  return compare({.place = row.place,
                  .what = row.what,
                  .theirs = print[row.theirs],
                  .ours = row.ours(print),
                  .unit = row.unit,
                  .decimals = row.decimals,
                  .tolerance = row.tolerance,
                  .kind = Kind::computed,
                  .why_otherwise = row.why_otherwise,
                  .remark = row.remark != nullptr ? row.remark(print) : ""});
}

}  // namespace fantail::paper
