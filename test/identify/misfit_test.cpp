// SPDX-License-Identifier: MIT
#include "identify/misfit.hpp"

#include <gtest/gtest.h>

#include "identify/identification.hpp"
#include "identify/planted.hpp"

namespace fantail::identify {
namespace {

// Two nodes for a planted roll with white noise at angle and rate.
std::optional<std::string> misfit_of(const Planting& planting, double rate_noise_deg_s = 1.0) {
  Record record = planted_record(planting);
  add_noise(record, {.angle_deg = 0.1, .rate_deg_s = rate_noise_deg_s}, 1);
  const Identification found = identify(record, tasha, {.with_uncertainty = false, .with_error_map = false});
  return misfit(record, found);
}

TEST(Misfit, IsNotSeenInNoise) {
  EXPECT_FALSE(misfit_of({}));
  EXPECT_FALSE(misfit_of({.sample_hz = 1000.0}));
}

TEST(Misfit, IsSeenWhenADisturbanceHasMoreKinksThanTheModel) {
  const Planting kinked{.node_time_s = {0.0, 1.0, 2.0, 3.0, 4.0}, .node_deg = {0.0, -7.0, -2.0, -8.0, -3.0}};
  EXPECT_TRUE(misfit_of(kinked));
  EXPECT_TRUE(misfit_of({.node_time_s = kinked.node_time_s, .node_deg = kinked.node_deg, .sample_hz = 1000.0}));
}

TEST(Misfit, OfAHundredthIsNotWorthAWord) { EXPECT_FALSE(misfit_of({}, 0.0)); }

}  // namespace
}  // namespace fantail::identify
