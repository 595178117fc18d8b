// SPDX-License-Identifier: MIT
#include "campaign/analysis.hpp"

#include <string>

#include <gtest/gtest.h>

#include "campaign/results.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

/// Runs whose hold error is 6 + 3 a - b, of two standard normal numbers; "held" up to 10.
FlownCampaign made(std::size_t count) {
  FlownCampaign flown{.scenario = "made", .vehicle = "v", .plan = "p", .quantities = {"a", "b", "same"}};
  sim::Random random{11, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const double a = random.gaussian();
    const double b = random.gaussian();
    FlownRun run{.run = i, .seed = i, .numbers = {a, b, 5.0}};
    run.figures[0] = 6.0 + 3.0 * a - b;
    run.outcome = *run.figures[0] <= 10.0 ? "held" : "not_held";
    flown.runs.push_back(std::move(run));
  }
  return flown;
}

TEST(Analysis, FindsTheShareAndWhatTheFigureDependsOn) {
  const FlownCampaign flown = made(4000);
  const Analysis analysis = analyse(flown, {.runs = 4000}, {}, 0.5);
  EXPECT_EQ(analysis.judgement, Judgement::met);
  // 4 / sqrt(10) standard deviations above the middle: 0.8970 are below.
  EXPECT_NEAR(analysis.share.value, 0.8970, 0.015);
  EXPECT_LT(analysis.share.low, 0.8970);
  EXPECT_GT(analysis.share.high, 0.8970);
  ASSERT_EQ(analysis.influences.size(), 3U);
  EXPECT_EQ(analysis.influences[0].name, "a");
  EXPECT_NEAR(analysis.influences[0].on_result.variance_share.value, 0.9, 0.03);
  EXPECT_FALSE(analysis.influences[2].variance_shares[0]) << "what does not vary says nothing";
  EXPECT_EQ(analysis.figures.size(), 1U) << "the others are of no run";
  ASSERT_EQ(analysis.worst.size(), 5U);
  double largest = 0.0;
  for (const FlownRun& run : flown.runs) {
    largest = std::max(largest, *run.figures[0]);
  }
  EXPECT_EQ(flown.runs[analysis.worst[0]].figures[0], largest);
  EXPECT_EQ(analysis.looked.back().runs, 4000U);
  EXPECT_EQ(analysis.looked.back().share, analysis.share.value);
}

TEST(Analysis, LeavesUndecidedWhatIsWithinTheInterval) {
  const FlownCampaign flown = made(100);
  EXPECT_EQ(analyse(flown, {.runs = 100}, {}, 0.9).judgement, Judgement::undecided);
  EXPECT_EQ(analyse(flown, {.runs = 100}, {}, 0.999).judgement, Judgement::not_met);
  EXPECT_EQ(analyse(flown, {.runs = 100}, {}, {}).judgement, std::nullopt);
}

TEST(Analysis, SaysWhyItKnowsNoInfluences) {
  EXPECT_EQ(analyse(made(49), {.runs = 49}, {}, {}).no_influences,
            "The largest hold error is known of 49 runs, and it takes 50 to tell what it depends on.");
  FlownCampaign same = made(60);
  for (FlownRun& run : same.runs) {
    run.figures[0] = 3.0;
  }
  EXPECT_EQ(analyse(same, {.runs = 60}, {}, {}).no_influences, "The largest hold error is the same in all runs.");
}

// Wilson's interval of 199 in 200 ends at 99.912 %.
TEST(CampaignReport, RoundsNoBoundOverWhatIsAskedFor) {
  Report report{.flown = made(200)};
  for (FlownRun& run : report.flown.runs) {
    run.outcome = run.run == 0 ? "not_held" : "held";
  }
  report.campaign.runs = 200;
  for (const auto& [required, end] : {std::pair{0.9995, "to 99.92 %."}, {0.99915, "to 99.912 %."}}) {
    report.analysis = analyse(report.flown, report.campaign, {}, required);
    EXPECT_TRUE(headline(report).ends_with(end)) << headline(report);
    EXPECT_NE(headline(report).find(": not met."), std::string::npos) << headline(report);
  }
}

TEST(CampaignReport, CountsRunsWithoutAFlightAsNotMetAndNamesThem) {
  Report report{.flown = made(60)};
  report.flown.runs[7].outcome = "refused";
  report.flown.runs[7].note = "mass_kg = 0.1";
  report.flown.runs[7].figures[0].reset();
  report.flown.runs[9].outcome = "not_finite";
  report.flown.runs[9].note = "apogee_m is no number";
  report.campaign.runs = 60;
  report.analysis = analyse(report.flown, report.campaign, {}, {});
  report.run_folders.assign(5, "");
  const std::string text = report_text(report);
  EXPECT_NE(text.find("1 run drew values that do not go together and were not flown; counted as not met. The first is "
                      "run 7: mass_kg = 0.1."),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("The first is run 9: apogee_m is no number."), std::string::npos) << text;
  EXPECT_NE(report_html(report).find("run 7: mass_kg = 0.1"), std::string::npos);
}

}  // namespace
}  // namespace fantail::campaign
