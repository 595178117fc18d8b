// SPDX-License-Identifier: MIT
#include "campaign/criteria.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/results.hpp"
#include "input/scratch_file.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

constexpr std::size_t hold_column = 0;
constexpr std::size_t rest_column = 7;
constexpr std::size_t uncontrolled_column = 8;

/// The wind alone decides when control ends, the fin offset alone where the roll rests, and a third quantity the hold
/// error, which is always within its limit. `wind` and `offset`: how wide they are spread.
FlownCampaign made_runs(double wind, double offset, std::size_t count = 400) {
  FlownCampaign flown{.scenario = "made", .vehicle = "v", .plan = "p", .quantities = {"gains", "wind", "offset"}};
  sim::Random random{5, 0};
  for (std::size_t i = 0; i < count; ++i) {
    FlownRun run{
        .run = i, .seed = i, .numbers = {random.uniform(), wind * random.uniform(), offset * random.uniform()}};
    run.figures[hold_column] = 9.9 * run.numbers[0];
    run.figures[rest_column] = run.numbers[2];
    run.figures[uncontrolled_column] = run.numbers[1] - 1.0;
    run.outcome = "held";
    if (run.numbers[1] > 1.5) {
      run.outcome = "cut_short";
      run.failed_by.emplace_back("tilt");
    }
    if (run.numbers[2] > 10.0) {
      run.outcome = run.outcome == "held" ? "off_command" : run.outcome;
      run.failed_by.emplace_back("rest_error");
    }
    flown.runs.push_back(std::move(run));
  }
  return flown;
}

Report report_on(FlownCampaign flown, const Question& question = {}) {
  Report report{.campaign = {.runs = flown.runs.size()}, .flown = std::move(flown), .run_folders{5, ""}};
  report.analysis = analyse(report.flown, report.campaign, question, {});
  return report;
}

std::size_t extreme(const FlownCampaign& flown, std::size_t figure) {
  return static_cast<std::size_t>(
      std::ranges::max_element(flown.runs, {}, [figure](const FlownRun& run) { return *run.figures[figure]; }) -
      flown.runs.begin());
}

TEST(Criteria, WhereOnlyTheWindFailsRunsTheInfluencesAndTheWorstRunsAreThoseOfTheWind) {
  const Report report = report_on(made_runs(2.0, 9.0));
  const Analysis& a = report.analysis;
  ASSERT_EQ(a.failures.size(), 1U);
  EXPECT_EQ(a.failures[0].criterion->name, "tilt");
  EXPECT_EQ(a.failures[0].runs, a.share.of - a.share.count);
  EXPECT_EQ(a.decided_by, std::vector<std::size_t>{uncontrolled_column});
  EXPECT_EQ(a.influences[0].name, "wind");
  EXPECT_NEAR(a.influences[0].slopes[uncontrolled_column]->value, 1.0, 1e-9);
  EXPECT_EQ(a.worst[0].index, extreme(report.flown, uncontrolled_column));
  for (const RankedRun& worst : a.worst) {
    EXPECT_EQ(report.flown.runs[worst.index].outcome, "cut_short");
  }
  const std::string text = result::text(answer(report));
  EXPECT_NE(text.find("How the uncontrolled time before apogee depends on each drawn quantity"), std::string::npos);
  EXPECT_EQ(text.find("How the largest hold error"), std::string::npos) << text;
}

TEST(Criteria, WhereOnlyTheFinOffsetFailsRunsTheyAreThoseOfTheFinOffset) {
  const Report report = report_on(made_runs(1.4, 12.0));
  EXPECT_EQ(report.analysis.decided_by, std::vector<std::size_t>{rest_column});
  EXPECT_EQ(report.analysis.influences[0].name, "offset");
  EXPECT_EQ(report.analysis.worst[0].index, extreme(report.flown, rest_column));
  EXPECT_EQ(report.analysis.worst[0].failed_by->name, "rest_error");
}

// A quarter of the runs by wind, a sixth by offset.
TEST(Criteria, WhereBothFailRunsEachIsCountedAndShownAndTheyTakeTurnsAmongTheWorst) {
  const Report report = report_on(made_runs(2.0, 12.0));
  const Analysis& a = report.analysis;
  ASSERT_EQ(a.failures.size(), 2U);
  EXPECT_EQ(a.failures[0].criterion->name, "tilt");
  EXPECT_EQ(a.failures[1].criterion->name, "rest_error");
  EXPECT_NEAR(static_cast<double>(a.failures[0].runs), 100.0, 30.0);
  EXPECT_NEAR(static_cast<double>(a.failures[1].runs), 67.0, 25.0);
  EXPECT_EQ(a.decided_by, (std::vector<std::size_t>{uncontrolled_column, rest_column}));
  EXPECT_EQ(a.worst[0].index, extreme(report.flown, uncontrolled_column));
  EXPECT_EQ(a.worst[1].index, extreme(report.flown, rest_column));
  EXPECT_EQ(a.worst[2].failed_by->name, "tilt");
  const std::string text = result::text(answer(report));
  EXPECT_NE(text.find("How the uncontrolled time before apogee depends"), std::string::npos) << text;
  EXPECT_NE(text.find("How the rest error depends"), std::string::npos) << text;
  EXPECT_NE(headline(report).find("the tilt limit ended control early in " + std::to_string(a.failures[0].runs)),
            std::string::npos)
      << headline(report);
}

TEST(Criteria, TheHeadlineNamesTheStrongestInfluenceOnTheFirstOne) {
  EXPECT_TRUE(
      headline(report_on(made_runs(2.0, 12.0)))
          .ends_with("In a linear fit, \"wind\" has the strongest influence on the uncontrolled time before apogee."))
      << headline(report_on(made_runs(2.0, 12.0)));
  const std::string no_failure = headline(report_on(made_runs(1.4, 9.0)));
  EXPECT_EQ(no_failure.find("influence"), std::string::npos) << no_failure;
  FlownCampaign by_chance = made_runs(2.0, 9.0);
  sim::Random random{6, 0};
  for (FlownRun& run : by_chance.runs) {
    run.figures[uncontrolled_column] = random.uniform();
  }
  const Report report = report_on(by_chance);
  EXPECT_EQ(headline(report).find("influence"), std::string::npos) << headline(report);
  EXPECT_NE(result::text(answer(report)).find("less than 10 %: these slopes do not explain the figure"),
            std::string::npos);
}

TEST(Criteria, SayWhatEarlyIsAndWhichOutcomesComeOfIt) {
  Report report = report_on(made_runs(2.0, 12.0));
  EXPECT_NE(result::text(answer(report)).find("Early: more than 0.5 s before apogee"), std::string::npos);
  report.roll_band.in_tunnel = true;
  EXPECT_EQ(result::text(answer(report)).find("before apogee, or"), std::string::npos);
}

TEST(Criteria, AFigureOfTheQuestionDecidesAloneWhateverTheOutcomes) {
  const Report report = report_on(made_runs(2.0, 12.0), parse_question("rest_error_deg<=11"));
  EXPECT_TRUE(report.analysis.failures.empty());
  EXPECT_EQ(report.analysis.decided_by, std::vector<std::size_t>{rest_column});
  EXPECT_EQ(report.analysis.worst[0].index, extreme(report.flown, rest_column));
  EXPECT_EQ(headline(report).find("Why"), std::string::npos) << headline(report);
}

TEST(Criteria, WithoutAFailedRunTheHoldErrorIsShownAndThatNoCriterionDecides) {
  const Report report = report_on(made_runs(1.4, 9.0));
  EXPECT_EQ(report.analysis.decided_by, std::vector<std::size_t>{hold_column});
  EXPECT_EQ(report.analysis.worst[0].index, extreme(report.flown, hold_column));
  EXPECT_NE(result::text(answer(report)).find("Every run is held"), std::string::npos);
}

TEST(Criteria, ThatNoFigureMeasuresHaveNoInfluencesAndThatIsSaid) {
  FlownCampaign flown = made_runs(1.4, 9.0);
  flown.runs[7].outcome = "no_control";
  flown.runs[7].failed_by = {"no_control"};
  const Report report = report_on(std::move(flown));
  EXPECT_TRUE(report.analysis.decided_by.empty());
  EXPECT_EQ(report.analysis.worst[0].index, 7U);
  EXPECT_EQ(report.analysis.worst[0].figure, std::nullopt);
  EXPECT_NE(result::text(answer(report)).find("control never began. No figure measures it"), std::string::npos);
}

TEST(Criteria, OfARunWithoutTheFigureItIsWorseThanWithIt) {
  FlownCampaign flown = made_runs(2.0, 9.0);
  flown.runs[3].outcome = "cut_short";
  flown.runs[3].failed_by = {"tilt"};
  flown.runs[3].figures[uncontrolled_column].reset();
  EXPECT_EQ(worst_runs(flown.runs, {}, 0, 5)[0].index, 3U);
  const std::vector<RankedRun> low = worst_runs(flown.runs, parse_question("rest_error_deg>=20"), rest_column, 1);
  EXPECT_EQ(*flown.runs[low[0].index].figures[rest_column],
            std::ranges::min(flown.runs, {}, [](const FlownRun& run) { return *run.figures[rest_column]; })
                .figures[rest_column])
      << "low is bad where high is asked";
}

/// Of 100 flights of the second launch in six degrees of freedom. The roll rests u_d / kp beside its command, which is
/// 9.8 deg with the offset of the file, and 20 are allowed.
Report flown_with(const std::string& spreads) {
  const input::ScratchFile file{
      "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[verdict]\nrest_limit_deg = 20\n"
      "[disturbance]\ntimes_s = [0]\nangles_deg = [-4.9]\n[flight]\nmotion = \"six_dof\"\n[wind]\nspeed_m_s = 1\n" +
          spreads,
      "criteria.toml"};
  const Campaign campaign{.scenario = file.path().string(), .runs = 100};
  const std::filesystem::path folder = file.path().string() + ".runs";
  std::filesystem::remove_all(folder);
  Report report = report_on(fly_campaign(campaign, folder, "test", 2, [](std::uint64_t) {}));
  std::filesystem::remove_all(folder);
  return report;
}

// The wind turns the rocket over until the plan's tilt limit ends control, and the air meets it at large angles. The
// law's hold error depends on the servo.
TEST(Criteria, InFlightsThatOnlyTheWindFailsTheWindIsNamedFirst) {
  const Report report = flown_with(
      "[[spread]]\nfield = \"servo.lag_s\"\neffect = \"factor\"\nlaw = \"uniform\"\nlow = 0.8\nhigh = 1.3\n"
      "[[spread]]\nfield = \"wind.speed_m_s\"\nlaw = \"uniform\"\nlow = 0\nhigh = 9\n");
  const Analysis& a = report.analysis;
  ASSERT_GE(a.failures.size(), 2U);
  EXPECT_EQ(a.failures[0].criterion->name, "angle_of_attack");
  EXPECT_EQ(a.failures[1].criterion->name, "tilt");
  for (const std::size_t figure : a.decided_by) {
    EXPECT_EQ(steepest_first(a.influences, figure).front().name, "wind.speed_m_s") << figure_columns[figure];
  }
  EXPECT_NE(steepest_first(a.influences, hold_column).front().name, "wind.speed_m_s") << "what was always shown";
  for (const RankedRun& worst : a.worst) {
    EXPECT_GT(report.flown.runs[worst.index].numbers[1], 5.0) << "a strong wind";
  }
}

// More than 10 deg of offset rest more than 20 deg beside the command.
TEST(Criteria, InFlightsThatOnlyTheFinOffsetFailsTheOffsetIsNamedFirst) {
  const Report report = flown_with(
      "[[spread]]\nfield = \"servo.lag_s\"\neffect = \"factor\"\nlaw = \"uniform\"\nlow = 0.8\nhigh = 1.3\n"
      "[[spread]]\nfield = \"disturbance.angles_deg\"\neffect = \"offset\"\nlaw = \"uniform\"\nlow = -6\nhigh = 0\n");
  const Analysis& a = report.analysis;
  ASSERT_FALSE(a.failures.empty());
  EXPECT_EQ(a.failures[0].criterion->name, "rest_error");
  EXPECT_EQ(a.decided_by.front(), rest_column);
  EXPECT_EQ(a.influences.front().name, "disturbance.angles_deg_offset");
  EXPECT_LT(report.flown.runs[a.worst.front().index].numbers[1], -5.0);
}

TEST(Criteria, TheHeadlineSaysThatControlBeganInTheLaunchGuide) {
  auto made = made_runs(1.4, 9.0);
  EXPECT_EQ(headline(report_on(made)).find("launch guide"), std::string::npos);
  made.runs[2].note = std::string{begun_on_guide_note} + "0.250 s before the rocket left the launch guide";
  const std::string text = headline(report_on(made));
  EXPECT_NE(text.find("In 1 run control began inside the launch guide"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(" 0.250 s before the rocket left the launch guide.")) << text;
}

TEST(Criteria, AGateThatNeverOpensIsTheOnlyCriterionOfItsRun) {
  JudgedFlight judged;
  judged.verdict.outcome = report::Outcome::no_control;
  judged.flight.phase_changes = {{.phase = core::Phase::finished, .reason = core::PhaseReason::gate_never_opened}};
  EXPECT_EQ(failed_criteria(judged), (std::vector<std::string>{"gate"}));
  judged.flight.phase_changes.back().reason = core::PhaseReason::gyro_failed_before_control;
  EXPECT_EQ(failed_criteria(judged), (std::vector<std::string>{"no_control"}));
}

}  // namespace
}  // namespace fantail::campaign
