// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fantail::paper {

/// One of the eight tunnel steps as published (Table 2), with the two minus signs that its print lost. Its error
/// columns are headed the wrong way round; here they stand under what they are.
struct PublishedStep {
  int step;
  double alpha_m2;
  double beta_m;
  double disturbance_begin_deg;
  double disturbance_end_deg;
  double mean_abs_angle_error_deg;
  double mean_abs_rate_error_deg_s;
};

/// From the shipped tunnel result tasha3_table2, which predictions start from, too. Throws text::Error.
[[nodiscard]] std::vector<PublishedStep> published_steps();

}  // namespace fantail::paper
