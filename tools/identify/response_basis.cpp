// SPDX-License-Identifier: MIT
#include "identify/response_basis.hpp"

#include <array>
#include <cmath>

#include "identify/node_times.hpp"
#include "identify/ramp_transition.hpp"

namespace fantail::identify {
namespace {

// So many steps at a time that their transitions stay in the nearest cache until all lanes have taken them.
constexpr std::size_t stretch = 64;
using Transitions = std::array<RampTransition, stretch>;

void fill(Transitions& all, double alpha_m2, const double* damping_per_m2_s, const double* dt_s, std::size_t steps) {
  constexpr std::size_t together = 4;
  using Numbers = Eigen::Array<double, together, 1>;
  std::size_t i = 0;
  while (i < steps) {
    if (i + together <= steps) {
      const Numbers dt{Eigen::Map<const Numbers>{&dt_s[i]}};
      const Numbers damping = alpha_m2 * Eigen::Map<const Numbers>{&damping_per_m2_s[i]} * dt;
      if ((damping < small_ramp_damping).all()) {
        const RampTransitionOf<Numbers> t = small_ramp_transition(damping, dt);
        for (Eigen::Index j = 0; j < Eigen::Index{together}; ++j, ++i) {
          all[i] = {t.decay[j], t.rate_0[j], t.rate_1[j], t.angle_p[j], t.angle_0[j], t.angle_1[j]};
        }
        continue;
      }
    }
    all[i] = ramp_transition(alpha_m2 * damping_per_m2_s[i], dt_s[i]);
    ++i;
  }
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

  input_.assign(passes() * samples_, Lanes::Zero());
  const auto input = [&](std::size_t sample, std::size_t lane) -> double& {
    return input_[lane / width * samples_ + sample][static_cast<Eigen::Index>(lane % width)];
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
  Transitions transitions;
  for (std::size_t s = 0; s < resets_.size(); ++s) {
    const std::size_t last = (s + 1 < resets_.size() ? resets_[s + 1].sample : samples_) - 1;
    std::vector<State> state = resets_[s].start;
    for (std::size_t i = resets_[s].sample; i <= last; i += stretch) {
      const std::size_t steps = std::min(stretch, last - i);
      fill(transitions, alpha_m2, damping_per_m2_s_.data() + i, dt_s_.data() + i, steps);
      for (std::size_t pass = 0; pass < passes(); ++pass) {
        advance(pass, i, {transitions.data(), steps}, state[pass], angles);
      }
    }
  }
}

// Writes the angles before each of the steps, and those behind the last one.
void ResponseBasis::advance(std::size_t pass, std::size_t first, std::span<const RampTransition> steps, State& state,
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
    const RampTransition& t = steps[i];
    angle += t.angle_p * rate + (t.angle_0 * input[i] + t.angle_1 * input[i + 1]);
    rate = t.decay * rate + (t.rate_0 * input[i] + t.rate_1 * input[i + 1]);
  }
  write(steps.size(), angle);
  state = {.angle = angle, .rate = rate};
}

}  // namespace fantail::identify
