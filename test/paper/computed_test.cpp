// SPDX-License-Identifier: MIT
// The rule of the kinds, where a test can look whether a row keeps it: what a number was made from shows when another
// is changed.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "paper/print.hpp"

namespace fantail::paper {
namespace {

Print changed(const Print& print, Number number, double factor) {
  Print other = print;
  other[number] = factor * print[number];
  return other;
}

// A least or a largest of several may take a large change, either way.
bool follows(const Computed& row, const Print& print, Number number) {
  return row.ours(changed(print, number, 10.0)) != row.ours(print) ||
         row.ours(changed(print, number, 0.01)) != row.ours(print);
}

// Whether some other printed number moves ours.
bool follows_another(const Computed& row, const Print& print) {
  const double ours = row.ours(print);
  for (std::size_t i = 0; i < number_count; ++i) {
    const auto number = static_cast<Number>(i);
    if (number != row.theirs && follows(row, print, number)) {
      return true;
    }
  }
  for (const auto member : {&PublishedStep::alpha_m2, &PublishedStep::beta_m, &PublishedStep::disturbance_begin_deg,
                            &PublishedStep::disturbance_end_deg, &PublishedStep::mean_abs_angle_error_deg,
                            &PublishedStep::mean_abs_rate_error_deg_s}) {
    Print other = print;
    for (PublishedStep& step : other.steps) {
      step.*member *= 1.37;
    }
    if (row.ours(other) != ours) {
      return true;
    }
  }
  return false;
}

TEST(Computed, NoRowFollowsItsOwnPrintedNumber) {
  const Print print = Print::as_published();
  for (const Computed& row : computed()) {
    EXPECT_FALSE(follows(row, print, row.theirs)) << row.place << ": " << row.what;
    const Print other = changed(print, row.theirs, 10.0);
    EXPECT_NE(worked_out(row, other).theirs, worked_out(row, print).theirs) << row.place << ": " << row.what;
  }
}

TEST(Computed, EveryRowFollowsSomeOtherPrintedNumber) {
  const Print print = Print::as_published();
  for (const Computed& row : computed()) {
    EXPECT_TRUE(follows_another(row, print)) << row.place << ": " << row.what;
  }
}

TEST(Computed, EveryPrintedNumberOfTheListIsUsed) {
  const Print print = Print::as_published();
  for (std::size_t i = 0; i < number_count; ++i) {
    const auto number = static_cast<Number>(i);
    EXPECT_NE(print[number], 0.0) << i;
    EXPECT_TRUE(std::ranges::any_of(computed(), [&](const Computed& row) {
      return row.theirs == number || follows(row, print, number);
    })) << i;
  }
}

TEST(Computed, ANumberThatTheOthersContradictIsAnErrorInPrint) {
  const Print print = Print::as_published();
  for (const Computed& row : computed()) {
    Print other = print;
    other[row.theirs] = row.ours(print);
    EXPECT_EQ(worked_out(row, other).kind, Kind::computed) << row.what;
    other[row.theirs] += 2.0 * row.tolerance;
    EXPECT_EQ(worked_out(row, other).kind, Kind::error_in_print) << row.what;
  }
}

}  // namespace
}  // namespace fantail::paper
