// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "campaign/flown_run.hpp"
#include "campaign/results.hpp"

namespace fantail::campaign {
namespace {

TEST(ColumnWords, AreWhatAPersonReadsWithTheUnitThatTheNameEndsWith) {
  EXPECT_EQ(column_words("top_speed_m_s").with_unit(), "top speed / m/s");
  EXPECT_EQ(column_words("saturated_share").with_unit(), "saturated share");
  EXPECT_EQ(column_words("servo.lag_s_factor").with_unit(), "servo: lag, factor");
  EXPECT_EQ(column_words("disturbance.angles_deg_offset").with_unit(), "disturbance: angles, added / deg");
  EXPECT_EQ(column_words("body.roll_inertia_kg_m2").with_unit(), "body: roll inertia / kg m2");
  EXPECT_EQ(column_words("imu.rate_bias_deg_s").with_unit(), "imu: rate bias / deg/s");
}

TEST(ColumnWords, OfNoFigureHaveAnUnderscore) {
  for (const std::string_view name : figure_columns) {
    EXPECT_EQ(column_words(name).with_unit().find('_'), std::string::npos) << name;
  }
  EXPECT_EQ(outcome_words("cut_short"), "cut short");
}

}  // namespace
}  // namespace fantail::campaign
