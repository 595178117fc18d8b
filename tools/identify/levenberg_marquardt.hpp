// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace fantail::identify {

/// What least squares need to know at one point: with residuals r and their derivatives J.
struct NormalEquations {
  double squares = 0.0;        ///< r'r
  Eigen::MatrixXd normal{};    ///< J'J
  Eigen::VectorXd gradient{};  ///< J'r
};

/// Minimises a sum of squares (Levenberg 1944, Marquardt 1963). It asks and is told, instead of calling a function, so
/// that many of them can share one flight of all their trials:
///   while (!search.finished()) { search.tell(equations at search.trial()); }
/// A trial that may not be, or came out as NaN or infinity, is told as an infinite sum.
class LevenbergMarquardt {
 public:
  struct Rules {
    double first_damping = 1e-3;   ///< share of the diagonal that is added to it; 0: Gauss and Newton's step
    double relative_gain = 1e-10;  ///< finished when a step promises to win less than this share of the sum ...
    double absolute_gain = 0.0;    ///< ... or less than this
    int most_trials = 60;
  };

  LevenbergMarquardt(Eigen::VectorXd start, const Rules& rules)
      : rules_{rules}, damping_{rules.first_damping}, best_{start}, trial_{std::move(start)} {}

  /// Begins again from another point; memory is used again.
  void restart(const Eigen::VectorXd& start) {
    damping_ = rules_.first_damping;
    squares_ = std::numeric_limits<double>::infinity();
    promised_gain_ = std::numeric_limits<double>::infinity();
    trials_ = 0;
    finished_ = false;
    best_ = start;
    trial_ = start;
  }

  [[nodiscard]] bool finished() const { return finished_; }
  [[nodiscard]] const Eigen::VectorXd& trial() const { return trial_; }
  [[nodiscard]] const Eigen::VectorXd& best() const { return best_; }
  [[nodiscard]] double squares() const { return squares_; }  ///< at best()
  /// By how much the sum would fall from best() to trial() if the problem were linear.
  [[nodiscard]] double promised_gain() const { return promised_gain_; }

  void tell(const NormalEquations& at_trial) {
    ++trials_;
    if (at_trial.squares < squares_) {
      const double won = squares_ - at_trial.squares;
      if (won > 0.75 * promised_gain_) {
        damping_ *= 0.1;
      } else if (won < 0.25 * promised_gain_) {
        damping_ = std::max(3.0 * damping_, 1e-4);
      }
      best_ = trial_;
      squares_ = at_trial.squares;
      normal_ = at_trial.normal;
      gradient_ = at_trial.gradient;
    } else {
      damping_ = std::max(8.0 * damping_, 1e-4);
    }
    finished_ = finished_ || trials_ >= rules_.most_trials || !std::isfinite(squares_) || damping_ > most_damping;
    if (!finished_) {
      take_step();
      finished_ = promised_gain_ <= std::max(rules_.relative_gain * squares_, rules_.absolute_gain);
    }
  }

 private:
  void take_step() {
    // An unknown that nothing depends on stays where it is.
    const double largest = normal_.diagonal().maxCoeff();
    const double floor = largest > 0.0 ? 1e-14 * largest : 1.0;
    step_ = -gradient_;
    do {
      damped_ = normal_;
      damped_.diagonal() += damping_ * normal_.diagonal();
      damped_.diagonal().array() += floor;
    } while (!solve() && (damping_ = std::max(10.0 * damping_, 1e-9)) < most_damping);
    // (N + D) s = -g: what the sum would lose if the residuals were linear.
    promised_gain_ = -(2.0 * gradient_.dot(step_) + step_.dot(normal_ * step_));
    trial_ = best_ + step_;
  }

  // Works in the memory of `damped_` and `step_`.
  bool solve() {
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors{damped_};
    if (factors.info() != Eigen::Success) {
      return false;
    }
    factors.solveInPlace(step_);
    return true;
  }

  static constexpr double most_damping = 1e12;

  Rules rules_;
  double damping_;
  double squares_ = std::numeric_limits<double>::infinity();
  double promised_gain_ = std::numeric_limits<double>::infinity();
  int trials_ = 0;
  bool finished_ = false;
  Eigen::VectorXd best_;
  Eigen::VectorXd trial_;
  Eigen::VectorXd step_{};
  Eigen::VectorXd gradient_{};
  Eigen::MatrixXd normal_{};
  Eigen::MatrixXd damped_{};
};

}  // namespace fantail::identify
