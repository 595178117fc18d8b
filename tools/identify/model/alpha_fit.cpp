// SPDX-License-Identifier: MIT
#include "identify/model/alpha_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fantail::identify::model {
namespace {

// So many at a time that they stay in the nearest cache until all lanes have taken them.
constexpr std::size_t stretch = 64;
constexpr std::size_t group = 8;

// RampStep of each, every number of them in a list of its own.
struct Steps {
  std::array<double, stretch> decay, rate_0, rate_1, angle_p, angle_0, angle_1;
};

// Of `count` steps, and of some behind them: a group at a time, which are nearly always all small or all not.
FANTAIL_AS_WIDE_AS_THE_PROCESSOR
void fill(Steps& __restrict all, double alpha_m2, const double* __restrict damping_per_m2_s,
          const double* __restrict dt_s, std::size_t count) {
  const auto put = [&all](std::size_t i, const RampStep& step) {
    all.decay[i] = step.decay;
    all.rate_0[i] = step.rate_0;
    all.rate_1[i] = step.rate_1;
    all.angle_p[i] = step.angle_p;
    all.angle_0[i] = step.angle_0;
    all.angle_1[i] = step.angle_1;
  };
  for (std::size_t i = 0; i < count; i += group) {
    bool all_small = true;
    for (std::size_t j = i; j < i + group; ++j) {
      all_small &= alpha_m2 * damping_per_m2_s[j] * dt_s[j] < small_damping;
    }
    if (all_small) {
      for (std::size_t j = i; j < i + group; ++j) {
        put(j, small_ramp_step(alpha_m2 * damping_per_m2_s[j] * dt_s[j], dt_s[j]));
      }
    } else {
      for (std::size_t j = i; j < i + group; ++j) {
        put(j, ramp_step(alpha_m2 * damping_per_m2_s[j], dt_s[j]));
      }
    }
  }
}

void write(const std::array<double*, lanes>& columns, std::size_t row, const Four& angle) {
  for (std::size_t lane = lanes; lane-- > 0;) {
    columns[lane][row] = angle[lane];
  }
}

// Writes the angles before each of the steps, and those behind the last one.
FANTAIL_AS_WIDE_AS_THE_PROCESSOR
void advance(const Steps& steps, std::size_t count, const double* input, double* angle_now, double* rate_now,
             const std::array<double*, lanes>& columns) {
  Four angle = four_at(angle_now);
  Four rate = four_at(rate_now);
  // Strongly damped rates would shrink to the end of a double's range and stay there, where a processor takes several
  // times as long.
  constexpr double nothing_rad_s = 1e-200;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    rate[lane] = std::abs(rate[lane]) < nothing_rad_s ? 0.0 : rate[lane];
  }
  for (std::size_t i = 0; i < count; ++i) {
    write(columns, i, angle);
    const RampStep step{.decay = steps.decay[i],
                        .rate_0 = steps.rate_0[i],
                        .rate_1 = steps.rate_1[i],
                        .angle_p = steps.angle_p[i],
                        .angle_0 = steps.angle_0[i],
                        .angle_1 = steps.angle_1[i]};
    const Four before = four_at(&input[i * lanes]);
    const Four behind = four_at(&input[(i + 1) * lanes]);
    angle += step.angle_change(rate, before, behind);
    rate = step.rate_after(rate, before, behind);
  }
  write(columns, count, angle);
  four_at(angle_now) = angle;
  four_at(rate_now) = rate;
}

// The free motion's column becomes what is to be explained.
Eigen::MatrixXd responses(const ResponseBasis& basis, double alpha_m2) {
  Eigen::MatrixXd angles;
  basis.respond(alpha_m2, angles);
  const auto free = static_cast<Eigen::Index>(basis.free_column());
  angles.col(free) = basis.measured_rad() - angles.col(free);
  return angles;
}

// Adds |rest - beta canard_rest| of every row to the sum of each beta. A few rows stay in registers while they go along
// the axis.
FANTAIL_AS_WIDE_AS_THE_PROCESSOR
void add_abs_errors(std::span<double> sums, const double* rest, const double* canard_rest, std::size_t rows,
                    const Axis& beta_m) {
  std::vector<double> wide_sums(sums.size() * lanes, 0.0);
  const std::size_t whole = rows / (2 * lanes) * (2 * lanes);
  for (std::size_t i = 0; i < whole; i += 2 * lanes) {
    const Four first_change = beta_m.step * four_at(&canard_rest[i]);
    const Four second_change = beta_m.step * four_at(&canard_rest[i + lanes]);
    Four first = four_at(&rest[i]) - beta_m.first * four_at(&canard_rest[i]);
    Four second = four_at(&rest[i + lanes]) - beta_m.first * four_at(&canard_rest[i + lanes]);
    for (std::size_t j = 0; j < wide_sums.size(); j += lanes) {
      four_at(&wide_sums[j]) += magnitude(first) + magnitude(second);
      first -= first_change;
      second -= second_change;
    }
  }
  for (std::size_t j = 0; j < sums.size(); ++j) {
    sums[j] += sum(four_at(&wide_sums[j * lanes]));
  }
  for (std::size_t i = whole; i < rows; ++i) {
    double error = rest[i] - beta_m.first * canard_rest[i];
    for (double& sum : sums) {
      sum += std::abs(error);
      error -= beta_m.step * canard_rest[i];
    }
  }
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

  dt_s_.resize(dt_s_.size() + group, 0.0);
  damping_per_m2_s_.resize(damping_per_m2_s_.size() + group, 0.0);

  input_.assign(passes() * samples_ * lanes, 0.0);
  const auto add_input = [&](std::size_t sample, std::size_t column, double per_beta) {
    input_[(column / lanes * samples_ + sample) * lanes + column % lanes] += per_beta;
  };
  for (std::size_t i = 0; i < samples_; ++i) {
    const double authority = equation[i].authority_per_m_s2;
    const NodeShare share = node_share(nodes, record.time_s[i]);
    add_input(i, share.left, authority * (1.0 - share.right_share));
    add_input(i, share.right, authority * share.right_share);
    add_input(i, canard_column(), authority * record.canard_rad[i]);
    if (lag_columns_ > 0) {
      add_input(i, lag_column(), authority * record.canard_rate_rad_s[i]);
    }
  }

  for (std::size_t s = 0; s < record.segment_begin.size(); ++s) {
    const std::size_t at = record.segment_begin[s];
    Reset reset{.sample = at, .start = std::vector<State>(passes(), State{})};
    const auto set = [&reset](std::array<double, lanes> State::* what, std::size_t column, double value) {
      (reset.start[column / lanes].*what)[column % lanes] = value;
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
        // Lanes behind the last column are written into it before it is, and so lost.
        std::array<double*, lanes> out{};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          out[lane] = &angles(static_cast<Eigen::Index>(i),
                              static_cast<Eigen::Index>(std::min(pass * lanes + lane, columns() - 1)));
        }
        advance(steps, count, &input_[(pass * samples_ + i) * lanes], state[pass].angle.data(), state[pass].rate.data(),
                out);
      }
    }
  }
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
  std::vector<double> sums(beta_m.values().size(), 0.0);
  const auto rows = static_cast<std::size_t>(angles_.rows());
  add_abs_errors(sums, rest().data(), canard_rest().data(), rows, beta_m);
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
