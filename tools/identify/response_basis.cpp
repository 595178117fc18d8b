// SPDX-License-Identifier: MIT
#include "identify/response_basis.hpp"

#include <array>
#include <cmath>

#include "identify/node_times.hpp"
#include "identify/ramp_transition.hpp"

namespace fantail::identify {
namespace {

constexpr std::size_t coefficients_per_step = 6;

// Step coefficients of one alpha, in the order that pass() reads them.
std::vector<double> step_coefficients(double alpha_m2, const std::vector<double>& dt_s,
                                      const std::vector<double>& damping_per_m2_s) {
  std::vector<double> all(dt_s.size() * coefficients_per_step);
  double last_dt_s = -1.0;
  double last_damping = -1.0;
  RampTransition t{};
  for (std::size_t i = 0; i < dt_s.size(); ++i) {
    // In a tunnel every step is the same.
    if (dt_s[i] != last_dt_s || damping_per_m2_s[i] != last_damping) {
      last_dt_s = dt_s[i];
      last_damping = damping_per_m2_s[i];
      t = ramp_transition(alpha_m2 * last_damping, last_dt_s);
    }
    double* out = &all[i * coefficients_per_step];
    out[0] = t.decay;
    out[1] = t.rate_0;
    out[2] = t.rate_1;
    out[3] = t.angle_p;
    out[4] = t.angle_0;
    out[5] = t.angle_1;
  }
  return all;
}

}  // namespace

double step_s(double from_s, double to_s) { return 1e-9 * std::round((to_s - from_s) * 1e9); }

double damping_per_m2_s(const Airframe& airframe, double density_kg_m3, double speed_m_s) {
  return 0.5 * density_kg_m3 * std::abs(speed_m_s) * airframe.reference_area_m2 / airframe.inertia_kg_m2;
}

double authority_per_m_s2(const Airframe& airframe, double density_kg_m3, double speed_m_s) {
  return damping_per_m2_s(airframe, density_kg_m3, speed_m_s) * std::abs(speed_m_s);
}

ResponseBasis::ResponseBasis(const Record& record, const Airframe& airframe, const NodeTimes& nodes, Start start)
    : samples_{record.size()},
      nodes_{nodes.size()},
      initial_columns_{start == Start::fitted ? 2 * record.segment_begin.size() : 0} {
  measured_rad_ = Eigen::Map<const Eigen::VectorXd>(record.roll_angle_rad.data(), static_cast<Eigen::Index>(samples_));
  for (std::size_t i = 0; i + 1 < samples_; ++i) {
    dt_s_.push_back(step_s(record.time_s[i], record.time_s[i + 1]));
    const auto damping = [&](std::size_t at) {
      return damping_per_m2_s(airframe, record.density_kg_m3[at], record.speed_m_s[at]);
    };
    damping_per_m2_s_.push_back(0.5 * (damping(i) + damping(i + 1)));
  }

  const std::size_t passes = (columns() + width - 1) / width;
  input_.assign(passes * samples_ * width, 0.0);
  const auto input = [&](std::size_t sample, std::size_t lane) -> double& {
    return input_[(lane / width * samples_ + sample) * width + lane % width];
  };
  for (std::size_t i = 0; i < samples_; ++i) {
    const double authority = authority_per_m_s2(airframe, record.density_kg_m3[i], record.speed_m_s[i]);
    const NodeShare share = node_share(nodes, record.time_s[i]);
    input(i, share.left) += authority * (1.0 - share.right_share);
    input(i, share.right) += authority * share.right_share;
    input(i, canard_column()) = authority * record.canard_rad[i];
  }

  for (std::size_t s = 0; s < record.segment_begin.size(); ++s) {
    const std::size_t at = record.segment_begin[s];
    Reset reset{
        .sample = at, .angle = std::vector<double>(passes * width), .rate = std::vector<double>(passes * width)};
    if (start == Start::fitted) {
      reset.angle[nodes_ + 2 * s] = 1.0;
      reset.rate[nodes_ + 2 * s + 1] = 1.0;
    } else {
      reset.angle[free_column()] = record.roll_angle_rad[at];
      reset.rate[free_column()] = record.roll_rate_rad_s[at];
    }
    resets_.push_back(std::move(reset));
  }
}

void ResponseBasis::respond(double alpha_m2, Eigen::MatrixXd& angles) const {
  angles.resize(static_cast<Eigen::Index>(samples_), static_cast<Eigen::Index>(columns()));
  const std::vector<double> coefficients = step_coefficients(alpha_m2, dt_s_, damping_per_m2_s_);
  for (std::size_t lane = 0; lane < columns(); lane += width) {
    pass(lane, coefficients, angles);
  }
}

void ResponseBasis::pass(std::size_t first_lane, const std::vector<double>& coefficients,
                         Eigen::MatrixXd& angles) const {
  std::array<double, width> angle{};
  std::array<double, width> rate{};
  const double* input = &input_[first_lane * samples_];
  const std::size_t lanes = std::min(width, columns() - first_lane);
  std::array<double*, width> out{};
  for (std::size_t j = 0; j < lanes; ++j) {
    out[j] = angles.col(static_cast<Eigen::Index>(first_lane + j)).data();
  }
  for (std::size_t s = 0; s < resets_.size(); ++s) {
    for (std::size_t j = 0; j < width; ++j) {
      angle[j] = resets_[s].angle[first_lane + j];
      rate[j] = resets_[s].rate[first_lane + j];
    }
    const std::size_t end = s + 1 < resets_.size() ? resets_[s + 1].sample : samples_;
    for (std::size_t i = resets_[s].sample;; ++i) {
      for (std::size_t j = 0; j < lanes; ++j) {
        out[j][i] = angle[j];
      }
      if (i + 1 == end) {
        break;
      }
      const double* c = &coefficients[i * coefficients_per_step];
      const double* from = &input[i * width];
      for (std::size_t j = 0; j < width; ++j) {
        angle[j] += c[3] * rate[j] + (c[4] * from[j] + c[5] * from[width + j]);
        rate[j] = c[0] * rate[j] + (c[1] * from[j] + c[2] * from[width + j]);
      }
    }
  }
}

}  // namespace fantail::identify
