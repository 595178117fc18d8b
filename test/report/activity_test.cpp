// SPDX-License-Identifier: MIT
#include "report/activity.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "text/degrees.hpp"

namespace fantail::report {
namespace {

constexpr double settling_s = 1.0;

/// Five seconds under control at 1 kHz, the canards at an angle in degrees that is a function of time.
std::vector<flight::Row> canards_at(const std::function<double(double time_s)>& angle_deg) {
  std::vector<flight::Row> rows(5000);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].time_s = static_cast<double>(i) / 1000.0;
    rows[i].canard_rad = text::radians(angle_deg(rows[i].time_s));
    rows[i].command_rad = *rows[i].canard_rad;
  }
  return rows;
}

std::optional<Oscillation> find_oscillation(const std::vector<flight::Row>& control) {
  OscillationWatch watch{settling_s};
  for (const flight::Row& row : control) {
    watch.add(row);
  }
  return watch.found();
}

double sine(double frequency_hz, double time_s) { return std::sin(2.0 * std::numbers::pi * frequency_hz * time_s); }

TEST(Oscillation, HasTheFrequencyAndTheEndsOfTheSwing) {
  for (const double frequency_hz : {4.0, 13.0, 40.0}) {
    const auto rows = canards_at([&](double t) { return 3.5 + 4.8 * sine(frequency_hz, t); });
    const auto found = find_oscillation(rows);
    ASSERT_TRUE(found) << frequency_hz;
    EXPECT_NEAR(found->frequency_hz, frequency_hz, 0.05 * frequency_hz);
    EXPECT_NEAR(text::degrees(found->lowest_rad), -1.3, 0.1);
    EXPECT_NEAR(text::degrees(found->highest_rad), 8.3, 0.1);
    EXPECT_NEAR(found->from_s, 1.0, 1e-6);
  }
}

TEST(Oscillation, IsNoneWhereTheCanardsStandCreepOrTremble) {
  EXPECT_FALSE(find_oscillation({}));
  EXPECT_FALSE(find_oscillation(canards_at([](double) { return 5.0; })));
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 3.0 * t; })));
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 5.0 + 0.9 * sine(13.0, t); })));
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 5.0 * sine(1.0, t); })))
      << "slower than three swings a second";
}

TEST(Oscillation, IsNoneWhereASwingDiesAway) {
  EXPECT_FALSE(find_oscillation(canards_at([](double t) { return 40.0 * std::exp(-t / 0.5) * sine(8.0, t); })));
}

TEST(Oscillation, DuringExcitationAndWhileAStepSettlesIsNotJudged) {
  auto rows = canards_at([](double t) { return 5.0 * sine(8.0, t); });
  for (flight::Row& row : rows) {
    row.excitation_rad = row.time_s < 3.6 ? 0.01 : 0.0;  // then 0.4 s are left
  }
  EXPECT_FALSE(find_oscillation(rows));
  for (flight::Row& row : rows) {
    row.excitation_rad = row.time_s < 2.5 ? 0.01 : 0.0;
  }
  EXPECT_TRUE(find_oscillation(rows));
  for (flight::Row& row : rows) {
    row.excitation_rad = 0.0;
    row.reference_rad = std::floor(row.time_s / 0.9);
  }
  EXPECT_FALSE(find_oscillation(rows));
}

TEST(Oscillation, IsNoneOfEncodersThatAreNoisy) {
  auto noisy = canards_at([](double t) { return 5.0 + 2.0 * sine(24.0, t); });
  for (flight::Row& row : noisy) {
    row.command_rad = text::radians(5.0);
  }
  EXPECT_FALSE(find_oscillation(noisy)) << "nothing commands it";
  auto known = canards_at([](double t) { return 5.0 + 2.0 * sine(24.0, t); });
  for (flight::Row& row : known) {
    row.truth = flight::Truth{.canard_rad = text::radians(5.0)};
  }
  EXPECT_FALSE(find_oscillation(known)) << "the true canards stand still";
}

TEST(Oscillation, IsThatOfTheTrueCanardsWhereTheyAreKnown) {
  auto rows = canards_at([](double) { return 5.0; });
  for (flight::Row& row : rows) {
    row.truth = flight::Truth{.canard_rad = text::radians(5.0 + 2.0 * sine(8.0, row.time_s))};
  }
  EXPECT_TRUE(find_oscillation(rows));
}

TEST(Oscillation, IsThatOfTheCommandWhereNoEncoderIsKnown) {
  auto rows = canards_at([](double) { return 0.0; });
  for (flight::Row& row : rows) {
    row.canard_rad.reset();
    row.command_rad = text::radians(3.0) * sine(10.0, row.time_s);
  }
  EXPECT_TRUE(find_oscillation(rows));
}

}  // namespace
}  // namespace fantail::report
