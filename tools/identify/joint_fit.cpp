// SPDX-License-Identifier: MIT
#include "identify/joint_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>
#include <fmt/core.h>

#include "identify/model/alpha_fit.hpp"
#include "identify/model/least_squares.hpp"
#include "identify/model/open_loop.hpp"
#include "linear/dense.hpp"
#include "text/error.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

/// How the angles of one window answer to alpha and beta, all of its own numbers fitted.
struct Answer {
  Eigen::Matrix2d information;  ///< J'J, J without what the window's own numbers explain
  Eigen::Vector2d score;        ///< J'r
};

Answer answer(const Record& record, const Airframe& airframe, const RollModel& model) {
  const Sensitivities s = open_loop_sensitivities(record, airframe, model);
  const Eigen::Index nodes = s.numbers.cols() - 2;
  Eigen::MatrixXd columns(s.numbers.rows(), nodes + s.lag.cols() + 2 * s.start_angle.cols() + 2);
  columns << s.numbers.rightCols(nodes), s.lag, s.start_angle, s.start_rate, s.numbers.leftCols(2);
  const OrthogonalFit own_numbers{columns, columns.cols() - 2};
  const Simulation simulation = simulate_open_loop(record, airframe, model);
  const auto rows = static_cast<Eigen::Index>(record.size());
  const Eigen::VectorXd residual = Eigen::Map<const Eigen::VectorXd>(record.roll_angle_rad.data(), rows) -
                                   Eigen::Map<const Eigen::VectorXd>(simulation.roll_angle_rad.data(), rows);
  const auto own = columns.rightCols(2);
  return {.information = own.transpose() * own, .score = own.transpose() * residual};
}

struct Member {
  const Record& record;
  Airframe airframe;
  Constants own;
  NodeTimes nodes;
  ResponseBasis basis;
  Eigen::Matrix2d score_covariance;  ///< that the noise of the window gives J'r
  double weight;  ///< one over the variance of independent noise that would leave alpha and beta as unsure

  [[nodiscard]] RollModel model_with(const Eigen::Vector2d& constants) const {
    return fit_open_loop_with(constants(0), constants(1), record, airframe, nodes, Start::fitted);
  }
};

Member member(const Study& study, const WindowFindings& window) {
  const RollModel& model = window.results.front().model;
  const Constants own = constants_of(window.results.front());
  const Eigen::Matrix2d information = answer(window.record, study.airframe, model).information;
  return {.record = window.record,
          .airframe = study.airframe,
          .own = own,
          .nodes = model.node_time_s,
          .basis = ResponseBasis{window.record, study.airframe, model.node_time_s, Start::fitted},
          .score_covariance = information * own.covariance * information,
          .weight = 2.0 / (information * own.covariance).trace()};
}

void require_one_area(const std::vector<Study>& studies) {
  const double area_m2 = studies.front().airframe.reference_area_m2;
  for (const Study& study : studies) {
    const double other_m2 = study.airframe.reference_area_m2;
    if (std::abs(other_m2 - area_m2) > 1e-6 * area_m2) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        fmt::format("--shared alpha,beta: the reference area of {} is {} m2 and that of {} {} m2. They "
                                    "cannot share alpha and beta; name one vehicle for all with --vehicle",
                                    studies.front().data, area_m2, study.data, other_m2)};
    }
  }
}

/// The weighed sum of squares over beta at one alpha.
SquaresOverBeta squares_over_beta(const std::vector<Member>& members, double alpha_m2) {
  SquaresOverBeta sum;
  for (const Member& m : members) {
    const SquaresOverBeta one = AlphaFit{m.basis, alpha_m2}.squares_over_beta();
    sum.measured += m.weight * one.measured;
    sum.both += m.weight * one.both;
    sum.canards += m.weight * one.canards;
  }
  return sum;
}

/// A weight for each window, and no regard to the memory of its noise: where the search for the rest begins.
Eigen::Vector2d first_constants(const std::vector<Member>& members, const AlphaRange& range) {
  const auto least = [&](double log_alpha) {
    const SquaresOverBeta s = squares_over_beta(members, std::exp(log_alpha));
    return s.measured - (s.canards > 0.0 ? s.both * s.both / s.canards : 0.0);
  };
  constexpr int places = 24;
  const double alpha_m2 =
      std::exp(least_over(least, {.low = std::log(range.lowest_m2), .high = std::log(range.highest_m2)}, places));
  const SquaresOverBeta squares = squares_over_beta(members, alpha_m2);
  return {alpha_m2, squares.both / squares.canards};
}

/// What the windows know together at one pair of constants, in parts of these: m2 and m differ by orders of magnitude.
struct Together {
  std::vector<Eigen::Matrix2d> information{};  ///< of each window: the inverse of the covariance it would leave
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  Eigen::Vector2d step = Eigen::Vector2d::Zero();  ///< to where the windows' scores, weighed so, add up to nothing
};

Together together_at(const std::vector<Member>& members, const Eigen::Vector2d& constants) {
  const Eigen::DiagonalMatrix<double, 2> scale{constants};
  Together result;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  Eigen::Vector2d pull = Eigen::Vector2d::Zero();
  for (const Member& m : members) {
    const Answer at = answer(m.record, m.airframe, m.model_with(constants));
    // Canards that stood still say nothing of beta: what has no inverse has no weight.
    const Eigen::Matrix2d weight = linear::pseudo_inverse(Eigen::Matrix2d{scale * m.score_covariance * scale});
    const Eigen::Matrix2d information = scale * at.information * scale;
    result.information.emplace_back(information * weight * information);
    sum += result.information.back();
    pull += information * weight * (scale * at.score);
  }
  result.covariance = sum.inverse();
  result.step = result.covariance * pull;
  return result;
}

/// The constants that weigh each window with what its noise, memory included, leaves it to say.
Constants best_constants(const std::vector<Member>& members, Eigen::Vector2d value, std::vector<double>& shares) {
  constexpr int most_steps = 20;
  constexpr double longest_step = 0.3;
  Together at = together_at(members, value);
  for (int i = 0; i < most_steps && at.step.norm() > 1e-9; ++i) {
    const Eigen::Vector2d step = at.step * std::min(1.0, longest_step / at.step.norm());
    value += value.cwiseProduct(step);
    at = together_at(members, value);
  }
  // Welch and Satterthwaite's degrees of freedom, of the number that has fewer.
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Eigen::Matrix2d part = at.covariance * at.information[i] * at.covariance;
    squares += part.diagonal().cwiseAbs2() / members[i].own.degrees_of_freedom;
    shares.push_back(0.5 * (at.covariance * at.information[i]).trace());
  }
  const Eigen::DiagonalMatrix<double, 2> scale{value};
  return {.value = value,
          .covariance = scale * at.covariance * scale,
          .degrees_of_freedom = (at.covariance.diagonal().cwiseAbs2().array() / squares.array()).minCoeff()};
}

JointWindow joint_window(const Study& study, const WindowFindings& found, const Member& m, const Constants& together) {
  JointWindow joint{.data = study.data, .own = found.results.front(), .window = found};
  Identification& shared = joint.window.results.front();
  shared.uncertainty.reset();
  shared.residual_tests.reset();
  shared.error_map.reset();
  shared.node_trials.clear();
  shared.model = m.model_with(together.value);
  shared.simulation = simulate_open_loop(m.record, m.airframe, shared.model);
  return joint;
}

}  // namespace

JointFindings fit_jointly(const std::vector<Study>& studies) {
  require_one_area(studies);
  std::vector<Member> members;
  std::vector<Constants> own;
  for (const Study& study : studies) {
    for (const WindowFindings& window : study.windows) {
      members.push_back(member(study, window));
      own.push_back(members.back().own);
    }
  }
  JointFindings joint{.airframe = studies.front().airframe};
  std::vector<double> shares;
  joint.together = best_constants(members, first_constants(members, alpha_range(joint.airframe)), shares);
  joint.agreement = agreement(own);
  auto m = members.begin();
  auto share = shares.begin();
  for (const Study& study : studies) {
    for (const WindowFindings& window : study.windows) {
      joint.windows.push_back(joint_window(study, window, *m++, joint.together));
      joint.windows.back().information_share = *share++;
    }
  }
  return joint;
}

}  // namespace fantail::identify
