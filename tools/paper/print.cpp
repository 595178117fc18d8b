// SPDX-License-Identifier: MIT
#include "paper/print.hpp"

#include <utility>

namespace fantail::paper {

Print Print::as_published() {
  Print print;
  for (const auto& [number, value] : std::initializer_list<std::pair<Number, double>>{
           {Number::smallest_error_deg, 0.26},
           {Number::largest_error_deg, 1.5},
           {Number::bare_fins_without_deg_s, 87.0},
           {Number::bare_fins_with_deg_s, 25.7},
           {Number::bare_fins_reduction_percent, 340.0},
           {Number::detection_hold_s, 0.2},
           {Number::control_start_s, 0.63},
           {Number::control_delay_s, 0.42},
           {Number::measured_drop_deg, 27.2},
           {Number::modelled_drop_deg, 26.15},
           {Number::drop_error_percent, 4.0},
           {Number::rate_error_open_deg_s, 9.82},
           {Number::angle_error_open_deg, 1.51},
           {Number::rate_error_closed_deg_s, 9.76},
           {Number::angle_error_closed_deg, 1.50},
           {Number::rate_error_apart_deg_s, 0.06},
           {Number::angle_error_apart_deg, 0.01},
           {Number::tunnel_step_deg, 45.0},
           {Number::smallest_step_error_percent, 0.6},
           {Number::largest_step_error_percent, 3.6},
           {Number::mean_alpha_m2, 19.4},
           {Number::mean_beta_m, 9.6},
           {Number::mean_offset_begin_deg, -5.47},
           {Number::mean_offset_end_deg, -6.62},
           {Number::mean_angle_error_deg, 0.88},
           {Number::mean_rate_error_deg_s, 3.52},
           {Number::tunnel_offset_deg, -6.1},
           {Number::tunnel_offset_in_still_air_deg, -4.1},
           {Number::swirl_deg, 2.0},
           {Number::launch_alpha_m2, 23.0},
           {Number::launch_beta_m, 9.0},
           {Number::launch_angle_error_deg, 0.26},
           {Number::coast_beta_m, 8.0},
           {Number::coast_angle_error_deg, 0.99},
           {Number::alpha_error_percent, 15.7},
           {Number::beta_error_percent, 4.4},
           {Number::launch_offset_deg, 4.9},
           {Number::predicted_offset_deg, 4.1},
           {Number::offset_apart_deg, 0.8},
           {Number::offset_error_percent, 16.3},
           {Number::coast_beta_error_percent, 16.7},
           {Number::coast_offset_deg, 4.7},
           {Number::first_window_figure_s, 2.4},
           {Number::second_window_figure_s, 4.0},
           {Number::excitation_delay_s, 0.4},
           {Number::second_set_point_s, 2.0},
           {Number::offset_after_burnout_deg, 5.0},
       }) {
    print[number] = value;
  }
  print.steps = published_steps();
  return print;
}

}  // namespace fantail::paper
