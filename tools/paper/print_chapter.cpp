// SPDX-License-Identifier: MIT
// What can be checked with the printed page and a pencil.
#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "paper/chapters.hpp"
#include "paper/print_slips.hpp"

namespace fantail::paper {
namespace {

double percent(double part, double whole) { return 100.0 * part / whole; }

// A printed number and what the printed numbers behind it give.
struct Arithmetic {
  std::string place{};
  std::string what{};
  double theirs = 0.0;
  double ours = 0.0;
  int decimals = 1;
  double tolerance = 0.05;
  std::string unit = "%";
  std::string why_otherwise{};
  std::string remark{};
};

Claim worked_out(const Arithmetic& a) {
  return compare({.place = a.place,
                  .what = a.what,
                  .theirs = a.theirs,
                  .ours = a.ours,
                  .unit = a.unit,
                  .decimals = a.decimals,
                  .tolerance = a.tolerance,
                  .otherwise = Finding::error_in_print,
                  .why_otherwise = a.why_otherwise,
                  .remark = a.remark});
}

// "Of the launch's value; of the tunnel's it is 18.6 %."
std::string denominator(const std::string& taken, const std::string& other, double difference, double other_value) {
  return fmt::format(
      "Of the {} value; of the {} it is {:.1f} %. The three errors of this section do not all have the "
      "same denominator.",
      taken, other, percent(difference, other_value));
}

void add_first_launch(std::vector<Claim>& claims) {
  const std::string place = "Section 4.2";
  claims.push_back(worked_out({.place = place,
                               .what = "Error of the modelled drop, 26.15 of 27.2 degrees: less than",
                               .theirs = 4.0,
                               .ours = percent(27.2 - 26.15, 27.2),
                               .tolerance = 0.2}));
  claims.push_back(worked_out({.place = place,
                               .what = "Difference of the loops' mean rate errors, 9.82 and 9.76",
                               .theirs = 0.06,
                               .ours = 9.82 - 9.76,
                               .decimals = 2,
                               .tolerance = 0.005,
                               .unit = "deg/s"}));
  claims.push_back(worked_out({.place = place,
                               .what = "Difference of the loops' mean angle errors, 1.51 and 1.50",
                               .theirs = 0.01,
                               .ours = 1.51 - 1.50,
                               .decimals = 2,
                               .tolerance = 0.005,
                               .unit = "deg"}));
  claims.push_back(worked_out({.place = "Abstract",
                               .what = "Smallest mean angle error of the flights: of 1.51, 1.50, 0.26 and 0.99",
                               .theirs = 0.26,
                               .ours = std::min({1.51, 1.50, 0.26, 0.99}),
                               .decimals = 2,
                               .tolerance = 0.005,
                               .unit = "deg"}));
  claims.push_back(worked_out({.place = "Abstract",
                               .what = "Largest of them",
                               .theirs = 1.5,
                               .ours = std::max({1.51, 1.50, 0.26, 0.99}),
                               .decimals = 2,
                               .unit = "deg"}));
}

void add_second_launch(std::vector<Claim>& claims) {
  const std::string place = "Section 4.3.2";
  claims.push_back(worked_out({.place = place,
                               .what = "Launch 2's damping, 23, against the tunnel's mean, 19.4",
                               .theirs = 15.7,
                               .ours = percent(23.0 - 19.4, 23.0),
                               .remark = denominator("launch's", "tunnel's", 23.0 - 19.4, 19.4)}));
  claims.push_back(worked_out({.place = place,
                               .what = "Launch 2's torque constant, 9, against the tunnel's mean, 9.6",
                               .theirs = 4.4,
                               .ours = percent(9.6 - 9.0, 9.6),
                               .why_otherwise = "It is 6.2 % of the tunnel's and 6.7 % of the launch's value."}));
  claims.push_back(worked_out({.place = place,
                               .what = "Mean offset of the launch, 4.9, against the tunnel's, 4.1",
                               .theirs = 0.8,
                               .ours = 4.9 - 4.1,
                               .unit = "deg"}));
  claims.push_back(worked_out({.place = place,
                               .what = "The same in percent",
                               .theirs = 16.3,
                               .ours = percent(4.9 - 4.1, 4.9),
                               .remark = denominator("launch's", "tunnel's", 4.9 - 4.1, 4.1)}));
  claims.push_back(worked_out({.place = place,
                               .what = "Second window's torque constant, 8, against the tunnel's mean, 9.6",
                               .theirs = 16.7,
                               .ours = percent(9.6 - 8.0, 9.6),
                               .remark = denominator("tunnel's", "launch's", 9.6 - 8.0, 8.0)}));
  claims.push_back(worked_out({.place = place + ", figure 27",
                               .what = "Start of the second window: 2 s after control start at 2.4 \u2212 0.4 s, about",
                               .theirs = 4.0,
                               .ours = 2.4 - 0.4 + 2.0,
                               .unit = "s"}));
  claims.push_back(worked_out({.place = "Section 5",
                               .what = "Launch 2's fin offset after burn-out: about, where section 4.3.2 has 4.7",
                               .theirs = 5.0,
                               .ours = 4.7,
                               .tolerance = 0.5,
                               .unit = "deg"}));
}

}  // namespace

Chapter print_chapter() {
  Chapter chapter{.title = "The print, held against itself",
                  .introduction = "Sums, percentages and repeated numbers that need nothing but the publication."};
  auto& claims = chapter.claims;
  claims.push_back(worked_out(
      {.place = "Section 4.1.2",
       .what = "Reduction of the bare fins' roll rate by the straightener, 87.0 to 25.7 deg/s",
       .theirs = 340.0,
       .ours = percent(87.0 - 25.7, 87.0),
       .tolerance = 0.5,
       .why_otherwise = "Nothing can be reduced by more than all of it. 87.0 / 25.7 is 3.4: the rate fell to 30 %."}));
  claims.push_back(worked_out({.place = "Section 4.3.1",
                               .what = "Smallest mean angle error of Table 2 over the step of 45 degrees",
                               .theirs = 0.6,
                               .ours = percent(0.26, 45.0)}));
  claims.push_back(
      worked_out({.place = "Section 4.3.1", .what = "Largest of them", .theirs = 3.6, .ours = percent(1.64, 45.0)}));
  add_first_launch(claims);
  add_second_launch(claims);
  std::ranges::move(print_slips(), std::back_inserter(claims));
  return chapter;
}

}  // namespace fantail::paper
