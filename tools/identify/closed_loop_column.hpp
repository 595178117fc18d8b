// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "identify/closed_loop_trials.hpp"

namespace fantail::identify {

/// Nodes (and initial states) for one alpha and beta: where to begin, then where least squares are.
struct Attempt {
  double beta_m;
  Eigen::VectorXd place;
  double squares_rad2 = 0.0;
  double mean_abs_error_rad = 0.0;
};

/// Solves many attempts of one alpha, some of them side by side.
class ClosedLoopColumn {
 public:
  /// `course` must live as long.
  ClosedLoopColumn(const Course& course, Start start);

  void solve(double alpha_m2, std::vector<Attempt>& attempts);

 private:
  static constexpr std::size_t lanes = 4;

  void improve(std::vector<Attempt>& attempts);
  void judge(std::vector<Attempt>& attempts);
  void wait_for_all(std::size_t count);
  template <class Fly, class Where, class Told>
  void fly_waiting(const std::vector<Attempt>& attempts, const Fly& fly, const Where& where, const Told& told);

  LevenbergMarquardt::Rules rules_;
  LaneTrials<lanes> trials_;
  Transitions transitions_{};
  std::vector<LevenbergMarquardt> searches_{};  ///< one for each attempt; kept for their memory
  std::vector<std::size_t> waiting_{};
  std::vector<std::size_t> still_waiting_{};
};

}  // namespace fantail::identify
