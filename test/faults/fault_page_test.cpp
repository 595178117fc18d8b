// SPDX-License-Identifier: MIT
// The sentence, the map and the worst flights of a page, from cells of known colours.
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "faults/results.hpp"

namespace fantail::faults {
namespace {

CellResult of(const char* cell, Colour colour, double apart_deg, std::optional<Outcome> outcome = Outcome::holds) {
  return {.cell = cell_of(cell),
          .colour = colour,
          .flights = 1,
          .worst = faults::Run{.outcome = outcome, .apart_deg = apart_deg}};
}

TEST(FaultMap, HasARowForEachFaultAndACellInTheColourOfWhatItCameTo) {
  Result result;
  result.cells = {of("imu/dead/pad", Colour::green, 0.0), of("imu/dead/armed", Colour::known_limit, 100.0),
                  of("imu/spike/armed", Colour::not_applicable, 0.0), of("bus/dead/armed", Colour::red, 9.0)};
  const std::string svg = map_svg(result, 880.0);
  const auto count = [&svg](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) {
      ++found;
    }
    return found;
  };
  for (const char* const key : {"\"cell good\"", "\"cell unsure\"", "\"cell bad\""}) {
    EXPECT_EQ(count(key), 2U) << key << ": in the key, and one cell";
  }
  for (const char* const label : {">imu dead<", ">imu spike<", ">bus dead<", ">pad<", ">armed<"}) {
    EXPECT_EQ(count(label), 1U) << label;
  }
  EXPECT_EQ(count("<title>imu/dead/armed: a known limit"), 1U);
  EXPECT_EQ(count("<title>"), 3U) << "what is not applicable has no cell";
  EXPECT_TRUE(map_svg(Result{}, 880.0).empty());
}

/// Of one phase of the first faults of the table, with these colours.
Result with_colours(const std::vector<Colour>& colours) {
  Result result;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    CellResult cell{.cell = {&fault_table()[i], Phase::armed}, .colour = colours[i], .flights = 3};
    if (colours[i] != Colour::not_applicable) {
      cell.worst = Run{.outcome = Outcome::not_armed, .apart_deg = static_cast<double>(i)};
    }
    result.cells.push_back(cell);
    result.flights += cell.flights;
  }
  return result;
}

TEST(FaultHeadline, SaysHowManyFaultsAreNotSafeAndNamesTheWorstFirst) {
  using enum Colour;
  const auto name = [](std::size_t i) { return fmt::format("{} {}", fault_table()[i].device, fault_table()[i].fault); };
  EXPECT_TRUE(
      headline(with_colours({known_limit, green, red, not_applicable, green, limit_without_need}))
          .starts_with(fmt::format("2 of 5 faults are not safe in some phase: {}, {}; 3 are safe in every flight. ",
                                   name(2), name(0))));
  EXPECT_TRUE(headline(with_colours(std::vector<Colour>(7, red)))
                  .starts_with(fmt::format("7 of 7 faults are not safe in some phase: {}, {}, {}, {} and 3 more. ",
                                           name(0), name(1), name(2), name(3))));
  EXPECT_TRUE(headline(with_colours({green})).starts_with("The fault is safe in every flight. 3 flights in 1 cell. "));
  EXPECT_TRUE(headline(with_colours({green, green})).starts_with("All 2 faults are safe in every flight. "));
  EXPECT_TRUE(headline(with_colours({not_judged})).starts_with("No flight broke the rules for every flight. "));
  EXPECT_TRUE(
      headline(with_colours({not_judged, green})).starts_with("No fault is unsafe; 1 is safe in every flight. "));
}

TEST(FaultHeadline, AFaultThatNeverHappenedIsNotCountedAsSafe) {
  Result result = with_colours({Colour::green, Colour::not_applicable});
  EXPECT_EQ(headline(result).find("appened"), std::string::npos);
  result.cells[1].is_reached = false;
  result.never_happened = "The fault from 500 s after ignition on never happened: the flight ended at 14.20 s.";
  EXPECT_TRUE(headline(result).ends_with(
      "Safe in every flight: 1 cell. Never happened, because no flight reaches the phase, and not counted as safe: 1 "
      "cell. The fault from 500 s after ignition on never happened: the flight ended at 14.20 s."))
      << headline(result);
}

// Another rocket than the shipped one can have them.
TEST(FaultReasons, OfARedCellNameTheCommandThatFliesItsWorstRun) {
  Result result;
  result.cells = {of("flash/dead/armed", Colour::red, 20.0)};
  const result::Table table = reasons(result);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(std::get<std::string>(table.rows[0][1]), "Not among the known limits of Fantail.");
  EXPECT_NE(std::get<std::string>(table.rows[0][2]).find("--cell flash/dead/armed"), std::string::npos);
}

TEST(FaultWorst, AreTheWorstCellsOfFiveFaultsRedOnesFirst) {
  Result result;
  result.cells = {of("imu/dead/pad", Colour::green, 500.0, Outcome::not_armed),
                  of("imu/dead/controlling", Colour::green, 3.0),
                  of("imu/spike/armed", Colour::known_limit, 100.0),
                  of("imu/spike/controlling", Colour::known_limit, 200.0),
                  of("bus/dead/armed", Colour::green, 9.0),
                  of("flash/dead/armed", Colour::red, 20.0),
                  of("encoder/dead/armed", Colour::limit_without_need, 8.0),
                  of("encoder/stuck/armed", Colour::green, 1.0),
                  {.cell = cell_of("second_imu/dead/pad")}};
  std::vector<std::string> names;
  for (const std::size_t i : worst_cells(result)) {
    names.push_back(result.cells[i].cell.name());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"flash/dead/armed", "imu/spike/controlling", "bus/dead/armed",
                                             "encoder/dead/armed", "imu/dead/controlling"}));
}

}  // namespace
}  // namespace fantail::faults
