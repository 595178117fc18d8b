// SPDX-License-Identifier: MIT
// The table of what is safe: every row can be flown, and every known limit is one of a row.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "faults/campaign.hpp"
#include "input/fault_file.hpp"
#include "input/scenario_file.hpp"
#include "runs/row_text.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

TEST(FaultTable, NamesEachCellOnceAndFindsItByItsName) {
  std::set<std::string> names;
  for (const FaultRow& row : fault_table()) {
    for (std::size_t i = 0; i < phases; ++i) {
      const Cell cell{.row = &row, .phase = static_cast<Phase>(i)};
      EXPECT_TRUE(names.insert(cell.name()).second) << cell.name();
      EXPECT_EQ(cell_of(cell.name()).row, &row) << cell.name();
      EXPECT_TRUE(cell.expected().applies()) << cell.name();
    }
  }
}

TEST(FaultTable, SaysWhatIsAllowedForANameThatIsNoCell) {
  for (const char* name : {"imu/dead", "imu/dead/flight", ""}) {
    EXPECT_THROW((void)cell_of(name), text::Error) << name;
  }
}

bool is_a_kind_of(std::span<const input::FaultWords> words, const sim::Fault& fault) {
  return std::ranges::any_of(words, [&](const auto& one) { return sim::is_same_kind(one.fault, fault); });
}

TEST(FaultTable, HasOnlyFaultsThatTheSimulatorCanFly) {
  for (const FaultRow& row : fault_table()) {
    EXPECT_TRUE(is_a_kind_of(input::device_faults(), row.recipe.fault) ||
                is_a_kind_of(input::fault_kinds(), row.recipe.fault))
        << row.device << ' ' << row.fault;
  }
}

TEST(FaultTable, FliesEveryBehaviourThatTheSimulatorHas) {
  for (const input::FaultWords& words : input::device_faults()) {
    EXPECT_TRUE(std::ranges::any_of(
        fault_table(), [&](const FaultRow& row) { return sim::is_same_kind(row.recipe.fault, words.fault); }))
        << input::name(words.fault.device) << ' ' << words.behaviour;
  }
}

TEST(FaultTable, HasNoFaultTwiceSoThatALimitIsOfOneRow) {
  for (const FaultRow& row : fault_table()) {
    EXPECT_EQ(std::ranges::count(fault_table(), row.recipe, &FaultRow::recipe), 1) << row.device << ' ' << row.fault;
  }
}

TEST(FaultTable, KnowsNoLimitOfAFaultThatItHasNot) {
  for (const KnownLimit& limit : known_limits()) {
    EXPECT_EQ(std::ranges::count(fault_table(), limit.recipe, &FaultRow::recipe), 1) << limit.why;
    EXPECT_NE(limit.phases, 0U);
    EXPECT_GE(limit.last_ms, 0);
    EXPECT_FALSE(limit.why.empty());
    EXPECT_FALSE(limit.what_to_do.empty());
  }
}

TEST(FaultTable, TakesAnotherCanardForEachRunAndAllWhereItSaysSo) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Recipe one = broken(sim::Device::servo, sim::Behaviour::dead);
  for (std::uint64_t run = 0; run < 8; ++run) {
    const auto faults = faults_of(one, 2.0, run, scenario);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].canard, run % 4);
    EXPECT_EQ(faults[0].from_s, 2.0);
  }
  const Recipe four = all(sim::Device::servo, sim::Behaviour::dead, 0.05);
  const auto faults = faults_of(four, 2.0, 1, scenario);
  ASSERT_EQ(faults.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(faults[i].canard, i);
    EXPECT_DOUBLE_EQ(faults[i].until_s.value(), 2.05);
  }
}

TEST(FaultTable, OfABootLoopEachResetIsAFifthOfASecondAfterTheOneBefore) {
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  const Recipe loop = reset(hal::ResetCause::watchdog, 0.06, 6);
  const auto faults = faults_of(loop, 1.0, 0, scenario);
  ASSERT_EQ(faults.size(), 6U);
  EXPECT_DOUBLE_EQ(faults[5].from_s, 2.0);
  EXPECT_DOUBLE_EQ(end_of(loop, 1.0), 2.06);
}

TEST(FaultRun, IsReadAsItWasWritten) {
  const faults::Run red{.number = 17,
                        .seed = 18446744073709551615ULL,
                        .begin_ms = -9990,
                        .outcome = {},
                        .apart_deg = 12.345,
                        .trim_after_s = 0.123,
                        .what = "control went on, up to 12.3 deg, and so on"};
  const faults::Run other{.number = 0,
                          .seed = 1,
                          .begin_ms = 0,
                          .outcome = Outcome::recovers,
                          .is_breach = true,
                          .came_back = true,
                          .stands_after_s = 0.5};
  for (faults::Run run : {red, other}) {
    runs::RowText text;
    text(run);
    std::vector<faults::Run> back(1);
    ASSERT_TRUE(runs::read_rows(text.text(), back)) << text.text();
    EXPECT_EQ(back[0], run);
  }
}

TEST(FaultCell, IsAsRedAsItsWorstRunAndALimitExcusesIt) {
  const Cell cell = cell_of("imu/dead/controlling");
  const faults::Run held{.number = 0, .outcome = Outcome::holds, .apart_deg = 9.0};
  const faults::Run ended{.number = 1, .outcome = Outcome::over, .trim_after_s = 0.2};
  const faults::Run spun{.number = 2, .outcome = {}, .apart_deg = 3.0, .what = "it spun"};
  const KnownLimit limit{
      .recipe = cell.row->recipe, .phases = 1, .with_one_gyro = false, .why = "w", .what_to_do = "d"};
  EXPECT_EQ(concluded(cell, {}, {}).colour, Colour::not_applicable);
  EXPECT_EQ(concluded(cell, {held, ended}, {}).colour, Colour::green);
  EXPECT_EQ(concluded(cell, {held, ended}, {&limit}).colour, Colour::limit_without_need);
  EXPECT_EQ(concluded(cell, {held, spun, ended}, {&limit}).colour, Colour::known_limit);
  const faults::Run later{.number = 3, .begin_ms = 500, .outcome = {}, .what = "it spun"};
  EXPECT_EQ(concluded(cell, {held, later}, {&limit, 500}).colour, Colour::known_limit);
  EXPECT_EQ(concluded(cell, {held, later}, {&limit, 501}).colour, Colour::red);
  EXPECT_EQ(concluded(cell, {held, later}, {&limit, 501}).limit, nullptr);
  EXPECT_EQ(concluded(cell, {held, ended}, {&limit, 501}).colour, Colour::green) << "none began so late";
  EXPECT_EQ(concluded(cell, {held, later}, {nullptr, 500}).colour, Colour::red);
  const CellResult red = concluded(cell, {held, spun, ended}, {});
  EXPECT_EQ(red.colour, Colour::red);
  EXPECT_EQ(red.red, 1U);
  EXPECT_EQ(red.worst->number, 2U);
  EXPECT_EQ(red.figure, "it spun");
}

}  // namespace
}  // namespace fantail::faults
