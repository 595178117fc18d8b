// SPDX-License-Identifier: MIT
// The campaign itself: it says the same whatever its threads and interruptions, and every fault is safe once armed
// and under control, or a known limit.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "faults/results.hpp"
#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "switches.hpp"
#include "text/error.hpp"

namespace fantail::faults {
namespace {

namespace fs = std::filesystem;

/// An empty folder that is gone afterwards.
class FaultCampaign : public testing::Test {
 protected:
  FaultCampaign() : folder_{fs::temp_directory_path() / ("fantail_faults_" + std::to_string(getpid()))} {
    fs::remove_all(folder_);
  }
  ~FaultCampaign() override { fs::remove_all(folder_); }

  fs::path folder_;
};

void quiet(std::uint64_t /*done*/) {}

std::string said_of(const Result& result) { return result::json(answer(result)); }

Campaign of(const char* scenario, const char* device) {
  Campaign campaign;
  campaign.scenario = scenario;
  campaign.device = device;
  campaign.every = 1000;
  return campaign;
}

TEST_F(FaultCampaign, OfAnAbortInputIsSafeInBothSenses) {
  Campaign fitted = of("tasha3_launch2", "abort_input");
  for (const std::string sense : {"open_aborts", "closed_aborts"}) {
    fitted.changes = {input::Override{"run", "abort_input", sense}};
    const Result result = fly_campaign(fitted, folder_ / sense, "v", 2, quiet);
    EXPECT_EQ(result.cells.size(), 15U);
    for (const CellResult& cell : result.cells) {
      EXPECT_EQ(cell.colour, Colour::green) << sense << ' ' << cell.cell.name() << ' ' << cell.figure;
    }
  }
}

TEST_F(FaultCampaign, OfAGateThatNeverOpensAsksForCanardsAtTrim) {
  const Result result = fly_campaign(of("tasha3_launch2_euroc", "arm_switch"), folder_, "v", 2, quiet);
  for (const CellResult& cell : result.cells) {
    const bool is_control = cell.cell.phase == Phase::controlling;
    EXPECT_EQ(cell.colour, is_control ? Colour::not_applicable : Colour::green)
        << cell.cell.name() << ' ' << cell.figure;
    EXPECT_EQ(cell.cell.safe().find("held"), std::string::npos) << cell.cell.safe();
  }
}

TEST_F(FaultCampaign, IsTheSameByAnyNumberOfThreadsAndAfterAnInterruption) {
  const std::string whole = said_of(fly_campaign(switches(), folder_ / "one", "v", 1, quiet));
  EXPECT_EQ(said_of(fly_campaign(switches(), folder_ / "three", "v", 3, quiet)), whole);
  const auto interrupt = [](std::uint64_t done) {
    if (done > 0) {
      throw std::runtime_error{"interrupted"};
    }
  };
  EXPECT_THROW((void)fly_campaign(switches(), folder_ / "cut", "v", 1, interrupt), std::runtime_error);
  EXPECT_EQ(said_of(fly_campaign(switches(), folder_ / "cut", "v", 1, quiet)), whole);
}

TEST_F(FaultCampaign, FliesAPartAgainThatIsDamagedAndCountsIt) {
  const std::string whole = said_of(fly_campaign(switches(), folder_, "v", 2, quiet));
  const fs::path part = folder_ / "parts/arm_switch.open.launched.00000000.part";
  fs::resize_file(part, fs::file_size(part) - 3);
  const Result again = fly_campaign(switches(), folder_, "v", 2, quiet);
  EXPECT_EQ(again.damaged, 1U);
  EXPECT_EQ(said_of(again), whole);
  EXPECT_EQ(fly_campaign(switches(), folder_, "v", 2, quiet).damaged, 0U);
}

// README: no verdict on a flight beyond the roll model is green.
TEST_F(FaultCampaign, OfARocketFasterThanTheModelHoldsForIsUndecidedWhereItWouldBeSafe) {
  Campaign fast = switches();
  EXPECT_EQ(answer_of(fly_campaign(fast, folder_ / "slow", "v", 2, quiet)), result::Answer::yes);
  fast.changes = input::parse_overrides(
      std::vector<std::string>{"motor.thrust_factor=1.5", "body.mass_kg=0.8", "body.drag_area_m2=0.0005"});
  const Result found = fly_campaign(fast, folder_ / "fast", "v", 2, quiet);
  EXPECT_FALSE(has_red(found));
  EXPECT_EQ(answer_of(found), result::Answer::undecided);
  EXPECT_NE(headline(found).find(found.beyond_model), std::string::npos);
  EXPECT_NE(found.beyond_model.find("Mach"), std::string::npos);
  const std::string cell = found.cells.front().cell.name();
  EXPECT_EQ(answer(fast, fly_alone(fast, cell, 0), "", {}).verdict.answer, result::Answer::undecided);
}

TEST_F(FaultCampaign, RefusesAFolderOfAnotherCampaignOrProgramAndNamesTheDifference) {
  (void)fly_campaign(switches(), folder_, "1 (a)", 2, quiet);
  const auto refusal = [this](const Campaign& campaign, const char* program) -> std::string {
    try {
      (void)fly_campaign(campaign, folder_, program, 2, quiet);
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), text::ErrorKind::bad_configuration);
      return error.what();
    }
    return "it took the folder";
  };
  Campaign other = switches();
  other.every = 999;
  EXPECT_TRUE(refusal(other, "1 (a)").ends_with("it holds another campaign: every is 1000 there and 999 here"));
  EXPECT_TRUE(refusal(switches(), "1 (b)").ends_with("version is 1 (a) there and 1 (b) here"));
}

TEST_F(FaultCampaign, RefusesNamesThatItHasNotARunThatItHasNotAndATunnel) {
  Campaign campaign = switches();
  campaign.device = "gyroscope";
  EXPECT_THROW((void)extent_of(campaign), text::Error);
  EXPECT_THROW((void)fly_alone(switches(), "imu/dead/launched", 3), text::Error);
  EXPECT_THROW((void)fly_alone(switches(), "second_imu/dead/launched", 0), text::Error);
  campaign = switches();
  campaign.scenario = "tunnel_steps";
  EXPECT_THROW((void)extent_of(campaign), text::Error);
}

TEST_F(FaultCampaign, CountsItsFlightsBeforehand) {
  const Extent extent = extent_of(switches());
  EXPECT_EQ(extent.cells, 4U);
  EXPECT_EQ(extent.flights, fly_campaign(switches(), folder_, "v", 2, quiet).flights);
  EXPECT_EQ(extent.flights, 4U * 3U);
}

TEST_F(FaultCampaign, ARunAloneIsTheRunOfTheCampaign) {
  Campaign campaign = switches();
  campaign.fault = "open";
  const Result result = fly_campaign(campaign, folder_, "v", 2, quiet);
  const faults::Run& worst = *result.cells.at(0).worst;
  const Alone alone = fly_alone(campaign, "arm_switch/open/launched", worst.number);
  EXPECT_EQ(alone.findings.outcome(alone.expected), worst.outcome);
  EXPECT_NEAR(alone.findings.apart_deg, worst.apart_deg, 0.0005);
}

// 30 ms are shorter than what disarms, and a contact that never settles was never closed.
TEST(FaultCampaignOfSwitches, OneThatChattersDisarmsNoRocketAndArmsNone) {
  Campaign campaign = switches();
  campaign.fault = "chatters";
  const auto outcome = [&](const char* phase, std::uint64_t run) {
    campaign.phase = phase;
    const Alone alone = fly_alone(campaign, fmt::format("arm_switch/chatters/{}", phase), run);
    EXPECT_EQ(alone.judged.colour, Colour::green) << phase << ' ' << run;
    return alone.findings.outcome(alone.expected);
  };
  EXPECT_EQ(outcome("pad", 0), Outcome::not_armed);
  EXPECT_EQ(outcome("armed", 0), Outcome::holds);
  EXPECT_EQ(outcome("launched", 0), Outcome::holds);
}

TEST(FaultOnsets, OfAPhaseWithoutThreeStepsAreAllOfThemAndThePageSaysNoMore) {
  Result result;
  result.campaign = switches();
  result.cells = {{.cell = cell_of("bus/dead/pad")}};
  result.campaign.step_ms = 10'000;
  EXPECT_EQ(extent_of(result.campaign).flights, 4U);
  const auto says = [&](const std::vector<std::string>& numbers) {  // in one sentence of the page
    std::istringstream page{result::html(answer(result))};
    for (std::string piece; std::getline(page, piece, '<');) {
      const std::vector<std::string> all = figures(piece);
      if (piece.find("onset every") != std::string::npos && !std::ranges::search(all, numbers).empty()) {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(says({"10000000", "10000", "1"}));
  result.campaign.every = 1;
  EXPECT_TRUE(says({"10000", "1"}));
  EXPECT_FALSE(says({"10000000"}));
}

TEST_F(FaultCampaign, WritesTheFlightReportsOfItsWorstFlightsBesideThePageThatLinksToThem) {
  Result result = fly_campaign(switches(), folder_, "v", 2, quiet);
  int looks = 0;
  write_worst(result, prepare(result.campaign), folder_, [&looks] { ++looks; });
  EXPECT_EQ(looks, 4);
  const std::string page = result::html(answer(result));
  const std::string summary = said_of(result);
  for (const CellResult& cell : result.cells) {
    ASSERT_FALSE(cell.report.empty()) << cell.cell.name();
    EXPECT_TRUE(fs::exists(folder_ / cell.report / "report.html")) << cell.report;
    EXPECT_NE(page.find("<a href=\"" + cell.report + "/report.html\">" + cell.cell.name() + ", run "),
              std::string::npos);
    EXPECT_NE(summary.find("\"" + cell.report + "/report.html\""), std::string::npos);
  }
  const auto interrupt = [] { throw std::runtime_error{"interrupted"}; };
  EXPECT_THROW(write_worst(result, prepare(result.campaign), folder_, interrupt), std::runtime_error);
}

// The judge sees a command beyond a limit in a flight of the simulator, too: here the limit is a degree less than what
// the plan allows, and the fin offset asks for more.
TEST(FaultFlight, IsRedWhereItGoesBeyondTheLimitThatItIsHeldTo) {
  Twins twins = fly_twins(input::load_scenario("tasha3_launch2", {}), 1);
  const Cell cell = cell_of("flash/dead/controlling");
  EXPECT_EQ(fly_run(twins, cell, {.seed = 0, .begin_ms = 3000}, 0).outcome(cell.expected()), Outcome::holds);
  for (double& limit_rad : twins.limits.limit_rad) {
    limit_rad *= 8.0 / 9.0;
  }
  const Findings findings = fly_run(twins, cell, {.seed = 0, .begin_ms = 3000}, 0);
  EXPECT_EQ(findings.outcome(cell.expected()), std::nullopt);
  EXPECT_NE(findings.breach.find("its limit is 8.000"), std::string::npos) << findings.breach;
}

// Of the bits of the flight law most are of no use in flight, and a third end control.
TEST(FaultFlight, OfEachRunFlipsAnotherBit) {
  const Twins twins = fly_twins(input::load_scenario("tasha3_launch2", {}), 1);
  const Cell cell = cell_of("memory/flight_law/controlling");
  int held = 0;
  int over = 0;
  for (std::uint64_t run = 0; run < 24; ++run) {
    const auto outcome = fly_run(twins, cell, {.seed = 0, .begin_ms = 3000}, run).outcome(cell.expected());
    ASSERT_TRUE(outcome) << run;
    held += *outcome == Outcome::holds ? 1 : 0;
    over += *outcome == Outcome::over ? 1 : 0;
  }
  EXPECT_GT(held, 0);
  EXPECT_GT(over, 0);
}

// One instant of each: what `fantail campaign faults` does with all of them.
void expect_safe_or_a_known_limit(Phase phase, int begin_ms) {
  const Twins twins = fly_twins(input::load_scenario("tasha3_launch2", {}), 1);
  for (const FaultRow& row : fault_table()) {
    const Cell cell{.row = &row, .phase = phase};
    if (!why_not(row, twins.scenario).empty()) {
      continue;
    }
    const Findings findings = fly_run(twins, cell, {.seed = 0, .begin_ms = begin_ms}, 0);
    EXPECT_TRUE(findings.outcome(cell.expected()) || known_limit(row, cell.phase, twins.scenario) != nullptr)
        << cell.name() << ": " << findings.what_it_was();
    EXPECT_EQ(findings.breach, "") << cell.name();
  }
}

// Control ends 10.4 s after ignition.
TEST(FaultOfTheBarometer, IsHarmlessInEveryPhaseAndFlownOnlyWhereOneIsFitted) {
  const sim::Scenario without = input::load_scenario("tasha3_launch2", {});
  const Twins twins =
      fly_twins(input::load_scenario("tasha3_launch2", input::parse_overrides(std::vector<std::string>{
                                                           "barometer.fitted=yes", "sensors.barometer=fused"})),
                1);
  constexpr std::array begins_ms{-9500, -500, 300, 3000, 10'800};
  std::size_t rows = 0;
  for (const FaultRow& row : fault_table()) {
    if (row.recipe.fault.device != sim::Device::barometer) {
      continue;
    }
    ++rows;
    EXPECT_EQ(why_not(row, without), "the rocket does not use a barometer");
    ASSERT_EQ(why_not(row, twins.scenario), "");
    for (std::size_t i = 0; i < phases; ++i) {
      const Cell cell{.row = &row, .phase = static_cast<Phase>(i)};
      const Findings findings = fly_run(twins, cell, {.seed = 0, .begin_ms = begins_ms[i]}, 0);
      EXPECT_TRUE(findings.outcome(cell.expected())) << cell.name() << ": " << findings.what_it_was();
      EXPECT_EQ(findings.breach, "") << cell.name();
    }
  }
  EXPECT_EQ(rows, 11U);
}

TEST(FaultUnderControl, IsSafeOrAKnownLimit) { expect_safe_or_a_known_limit(Phase::controlling, 3000); }
TEST(FaultOnceArmed, IsSafeOrAKnownLimit) { expect_safe_or_a_known_limit(Phase::armed, -1000); }

}  // namespace
}  // namespace fantail::faults
