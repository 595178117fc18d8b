// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/model/least_squares.hpp"
#include "identify/model/roll_model.hpp"
#include "identify/result/frequency_response.hpp"
#include "result/field.hpp"

namespace fantail::identify::result {

enum class Method : std::uint8_t { grid, continuous };
enum class Loop : std::uint8_t { open, closed };

/// Where a number lies with a probability of 95 %. Empty ends: the data do not bound it there.
using Interval = fantail::result::Range;

/// Of a number that was fitted beside a model's own.
struct Spread {
  double standard_deviation;
  double reach;  ///< from the estimate to either end of its 95 % interval
};

/// How well each number of a model is known from one record, if the model is right and its residual goes on as it was.
struct Uncertainty {
  /// In the order alpha, beta, nodes; in m2, m and radians.
  std::vector<double> standard_deviation{};
  Eigen::MatrixXd correlation{};
  std::vector<Interval> interval{};  ///< 95 %, from the standard deviations
  Interval alpha_profile_m2{};       ///< 95 %, from the profile of the likelihood: the one to trust for alpha
  std::optional<Spread> lag_s{};     ///< where the lag of the canards, or of the servo, was fitted, too
  std::optional<Spread> play_rad{};  ///< where that of the servo was, too
  double effective_samples = 0.0;    ///< independent samples that would tell alpha and beta as well as these do
  double degrees_of_freedom = 0.0;   ///< of Student's distribution behind the intervals
  double residual_rms_rad = 0.0;
  double residual_correlation_s = 0.0;  ///< over which time the residual remembers itself
  bool alpha_identifiable = false;
  bool beta_identifiable = false;
  std::string verdict{};  ///< a sentence: "alpha is not identifiable from this window: no excitation", ...
};

/// What is left in the roll rate, in bins of 10 ms or a sample. The fit asks only for the angle.
struct ResidualTests {
  double own_correlation = 0.0;     ///< the strongest with itself, 2 to 20 bins later
  double canard_correlation = 0.0;  ///< the strongest with the canards, up to 20 bins earlier
  double chance = 0.0;              ///< white noise is beyond it in one record of a hundred
  double canard_chance = 0.0;       ///< for the canards: so is a residual that remembers itself as this one does
};

/// One line of the curve over the number of intervals.
struct NodeTrial {
  std::size_t intervals;
  model::RollModel model;
  double mean_abs_angle_error_rad;
};

/// Of the closed loop, where it was fitted.
struct Servo {
  double lag_s;
  double play_rad;  ///< 0: none that tells
};

/// What one method finds in one record.
struct Identification {
  Method method = Method::continuous;
  Loop loop = Loop::open;
  model::RollModel model{};
  model::Simulation simulation{};
  std::optional<Servo> servo{};
  std::optional<Uncertainty> uncertainty{};
  std::optional<ResidualTests> residual_tests{};
  std::optional<FrequencyResponse> frequency_response{};  ///< open loop only: the measured canards drive the model
  std::optional<model::RobustFit> robust{};               ///< where Huber's loss was asked for
  bool on_grid_edge = false;                              ///< of the grid method: a better point may lie outside
  std::optional<model::ErrorMap> error_map{};
  std::vector<NodeTrial> node_trials{};  ///< where the number of nodes was chosen automatically
  std::vector<std::string> remarks{};    ///< the winner lies on the edge of the grid, ...
  std::size_t samples = 0;
  double seconds = 0.0;  ///< length of the record
};

/// What one window of a log says.
struct WindowFindings {
  model::Record record{};
  double lag_s = 0.0;
  bool lag_is_fitted = false;
  std::vector<std::string> remarks{};     ///< about the record: gaps, the lag
  std::vector<Identification> results{};  ///< one a method
};

/// All there is to report.
struct Study {
  std::string data{};     ///< the log, as the person wrote it
  std::string vehicle{};  ///< in words
  std::string density{};
  std::string speed{};
  model::Airframe airframe{};
  std::vector<std::string> warnings{};  ///< about the log as a whole
  std::vector<WindowFindings> windows{};
};

}  // namespace fantail::identify::result
