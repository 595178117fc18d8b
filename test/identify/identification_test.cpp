// SPDX-License-Identifier: MIT
#include "identify/identification.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <gtest/gtest.h>

#include "identify/model/planted.hpp"
#include "text/error.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

constexpr Options quick{.with_error_map = false};

TEST(Identification, APlantedModelComesBack) {
  const Planting planting{.node_time_s = {0.0, 2.0, 4.0}, .node_deg = {-1.0, -6.0, -5.0}};
  Options options = quick;
  options.nodes = planting.node_time_s;
  const Identification found = identify(planted_record(planting), tasha, options);
  EXPECT_NEAR(found.model.alpha_m2, planting.alpha_m2, 0.05);
  EXPECT_NEAR(found.model.beta_m, planting.beta_m, 0.05);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.model.node_rad[k] / radians_per_degree, planting.node_deg[k], 0.05);
  }
  EXPECT_EQ(found.samples, 401U);
  EXPECT_DOUBLE_EQ(found.seconds, 4.0);
}

TEST(Identification, AFittedStartForgivesAWrongFirstSample) {
  Record record = planted_record({});
  record.roll_angle_rad.front() += 5.0 * radians_per_degree;
  record.roll_rate_rad_s.front() += 30.0 * radians_per_degree;
  Options options = quick;
  options.start = Start::fitted;
  const Identification fitted = identify(record, tasha, options);
  const Identification measured = identify(record, tasha, quick);
  EXPECT_NEAR(fitted.model.alpha_m2, 20.0, 0.3);
  EXPECT_NEAR(fitted.model.initial[0].angle_rad / radians_per_degree, 3.0, 1.0);
  EXPECT_GT(std::abs(measured.model.alpha_m2 - 20.0), 1.0);
}

TEST(Identification, BehindAGapTheModelStartsAnew) {
  Record record = planted_record({});
  // Whatever the canards did meanwhile is not in the log.
  const auto cut = [](std::vector<double>& values) { values.erase(values.begin() + 150, values.begin() + 220); };
  for (auto* values : {&record.time_s, &record.roll_angle_rad, &record.roll_rate_rad_s, &record.canard_rad,
                       &record.speed_m_s, &record.density_kg_m3}) {
    cut(*values);
  }
  record.segment_begin = {0, 150};
  const Identification found = identify(record, tasha, quick);
  EXPECT_NEAR(found.model.alpha_m2, 20.0, 0.1);
  EXPECT_NEAR(found.model.beta_m, 9.0, 0.05);
  EXPECT_EQ(found.model.initial.size(), 2U);
}

TEST(Identification, UnevenSampleTimesAreNoMatter) {
  const Record dense = planted_record({.sample_hz = 1000.0});
  Record record;
  record.window = "uneven";
  std::size_t at = 0;
  for (std::size_t i = 0; at < dense.size(); ++i) {
    record.time_s.push_back(dense.time_s[at]);
    record.roll_angle_rad.push_back(dense.roll_angle_rad[at]);
    record.roll_rate_rad_s.push_back(dense.roll_rate_rad_s[at]);
    record.canard_rad.push_back(dense.canard_rad[at]);
    record.speed_m_s.push_back(dense.speed_m_s[at]);
    record.density_kg_m3.push_back(dense.density_kg_m3[at]);
    at += 3 + (i * 7) % 11;
  }
  const Identification found = identify(record, tasha, quick);
  EXPECT_NEAR(found.model.alpha_m2, 20.0, 0.1);
  EXPECT_NEAR(found.model.beta_m, 9.0, 0.05);
}

TEST(Identification, NodesAreAddedUntilOneMoreIsNotWorthIt) {
  const Planting planting{.node_time_s = {0.0, 1.0, 2.0, 3.0}, .node_deg = {0.0, -8.0, -1.0, -7.0}, .seconds = 3.0};
  Record record = planted_record(planting);
  add_noise(record, {.angle_deg = 0.1}, 4);
  Options options = quick;
  options.nodes = AutomaticNodes{.most = 6};
  const Identification found = identify(record, tasha, options);
  ASSERT_EQ(found.node_trials.size(), 6U);
  EXPECT_EQ(found.model.node_time_s.size(), 4U);  // three intervals, as planted
  EXPECT_GT(found.node_trials[1].mean_abs_angle_error_rad, 2.0 * found.node_trials[2].mean_abs_angle_error_rad);
}

TEST(Identification, AHundredthOfADegreeIsNotWorthANode) {
  // Constant but for a bend whose trace in the roll angle stays below that.
  const Planting planting{.node_time_s = {0.0, 2.0, 4.0}, .node_deg = {-5.0, -5.0005, -5.0}};
  Options options = quick;
  options.nodes = AutomaticNodes{.most = 6};
  const Identification found = identify(planted_record(planting), tasha, options);
  EXPECT_EQ(found.model.node_time_s.size(), 2U);
}

// The published grid need not reach a rocket of another size.
TEST(Identification, ThePictureOfTheErrorShowsTheContinuousAnswer) {
  Record record = planted_record({});
  add_noise(record, {.angle_deg = 0.1}, 4);
  for (const auto& [alpha_m2, beta_m] :
       {std::pair{Axis{30.0, 40.0, 1.0}, Axis{20.0, 30.0, 1.0}}, std::pair{Axis{1.0, 2.0, 0.1}, Axis{0.1, 1.0, 0.1}},
        std::pair{Axis{1.0, 60.0, 1.0}, Axis{9.0, 20.0, 1.0}}}) {
    const Identification found = identify(record, tasha, {.grid = {.alpha_m2 = alpha_m2, .beta_m = beta_m}});
    ASSERT_TRUE(found.error_map);
    const auto shows = [](const std::vector<double>& values, const Interval& known) {
      return values.front() <= *known.low && values.back() >= *known.high && *known.low < *known.high;
    };
    EXPECT_TRUE(shows(found.error_map->alpha_m2, found.uncertainty->alpha_profile_m2)) << alpha_m2.first;
    EXPECT_TRUE(shows(found.error_map->beta_m, found.uncertainty->interval[1])) << beta_m.first;
    // The darkest cell is next to the answer.
    const auto& errors = found.error_map->mean_abs_angle_error_rad;
    const auto best = static_cast<std::size_t>(std::ranges::min_element(errors) - errors.begin());
    const std::vector<double>& betas = found.error_map->beta_m;
    EXPECT_NEAR(betas[best / found.error_map->alpha_m2.size()], found.model.beta_m, 1.5 * (betas[1] - betas[0]));
  }
}

TEST(Identification, AWinnerOnTheEdgeOfTheGridIsSaidToBeOne) {
  Options options = quick;
  options.method = Method::grid;
  options.grid.alpha_m2 = {30.0, 40.0, 1.0};
  const Identification found = identify(planted_record({}), tasha, options);
  EXPECT_EQ(found.model.alpha_m2, 30.0);
  EXPECT_TRUE(found.on_grid_edge);
  ASSERT_EQ(found.remarks.size(), 1U);
  EXPECT_NE(found.remarks[0].find("edge"), std::string::npos);
}

TEST(Identification, TheGridsWinnerIsTheCellNextToThePlantedModel) {
  Options options = quick;
  options.method = Method::grid;
  const Identification found = identify(planted_record({}), tasha, options);
  EXPECT_EQ(found.model.alpha_m2, 20.0);
  EXPECT_EQ(found.model.beta_m, 9.0);
  EXPECT_TRUE(found.remarks.empty());
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const text::Error& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Identification, FewerSamplesThanUnknownsAreRefused) {
  const Record record = planted_record({.seconds = 0.03});
  EXPECT_EQ(refusal([&] { (void)identify(record, tasha, {.nodes = EvenNodes{3}}); }),
            "window planted: 4 samples for 6 unknowns; there must be more samples than unknowns");
}

TEST(Identification, StillAirIsRefused) {
  const Record record = planted_record({.speed_begin_m_s = 0.0, .speed_end_m_s = 0.0});
  EXPECT_EQ(refusal([&] { (void)identify(record, tasha, {}); }),
            "window planted: the speed is never above zero, so nothing can be identified");
}

}  // namespace
}  // namespace fantail::identify
