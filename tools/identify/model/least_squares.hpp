// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "identify/model/roll_model.hpp"

namespace fantail::identify::model {

// Least values, of three kinds: of a linear problem, of a non-linear one, of a function of one number.

/// Least squares by modified Gram-Schmidt, for many right-hand sides of one matrix. On the sides themselves it leaves
/// what the matrix cannot explain, which here is worth more than the solution: it tells every beta's error without a
/// further solve.
class OrthogonalFit {
 public:
  /// Works in `columns` itself: the first `explaining` columns become orthogonal, from the last of them to the first,
  /// and the others lose all that those explain. A column that the ones behind it explain already (to 1e-10 of its
  /// length) is left out: its coefficient is zero. Zeros that the later columns begin with are not computed with:
  /// responses to late nodes begin so.
  OrthogonalFit(Eigen::Ref<Eigen::MatrixXd> columns, Eigen::Index explaining);

  /// Coefficients of the explaining columns for the explained column `side`, counted from 0.
  [[nodiscard]] Eigen::VectorXd coefficients(Eigen::Index side) const;

  /// Length that an explained column had before, from what was left of it.
  [[nodiscard]] double length_before(const Eigen::Ref<const Eigen::VectorXd>& rest, Eigen::Index side) const;

 private:
  Eigen::Index explaining_;
  Eigen::MatrixXd parts_;    // how much of the row's direction is in each column
  Eigen::VectorXd squared_;  // length of each direction, squared
  std::vector<bool> left_out_;
};

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
  void restart(const Eigen::VectorXd& start);

  [[nodiscard]] bool finished() const { return finished_; }
  [[nodiscard]] const Eigen::VectorXd& trial() const { return trial_; }
  [[nodiscard]] const Eigen::VectorXd& best() const { return best_; }
  [[nodiscard]] double squares() const { return squares_; }  ///< at best()
  /// By how much the sum would fall from best() to trial() if the problem were linear.
  [[nodiscard]] double promised_gain() const { return promised_gain_; }

  void tell(const NormalEquations& at_trial);

 private:
  void take_step();
  [[nodiscard]] bool solve();

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

struct Span {
  double low;
  double high;
};

/// Where a function is least within a span, to about `tolerance` times the distance of two places: looked for at evenly
/// spaced places first, so that a side valley is not taken for the deepest, then by parabolas and golden sections
/// (Brent) between the neighbours of the best.
[[nodiscard]] double least_over(const std::function<double(double)>& function, Span span, int places,
                                double tolerance = 1e-7);

/// What a fit makes least of the angle errors.
enum class Loss : std::uint8_t {
  squares,
  huber,  ///< squares up to a threshold, and beyond it in proportion to the distance (Huber 1964)
};

/// An open-loop fit that a few wrong samples cannot pull away.
struct RobustFit {
  RollModel model;
  double threshold_rad;  ///< 1.345 standard deviations of the noise, these from the median of the errors
  std::size_t beyond;    ///< samples with a larger error
  bool settled;          ///< false: the model still moved when the search was ended
  /// The record as least squares would have to see it to find the same model with the same uncertainty (Huber 1973):
  /// modelled angles plus errors that are cut at the threshold and divided by the share of those that are not.
  Record pseudo_record;
};

/// Initial values are fitted, too: a model cannot begin with a sample that may be wrong.
[[nodiscard]] RobustFit fit_open_loop_robustly(const Record& record, const Airframe& airframe, const NodeTimes& nodes,
                                               const Grid& grid);

}  // namespace fantail::identify::model
