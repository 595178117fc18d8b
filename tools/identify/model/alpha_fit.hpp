// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "identify/model/lanes.hpp"
#include "identify/model/least_squares.hpp"
#include "identify/model/roll_equation.hpp"
#include "identify/model/roll_model.hpp"

namespace fantail::identify::model {

/// For a fixed alpha the open-loop roll angle is linear in everything else:
///   phi = free motion + beta phi_u + sum_k (beta u_k) phi_k (+ initial states),
/// so a few simulations for each alpha serve every beta and every disturbance. What does not depend on alpha is made
/// once, here.
class ResponseBasis {
 public:
  /// The nodes have passed check_nodes().
  ResponseBasis(const Record& record, const Airframe& airframe, const NodeTimes& nodes, Start start);

  /// Columns of respond(), in this order.
  [[nodiscard]] std::size_t nodes() const { return nodes_; }  ///< angle per beta u_k
  /// Angle per initial angle and per initial rate of each segment in turn; none with Start::measured.
  [[nodiscard]] std::size_t initial_columns() const { return initial_columns_; }
  /// Angle per beta and second of lag; none unless the record has the canards' rate.
  [[nodiscard]] std::size_t lag_columns() const { return lag_columns_; }
  [[nodiscard]] std::size_t lag_column() const { return nodes_ + initial_columns_; }
  [[nodiscard]] std::size_t canard_column() const { return lag_column() + lag_columns_; }  ///< angle per beta
  [[nodiscard]] std::size_t free_column() const { return canard_column() + 1U; }           ///< from measured starts
  [[nodiscard]] std::size_t columns() const { return canard_column() + 2U; }
  [[nodiscard]] std::size_t samples() const { return samples_; }

  /// Roll angles in radians, a row a sample. `angles` is resized when it has another size.
  void respond(double alpha_m2, Eigen::MatrixXd& angles) const;

  /// Measured roll angle.
  [[nodiscard]] const Eigen::VectorXd& measured_rad() const { return measured_rad_; }

 private:
  struct State {  // of the columns of one pass
    std::array<double, lanes> angle{};
    std::array<double, lanes> rate{};
  };
  struct Reset {
    std::size_t sample;
    std::vector<State> start;  // of each pass
  };
  // So many columns at a time.
  [[nodiscard]] std::size_t passes() const { return (columns() + lanes - 1) / lanes; }

  std::size_t samples_;
  std::size_t nodes_;
  std::size_t initial_columns_;
  std::size_t lag_columns_;
  Eigen::VectorXd measured_rad_;
  std::vector<double> dt_s_;              // to the next sample; behind the last there are zeros, to read four
  std::vector<double> damping_per_m2_s_;  // mean over that step; likewise
  std::vector<double> input_;             // roll acceleration per beta: [(pass * samples + sample) * lanes + lane]
  std::vector<Reset> resets_;
};

/// The sum of squared angle errors at one alpha, the nodes fitted: measured - 2 beta both + beta^2 canards, in rad2.
struct SquaresOverBeta {
  double measured = 0.0;
  double both = 0.0;
  double canards = 0.0;
};

/// The open-loop fit at one alpha. The best nodes for a beta leave the error  rest - beta canard_rest,  where both
/// parts are what the nodes cannot explain: so one factorisation serves every beta.
class AlphaFit {
 public:
  AlphaFit(const ResponseBasis& basis, double alpha_m2);

  /// Of least squares. Empty when the nodes explain all that the canards did (to a millionth): then any beta is as
  /// good.
  [[nodiscard]] std::optional<double> best_beta_m() const;

  /// The sum of squared angle errors at the best beta, or at any when there is no best.
  [[nodiscard]] double least_squares_rad2() const;

  [[nodiscard]] SquaresOverBeta squares_over_beta() const;

  /// The mean absolute angle error at each value of the axis.
  [[nodiscard]] std::vector<double> mean_abs_error_rad(const Axis& beta_m) const;

  /// beta_m not zero. Initial states are in the model only if the basis has columns for them.
  [[nodiscard]] RollModel model(double beta_m, const NodeTimes& node_time_s) const;

  /// How much later than the record has it the canard column should be taken; only where the lag is fitted.
  [[nodiscard]] double further_lag_s(double beta_m) const;

 private:
  [[nodiscard]] auto rest() const { return angles_.col(angles_.cols() - 1); }
  [[nodiscard]] auto canard_rest() const { return angles_.col(angles_.cols() - 2); }

  double alpha_m2_;
  Eigen::Index nodes_;
  Eigen::Index lag_column_;
  Eigen::MatrixXd angles_;
  OrthogonalFit fit_;
};

/// A difference of two times to the nanosecond, so that equal steps are equal numbers.
[[nodiscard]] double step_s(double from_s, double to_s);

}  // namespace fantail::identify::model
