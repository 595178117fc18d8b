// SPDX-License-Identifier: MIT
#include "benchmark/identify_answer.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace fantail::benchmark {
namespace {

constexpr double degrees_per_radian = 57.29577951308232;

// The index of a value in an axis that has it.
std::size_t index_of(double value, const std::vector<double>& axis) {
  const auto off = [value](double each) { return std::abs(each - value); };
  return static_cast<std::size_t>(std::ranges::min_element(axis, {}, off) - axis.begin());
}

double largest_difference_rad(const identify::model::ErrorMap& found, const identify::model::ErrorMap& expected) {
  double largest = 0.0;
  for (std::size_t j = 0; j < found.beta_m.size(); ++j) {
    const std::size_t row = index_of(found.beta_m[j], expected.beta_m) * expected.alpha_m2.size();
    for (std::size_t i = 0; i < found.alpha_m2.size(); ++i) {
      const double error = found.mean_abs_angle_error_rad[j * found.alpha_m2.size() + i];
      const std::size_t cell = row + index_of(found.alpha_m2[i], expected.alpha_m2);
      largest = std::max(largest, std::abs(error - expected.mean_abs_angle_error_rad[cell]));
    }
  }
  return largest;
}

}  // namespace

const IdentifyTask& task_of(const ::benchmark::State& state) {
  return identify_task(SampleRate{static_cast<int>(state.range(0))});
}

void tell(::benchmark::State& state, const identify::model::RollModel& model) {
  state.counters["alpha_m2"] = model.alpha_m2;
  state.counters["beta_m"] = model.beta_m;
  for (std::size_t k = 0; k < model.node_rad.size(); ++k) {
    state.counters["node_" + std::to_string(k) + "_deg"] = model.node_rad[k] * degrees_per_radian;
  }
}

void tell_grid(::benchmark::State& state, const identify::model::GridResult& found) {
  tell(state, found.model);
  state.counters["points"] = static_cast<double>(found.errors.mean_abs_angle_error_rad.size());
  state.counters["largest_difference_deg"] =
      degrees_per_radian * largest_difference_rad(found.errors, task_of(state).expected.errors);
}

}  // namespace fantail::benchmark
