// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "paper/claim.hpp"
#include "paper/published_steps.hpp"

namespace fantail::paper {

/// Every printed number that a row of computed() compares or computes with, Table 2 apart.
enum class Number : std::uint8_t {
  // Abstract
  smallest_error_deg,
  largest_error_deg,
  // Section 4.1.2
  bare_fins_without_deg_s,
  bare_fins_with_deg_s,
  bare_fins_reduction_percent,
  // Section 4.2
  detection_hold_s,
  control_start_s,
  control_delay_s,  ///< T_PD, Eq 31
  measured_drop_deg,
  modelled_drop_deg,
  drop_error_percent,
  rate_error_open_deg_s,    ///< Eq 38
  angle_error_open_deg,     ///< Eq 39
  rate_error_closed_deg_s,  ///< Eq 41
  angle_error_closed_deg,   ///< Eq 42
  rate_error_apart_deg_s,
  angle_error_apart_deg,
  // Section 4.3.1 and Table 2
  tunnel_step_deg,
  smallest_step_error_percent,
  largest_step_error_percent,
  mean_alpha_m2,
  mean_beta_m,
  mean_offset_begin_deg,
  mean_offset_end_deg,  ///< with the minus sign that its print lost
  mean_angle_error_deg,
  mean_rate_error_deg_s,
  tunnel_offset_deg,
  tunnel_offset_in_still_air_deg,
  swirl_deg,  ///< Section 4.1.2, a magnitude
  // Section 4.3.2
  launch_alpha_m2,         ///< Eq 47
  launch_beta_m,           ///< Eq 47
  launch_angle_error_deg,  ///< Eq 49
  coast_beta_m,            ///< of the text; Eq 50 repeats Eq 47
  coast_angle_error_deg,   ///< Eq 52
  alpha_error_percent,
  beta_error_percent,
  launch_offset_deg,  ///< a magnitude, and so the next
  predicted_offset_deg,
  offset_apart_deg,
  offset_error_percent,
  coast_beta_error_percent,
  coast_offset_deg,
  first_window_figure_s,  ///< on the clock of figure 27
  second_window_figure_s,
  excitation_delay_s,
  second_set_point_s,
  // Section 5
  offset_after_burnout_deg,
};
inline constexpr std::size_t number_count = static_cast<std::size_t>(Number::offset_after_burnout_deg) + 1;

/// What is printed. A test changes one number and looks what follows it.
class Print {
 public:
  /// As published; Table 2 from the shipped tunnel result. Throws text::Error.
  [[nodiscard]] static Print as_published();

  [[nodiscard]] double operator[](Number number) const { return numbers_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] double& operator[](Number number) { return numbers_[static_cast<std::size_t>(number)]; }

  std::vector<PublishedStep> steps{};  ///< Table 2

 private:
  std::array<double, number_count> numbers_{};
};

/// A printed number, and how the other printed ones give it. `ours` must not look at `theirs`; a test changes the
/// printed number and sees that ours stays.
struct Computed {
  const char* place;
  const char* what;
  Number theirs;
  double (*ours)(const Print& print);
  const char* unit = "%";
  int decimals = 1;
  double tolerance = 0.05;
  const char* why_otherwise = "";
  std::string (*remark)(const Print& print) = nullptr;
};

[[nodiscard]] std::span<const Computed> computed();

/// The only way to a row of the kind `computed`.
[[nodiscard]] Claim worked_out(const Computed& row, const Print& print);

}  // namespace fantail::paper
