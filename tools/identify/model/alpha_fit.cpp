// SPDX-License-Identifier: MIT
#include "identify/model/alpha_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fantail::identify::model {
namespace {

// So many at a time that they stay in the nearest cache until all lanes have taken them.
constexpr std::size_t stretch = 64;
using Steps = std::array<RampStep, stretch>;

void fill(Steps& all, double alpha_m2, const double* damping_per_m2_s, const double* dt_s, std::size_t count) {
  constexpr std::size_t together = 4;
  using Numbers = Eigen::Array<double, together, 1>;
  std::size_t i = 0;
  while (i < count) {
    if (i + together <= count) {
      const Numbers dt{Eigen::Map<const Numbers>{&dt_s[i]}};
      const Numbers damping = alpha_m2 * Eigen::Map<const Numbers>{&damping_per_m2_s[i]} * dt;
      if ((damping < small_damping).all()) {
        const RampStepOf<Numbers> t = small_ramp_step(damping, dt);
        for (Eigen::Index j = 0; j < Eigen::Index{together}; ++j, ++i) {
          all[i] = {t.decay[j], t.rate_0[j], t.rate_1[j], t.angle_p[j], t.angle_0[j], t.angle_1[j]};
        }
        continue;
      }
    }
    all[i] = ramp_step(alpha_m2 * damping_per_m2_s[i], dt_s[i]);
    ++i;
  }
}

// The free motion's column becomes what is to be explained.
Eigen::MatrixXd responses(const ResponseBasis& basis, double alpha_m2) {
  Eigen::MatrixXd angles;
  basis.respond(alpha_m2, angles);
  const auto free = static_cast<Eigen::Index>(basis.free_column());
  angles.col(free) = basis.measured_rad() - angles.col(free);
  return angles;
}

constexpr Eigen::Index canard_side = 0;
constexpr Eigen::Index measured_side = 1;

}  // namespace

double step_s(double from_s, double to_s) { return 1e-9 * std::round((to_s - from_s) * 1e9); }

ResponseBasis::ResponseBasis(const Record& record, const Airframe& airframe, const NodeTimes& nodes, Start start)
    : samples_{record.size()},
      nodes_{nodes.size()},
      initial_columns_{start == Start::fitted ? 2 * record.segment_begin.size() : 0},
      lag_columns_{record.canard_rate_rad_s.empty() ? 0U : 1U} {
  measured_rad_ = Eigen::Map<const Eigen::VectorXd>(record.roll_angle_rad.data(), static_cast<Eigen::Index>(samples_));
  const std::vector<RollEquation> equation = roll_equations(record, airframe);
  for (std::size_t i = 0; i + 1 < samples_; ++i) {
    dt_s_.push_back(step_s(record.time_s[i], record.time_s[i + 1]));
    damping_per_m2_s_.push_back(0.5 * (equation[i].damping_per_m2_s + equation[i + 1].damping_per_m2_s));
  }

  input_.assign(passes() * samples_, Lanes::Zero());
  const auto input = [&](std::size_t sample, std::size_t lane) -> double& {
    return input_[lane / width * samples_ + sample][static_cast<Eigen::Index>(lane % width)];
  };
  for (std::size_t i = 0; i < samples_; ++i) {
    const double authority = equation[i].authority_per_m_s2;
    const NodeShare share = node_share(nodes, record.time_s[i]);
    input(i, share.left) += authority * (1.0 - share.right_share);
    input(i, share.right) += authority * share.right_share;
    input(i, canard_column()) = authority * record.canard_rad[i];
    if (lag_columns_ > 0) {
      input(i, lag_column()) = authority * record.canard_rate_rad_s[i];
    }
  }

  for (std::size_t s = 0; s < record.segment_begin.size(); ++s) {
    const std::size_t at = record.segment_begin[s];
    Reset reset{.sample = at, .start = std::vector<State>(passes(), {.angle = Lanes::Zero(), .rate = Lanes::Zero()})};
    const auto set = [&reset](Lanes State::* what, std::size_t lane, double value) {
      (reset.start[lane / width].*what)[static_cast<Eigen::Index>(lane % width)] = value;
    };
    if (start == Start::fitted) {
      set(&State::angle, nodes_ + 2 * s, 1.0);
      set(&State::rate, nodes_ + 2 * s + 1, 1.0);
    } else {
      set(&State::angle, free_column(), record.roll_angle_rad[at]);
      set(&State::rate, free_column(), record.roll_rate_rad_s[at]);
    }
    resets_.push_back(std::move(reset));
  }
}

void ResponseBasis::respond(double alpha_m2, Eigen::MatrixXd& angles) const {
  angles.resize(static_cast<Eigen::Index>(samples_), static_cast<Eigen::Index>(columns()));
  Steps steps;
  for (std::size_t s = 0; s < resets_.size(); ++s) {
    const std::size_t last = (s + 1 < resets_.size() ? resets_[s + 1].sample : samples_) - 1;
    std::vector<State> state = resets_[s].start;
    for (std::size_t i = resets_[s].sample; i <= last; i += stretch) {
      const std::size_t count = std::min(stretch, last - i);
      fill(steps, alpha_m2, damping_per_m2_s_.data() + i, dt_s_.data() + i, count);
      for (std::size_t pass = 0; pass < passes(); ++pass) {
        advance(pass, i, {steps.data(), count}, state[pass], angles);
      }
    }
  }
}

// Writes the angles before each of the steps, and those behind the last one.
void ResponseBasis::advance(std::size_t pass, std::size_t first, std::span<const RampStep> steps, State& state,
                            Eigen::MatrixXd& angles) const {
  // Lanes behind the last column are written into it before it is, and so lost.
  std::array<double*, width> out{};
  for (std::size_t j = 0; j < width; ++j) {
    out[j] =
        &angles(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(std::min(pass * width + j, columns() - 1)));
  }
  const auto write = [&](std::size_t at, const Lanes& angle) {
    for (std::size_t j = width; j-- > 0;) {
      out[j][at] = angle[static_cast<Eigen::Index>(j)];
    }
  };
  const Lanes* input = &input_[pass * samples_ + first];
  Lanes angle = state.angle;
  // Strongly damped rates would shrink to the end of a double's range and stay there, where a processor takes several
  // times as long.
  constexpr double nothing_rad_s = 1e-200;
  Lanes rate = (state.rate.abs() < nothing_rad_s).select(0.0, state.rate);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    write(i, angle);
    angle += steps[i].angle_change(rate, input[i], input[i + 1]);
    rate = steps[i].rate_after(rate, input[i], input[i + 1]);
  }
  write(steps.size(), angle);
  state = {.angle = angle, .rate = rate};
}

AlphaFit::AlphaFit(const ResponseBasis& basis, double alpha_m2)
    : alpha_m2_{alpha_m2},
      nodes_{static_cast<Eigen::Index>(basis.nodes())},
      lag_column_{static_cast<Eigen::Index>(basis.lag_column())},
      angles_{responses(basis, alpha_m2)},
      fit_{angles_, static_cast<Eigen::Index>(basis.canard_column())} {}

std::optional<double> AlphaFit::best_beta_m() const {
  constexpr double explained = 1e-6;
  const double squared = canard_rest().squaredNorm();
  if (!(std::sqrt(squared) > explained * fit_.length_before(canard_rest(), canard_side))) {
    return std::nullopt;
  }
  return canard_rest().dot(rest()) / squared;
}

double AlphaFit::least_squares_rad2() const {
  const auto beta_m = best_beta_m();
  return (rest() - beta_m.value_or(0.0) * canard_rest()).squaredNorm();
}

SquaresOverBeta AlphaFit::squares_over_beta() const {
  return {.measured = rest().squaredNorm(), .both = rest().dot(canard_rest()), .canards = canard_rest().squaredNorm()};
}

std::vector<double> AlphaFit::mean_abs_error_rad(const Axis& beta_m) const {
  // A few rows at a time stay in registers while they go along the axis.
  constexpr Eigen::Index together = 8;
  using Rows = Eigen::Array<double, together, 1>;
  std::vector<double> sums(beta_m.values().size(), 0.0);
  const auto add = [&](auto error, const auto& change) {
    for (double& sum : sums) {
      sum += error.abs().sum();
      error -= change;
    }
  };
  const Eigen::Index rows = angles_.rows();
  Eigen::Index i = 0;
  for (; i + together <= rows; i += together) {
    const Rows canard = canard_rest().segment<together>(i);
    add(Rows{rest().segment<together>(i).array() - beta_m.first * canard}, Rows{beta_m.step * canard});
  }
  for (; i < rows; ++i) {
    using Row = Eigen::Array<double, 1, 1>;
    add(Row{rest()(i) - beta_m.first * canard_rest()(i)}, Row{beta_m.step * canard_rest()(i)});
  }
  for (double& sum : sums) {
    sum /= static_cast<double>(rows);
  }
  return sums;
}

RollModel AlphaFit::model(double beta_m, const NodeTimes& node_time_s) const {
  const Eigen::VectorXd all = fit_.coefficients(measured_side) - beta_m * fit_.coefficients(canard_side);
  RollModel model{.alpha_m2 = alpha_m2_, .beta_m = beta_m, .node_time_s = node_time_s, .node_rad = {}, .initial = {}};
  for (Eigen::Index k = 0; k < nodes_; ++k) {
    model.node_rad.push_back(all(k) / beta_m);
  }
  for (Eigen::Index k = nodes_; k < lag_column_; k += 2) {
    model.initial.push_back({.angle_rad = all(k), .rate_rad_s = all(k + 1)});
  }
  return model;
}

double AlphaFit::further_lag_s(double beta_m) const {
  return fit_.coefficients(measured_side)(lag_column_) / beta_m - fit_.coefficients(canard_side)(lag_column_);
}

}  // namespace fantail::identify::model
