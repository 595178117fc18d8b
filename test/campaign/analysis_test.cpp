// SPDX-License-Identifier: MIT
#include "campaign/analysis.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "campaign/results.hpp"
#include "json/value.hpp"
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
  EXPECT_NEAR(analysis.influences[0].slopes[0].value().value, std::sqrt(0.9), 0.02);
  EXPECT_NEAR(analysis.influences[1].slopes[0].value().value, -std::sqrt(0.1), 0.02);
  EXPECT_FALSE(analysis.influences[2].slopes[0]) << "what does not vary says nothing";
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
  EXPECT_EQ(analyse(made(99), {.runs = 99}, {}, {}).no_influences,
            "The largest hold error is known of 99 runs, and it takes 100 to tell what it depends on.");
  FlownCampaign same = made(120);
  for (FlownRun& run : same.runs) {
    run.figures[0] = 3.0;
  }
  EXPECT_EQ(analyse(same, {.runs = 60}, {}, {}).no_influences, "The largest hold error is the same in all runs.");
}

// Whoever reads the shares of an older version finds their keys, and why there are none.
TEST(CampaignReport, GivesSlopesOfEveryFigureAndNoSharesOfTheVariance) {
  Report report{.flown = made(400)};
  report.campaign.runs = 400;
  report.analysis = analyse(report.flown, report.campaign, {}, {});
  report.run_folders.assign(5, "");
  const json::Value said = json::parse(report_json(report));
  const json::Value& influences = said["influences"];
  EXPECT_NE(influences["why_no_variance_share"].text().find("Use slope."), std::string::npos);
  const json::Value& first = influences["of"][0];
  EXPECT_TRUE(first["variance_share"].is_null());
  EXPECT_TRUE(first["variance_share_of"]["largest_hold_error_deg"].is_null());
  EXPECT_NEAR(first["slope"]["value"].number(), std::sqrt(0.9), 0.05);
  EXPECT_EQ(first["slope_of"]["largest_hold_error_deg"].number(), first["slope"]["value"].number());
  EXPECT_TRUE(influences["of"][2]["slope"].is_null());
  const std::string text = report_text(report);
  EXPECT_NE(text.find("Straight lines of all quantities together explain 100 % of the variance. Slopes do not show "
                      "curves, thresholds, or effects of two quantities together."),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("share of its variance"), std::string::npos) << text;
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

TEST(CampaignReport, BeginsWithTheRunsThatAreFasterThanTheModelHoldsForWhateverIsAsked) {
  Report report{.flown = made(60)};
  report.campaign.runs = 60;
  for (FlownRun& run : report.flown.runs) {
    run.figures[top_mach_column] = run.run < 20 ? 1.27 : 0.79;
  }
  report.analysis = analyse(report.flown, report.campaign, parse_question("largest_hold_error_deg<=1000"), 0.5);
  report.run_folders.assign(5, "");
  EXPECT_TRUE(
      headline(report).starts_with("Outside the model: 20 of 60 runs are faster than Mach 0.8, up to Mach 1.27. "))
      << headline(report);
  EXPECT_NE(report_html(report).find("class=\"verdict unsure"), std::string::npos) << "met, and amber all the same";
  EXPECT_NE(report_json(report).find("\"runs_outside_model\": 20"), std::string::npos);
  for (FlownRun& run : report.flown.runs) {
    run.figures[top_mach_column] = 0.79;
  }
  EXPECT_FALSE(headline(report).starts_with("Outside"));
  for (FlownRun& run : report.flown.runs) {
    run.figures[top_mach_column + 1] = run.run < 7 ? -0.25 : 0.1;
    run.figures[top_mach_column + 2] = run.run < 9 ? 15.1 : 14.9;
  }
  EXPECT_TRUE(headline(report).starts_with(
      "Outside the model: 7 of 60 runs are of a rocket that is not stable, with a static margin down to -0.25 "
      "calibres; 9 of 60 runs meet "
      "the air at more than 15 deg, with an angle of attack of up to 15.1 deg under control. "))
      << headline(report);
  EXPECT_NE(report_json(report).find("\"runs_outside_model\": 9"), std::string::npos);
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
