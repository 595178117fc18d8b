// SPDX-License-Identifier: MIT
#include "flight/units.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "flight/columns.hpp"

namespace fantail::flight {
namespace {

TEST(Units, AreThoseOfTheTables) {
  EXPECT_DOUBLE_EQ(find_unit("rpm")->si, std::numbers::pi / 30.0);
  EXPECT_DOUBLE_EQ(find_unit("turn/s")->si, 2.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(find_unit("km/h")->si * 36.0, 10.0);
  EXPECT_DOUBLE_EQ(find_unit("ft")->si, 0.3048);
  EXPECT_DOUBLE_EQ(find_unit("g")->si, 9.80665);
  EXPECT_EQ(find_unit("mph"), nullptr);
  EXPECT_EQ(unit_names(Dimension::time), "s, ms, us");
}

TEST(Units, EveryColumnOfAFlightIsAQuantityInItsBaseUnit) {
  EXPECT_EQ(quantity_of("roll_rate_deg_s").name, "roll_rate");
  EXPECT_EQ(quantity_of("roll_rate_deg_s").dimension, Dimension::angular_rate);
  EXPECT_EQ(quantity_of("specific_force_m_s2").dimension, Dimension::acceleration);
  EXPECT_EQ(quantity_of("time_s").name, "time");
  EXPECT_EQ(quantity_of("encoder_3_deg").name, "encoder_3");
  EXPECT_FALSE(quantity_of("phase").dimension);
  for (const Column& column : columns()) {
    EXPECT_EQ(quantity_of(column.name).dimension.has_value(), column.unit != Column::Unit::flag) << column.name;
  }
}

}  // namespace
}  // namespace fantail::flight
