// SPDX-License-Identifier: MIT
// What is stated must be so: of a thousand noisy records of one truth, the truth lies inside the stated interval in 95
// %, give or take; less than 93 % would be a claim of more than is known.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/identification.hpp"
#include "identify/model/planted.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;

struct Case {
  std::string name;
  Noise noise;
  Start start;
};

class Coverage : public testing::TestWithParam<Case> {};

TEST_P(Coverage, PlantedNumbersLieInsideTheStatedIntervals) {
  constexpr int records = 1000;
  constexpr int least_inside = 930;
  constexpr std::uint64_t first_seed = 20151204;
  const Planting planting{.node_time_s = {0.0, 1.5, 3.0}, .node_deg = {-4.0, -6.0, -5.0}, .seconds = 3.0};
  const Record clean = planted_record(planting);
  std::vector<double> truth{planting.alpha_m2, planting.beta_m};
  for (const double angle_deg : planting.node_deg) {
    truth.push_back(radians_per_degree * angle_deg);
  }
  std::vector<int> inside(truth.size(), 0);
  int inside_profile = 0;
  for (int i = 0; i < records; ++i) {
    Record record = clean;
    add_noise(record, GetParam().noise, first_seed + static_cast<std::uint64_t>(i));
    const Identification found =
        identify(record, tasha, {.nodes = planting.node_time_s, .start = GetParam().start, .with_error_map = false});
    const Uncertainty& known = *found.uncertainty;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      inside[k] += *known.interval[k].low <= truth[k] && truth[k] <= *known.interval[k].high ? 1 : 0;
    }
    const Interval& profile = known.alpha_profile_m2;
    inside_profile += profile.low.value_or(0.0) <= planting.alpha_m2 &&
                              planting.alpha_m2 <= profile.high.value_or(alpha_range(tasha).highest_m2)
                          ? 1
                          : 0;
  }
  for (std::size_t k = 0; k < truth.size(); ++k) {
    RecordProperty("inside_" + std::to_string(k), inside[k]);
  }
  RecordProperty("inside_profile", inside_profile);
  SCOPED_TRACE("seeds from " + std::to_string(first_seed));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_GE(inside[k], least_inside) << "number " << k << " of alpha, beta, nodes";
  }
  EXPECT_GE(inside_profile, least_inside) << "alpha, by its profile";
  // Nor may an interval be right because it is boundless.
  EXPECT_LT(*std::ranges::min_element(inside), records);
}

INSTANTIATE_TEST_SUITE_P(
    Noises, Coverage,
    testing::Values(Case{"white", {.angle_deg = 0.3, .correlation_s = 0.0}, Start::measured},
                    Case{"white_start_fitted", {.angle_deg = 0.3, .correlation_s = 0.0}, Start::fitted},
                    Case{"correlated", {.angle_deg = 0.3, .correlation_s = 0.03}, Start::measured},
                    Case{"correlated_start_fitted", {.angle_deg = 0.3, .correlation_s = 0.03}, Start::fitted},
                    Case{"long_memory", {.angle_deg = 0.3, .correlation_s = 0.1}, Start::measured}),
    [](const testing::TestParamInfo<Case>& each) { return each.param.name; });

}  // namespace
}  // namespace fantail::identify::result
