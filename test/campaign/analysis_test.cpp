// SPDX-License-Identifier: MIT
#include "campaign/analysis.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "campaign/results.hpp"
#include "figures.hpp"
#include "json/value.hpp"
#include "page/chart.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

/// The first of them.
Numbers figures_before(const std::string& sentence, std::size_t count) {
  Numbers all = figures(sentence);
  all.resize(std::min(count, all.size()));
  return all;
}

/// Runs whose hold error is 6 + 3 a - b, of two standard normal numbers; "held" up to 10.
FlownCampaign made(std::size_t count) {
  FlownCampaign flown{.scenario = "made", .vehicle = "v", .plan = "p", .quantities = {"a", "b", "same"}};
  sim::Random random{11, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const double a = random.gaussian();
    const double b = random.gaussian();
    FlownRun run{.run = i, .seed = i, .numbers = {a, b, 5.0}};
    run.figures[0] = 6.0 + 3.0 * a - b;
    if (*run.figures[0] > 10.0) {
      run.outcome = "not_held";
      run.failed_by = {"hold_error"};
    } else {
      run.outcome = "held";
    }
    flown.runs.push_back(std::move(run));
  }
  return flown;
}

/// The numbers behind name=" in the text from `at` on.
double attribute(const std::string& svg, std::size_t at, const std::string& name) {
  return std::stod(svg.substr(svg.find(' ' + name + "=\"", at) + name.size() + 3));
}

TEST(Analysis, ABarOfAnInfluenceReachesFromZeroToItsSlopeAndTheLargestStandsFirst) {
  Report report{.flown = made(4000)};
  report.analysis = analyse(report.flown, {.runs = 4000}, {}, 0.5);
  const std::string svg = tornado_svg(report, 0, page::full_page);
  const std::size_t first = svg.find("<rect class=\"bar");
  const std::size_t second = svg.find("<rect class=\"bar", first + 1);
  ASSERT_NE(second, std::string::npos) << svg;
  EXPECT_EQ(svg.find("<rect class=\"bar", second + 1), std::string::npos) << "what does not vary has none";
  const std::size_t frame = svg.find("<rect class=\"frame");
  const double zero = attribute(svg, frame, "x") + 0.5 * attribute(svg, frame, "width");
  EXPECT_NEAR(attribute(svg, first, "x"), zero, 0.2) << "to the right: the slope of a is above zero";
  EXPECT_NEAR(attribute(svg, second, "x") + attribute(svg, second, "width"), zero, 0.2);
  EXPECT_NEAR(attribute(svg, first, "width") / attribute(svg, second, "width"), 3.0, 0.3);
}

TEST(Analysis, ANarrowDrawingOfInfluencesHasEachNameAboveItsBarAndNumbersBesideZero) {
  Report report{.flown = made(400)};
  report.flown.quantities[0] = "aerodynamics.damping_m2_factor";
  report.analysis = analyse(report.flown, {.runs = 400}, {}, 0.5);
  const std::string svg = tornado_svg(report, 0, page::half_page);
  const std::size_t name = svg.find(">aerodynamics: damping, factor<");
  ASSERT_NE(name, std::string::npos) << svg;
  const std::size_t text = svg.rfind("<text", name);
  const std::size_t bar = svg.find("<rect class=\"bar", text);
  EXPECT_LT(attribute(svg, text, "y"), attribute(svg, bar, "y"));
  std::size_t ticks = 0;
  for (std::size_t at = svg.find("<path class=\"tick\""); at != std::string::npos;
       at = svg.find("<path class=\"tick\"", at + 1)) {
    ++ticks;
  }
  EXPECT_GE(ticks, 3U);
}

TEST(Analysis, AHistogramLeavesOutWhatIsFarFromAllOthersAndSaysHowMany) {
  Report report{.flown = made(400)};
  report.flown.runs[0].figures[0] = 2913.0;
  report.analysis = analyse(report.flown, {.runs = 400}, {}, {});
  const page::Chart chart = histogram(report.analysis.figures[0]);
  double runs = 0.0;
  std::size_t filled = 0;
  for (const double count : chart.series[0].y) {
    runs += count;
    filled += count > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(runs, 399.0);
  EXPECT_GT(filled, 5U);
  EXPECT_LT(chart.series[0].x.back(), 60.0);
  const Numbers said = figures(runs_beyond_histogram(report.analysis.figures[0]));
  EXPECT_EQ(said.front(), "1");
  EXPECT_EQ(said[1], "400");
  EXPECT_EQ(said.back(), "2913");
  report.flown.runs[0].figures[0] = 6.0;
  report.analysis = analyse(report.flown, {.runs = 400}, {}, {});
  EXPECT_EQ(runs_beyond_histogram(report.analysis.figures[0]), "");
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
  EXPECT_EQ(flown.runs[analysis.worst[0].index].figures[0], largest);
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
  EXPECT_EQ(figures(analyse(made(99), {.runs = 99}, {}, {}).fits[0].why_none), (Numbers{"99", "100"}));
  EXPECT_EQ(analyse(made(120), {.runs = 120}, {}, {}).fits[0].why_none, "");
  FlownCampaign same = made(120);
  for (FlownRun& run : same.runs) {
    run.figures[0] = 3.0;
  }
  const std::string why = analyse(same, {.runs = 60}, {}, {}).fits[0].why_none;
  EXPECT_NE(why.find("same"), std::string::npos) << why;
  EXPECT_EQ(figures(why), Numbers{});
}

/// With these runs, as a campaign that asked for no fewer.
Report report_of(FlownCampaign flown, const Question& question = {}, std::optional<double> required = {}) {
  Report report{.campaign = {.runs = flown.runs.size()}, .flown = std::move(flown), .run_folders{5, ""}};
  report.analysis = analyse(report.flown, report.campaign, question, required);
  return report;
}

json::Value said_of(const Report& report) { return json::parse(result::json(answer(report))); }

// Whoever reads the shares of an older version finds their keys, and why there are none.
TEST(CampaignReport, GivesSlopesOfEveryFigureAndNoSharesOfTheVariance) {
  const Report report = report_of(made(400));
  const json::Value influences = said_of(report)["influences"];
  EXPECT_FALSE(influences["why_no_variance_share"].is_null());
  const json::Value& first = influences["of"][0];
  EXPECT_TRUE(first["variance_share"].is_null());
  EXPECT_TRUE(first["variance_share_of"]["largest_hold_error_deg"].is_null());
  EXPECT_NEAR(first["slope"]["value"].number(), std::sqrt(0.9), 0.05);
  EXPECT_EQ(first["slope_of"]["largest_hold_error_deg"].number(), first["slope"]["value"].number());
  EXPECT_TRUE(influences["of"][2]["slope"].is_null());
  EXPECT_NEAR(influences["explained_by_straight_lines"].number(), 1.0, 1e-6);
  EXPECT_EQ(result::text(answer(report)).find("share of its variance"), std::string::npos);
}

// Wilson's interval of 199 in 200 ends at 99.912 %.
TEST(CampaignReport, RoundsNoBoundOverWhatIsAskedFor) {
  FlownCampaign flown = made(200);
  for (FlownRun& run : flown.runs) {
    run.outcome = run.run == 0 ? "not_held" : "held";
  }
  for (const auto& [required, end] : {std::pair{0.9995, "99.92"}, {0.99915, "99.912"}}) {
    const Report report = report_of(flown, {}, required);
    EXPECT_EQ(figures(headline(report)).back(), end) << headline(report);
    EXPECT_EQ(answer_of(report), result::Answer::no);
  }
}

// The largest hold error of all is below 1000 degrees: met, and undecided all the same.
TEST(CampaignReport, IsUndecidedOfRunsThatLieOutsideTheModelWhateverIsAskedAndBeginsWithThem) {
  const auto report = [](const auto& change) {
    FlownCampaign flown = made(60);
    for (FlownRun& run : flown.runs) {
      change(run);
    }
    return report_of(std::move(flown), parse_question("largest_hold_error_deg<=1000"), 0.5);
  };
  const Report fast = report([](FlownRun& run) { run.figures[top_mach_column] = run.run < 20 ? 1.27 : 0.79; });
  EXPECT_EQ(figures_before(headline(fast), 4), (Numbers{"20", "60", "0.8", "1.27"})) << headline(fast);
  EXPECT_EQ(said_of(fast)["answer"], "undecided");
  EXPECT_EQ(said_of(fast)["judgement"], "met");
  EXPECT_EQ(said_of(fast)["runs_outside_model"], 20);
  EXPECT_EQ(said_of(report([](FlownRun& run) { run.figures[top_mach_column] = 0.79; }))["answer"], "yes");
  const Report unstable = report([](FlownRun& run) {
    run.figures[top_mach_column + 1] = run.run < 7 ? -0.25 : 0.1;
    run.figures[top_mach_column + 2] = run.run < 9 ? 15.1 : 14.9;
  });
  EXPECT_EQ(figures_before(headline(unstable), 7), (Numbers{"7", "60", "-0.25", "9", "60", "15", "15.1"}))
      << headline(unstable);
  EXPECT_EQ(said_of(unstable)["runs_outside_model"], 9);
}

TEST(CampaignReport, CountsRunsWithoutAFlightAsNotMetAndNamesThem) {
  FlownCampaign flown = made(60);
  flown.runs[7].outcome = "refused";
  flown.runs[7].note = "mass_kg = 0.1";
  flown.runs[7].figures[0].reset();
  flown.runs[9].outcome = "not_finite";
  flown.runs[9].note = "apogee_m is no number";
  const Report report = report_of(std::move(flown));
  EXPECT_LE(said_of(report)["share"]["count"].number(), 58.0);
  for (const std::string& all : {result::text(answer(report)), result::html(answer(report))}) {
    EXPECT_NE(all.find("run 7: mass_kg = 0.1"), std::string::npos) << all;
    EXPECT_NE(all.find("run 9: apogee_m is no number"), std::string::npos) << all;
  }
}

TEST(CampaignReport, OfOneRunSaysRun) {
  const Report report = report_of(made(1));
  EXPECT_EQ(result::text(answer(report)).find("1 runs"), std::string::npos) << result::text(answer(report));
}

}  // namespace
}  // namespace fantail::campaign
