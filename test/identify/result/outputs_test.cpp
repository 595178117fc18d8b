// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "identify/planted_log.hpp"
#include "identify/result/answer.hpp"
#include "identify/result/words.hpp"
#include "json/value.hpp"
#include "system/folder.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A planted roll with a little noise, as a person would report it.
Study example(const std::vector<Method>& methods = {Method::continuous}, const std::string& nodes = "even:1") {
  Record noisy = planted_record({});
  add_noise(noisy, {.angle_deg = 0.1}, 1);
  logs::RollLog log = planted_log({});
  log.roll_angle_rad = noisy.roll_angle_rad;
  log.warnings = {"angles look odd"};
  Question question = planted_question(nodes);
  question.methods = methods;
  Study result = study(log, question);
  result.vehicle = "a rocket";
  result.density = "1.2 kg/m3";
  result.speed = "speed_m_s";
  return result;
}

json::Value json_of(const Study& found) { return json::parse(fantail::result::json(answer(found))); }

// Numbers without a log behind them, so that every word of the output is known.
Identification known() {
  Identification result;
  result.model = {.alpha_m2 = 22.871, .beta_m = 9.05, .node_time_s = {0.0, 2.0}, .node_rad = {-0.1, -0.12}};
  Uncertainty u;
  u.standard_deviation = {0.41, 0.052, 0.002, 0.003};
  u.correlation = Eigen::MatrixXd::Identity(4, 4);
  u.interval = {{21.9, 23.7}, {8.94, 9.16}, {-0.104, -0.096}, {-0.126, -0.114}};
  u.alpha_profile_m2 = {22.1, 23.72};
  u.verdict = "alpha and beta are identifiable from this window";
  result.uncertainty = u;
  return result;
}

TEST(Words, OfAConstantAreItsDigits) {
  EXPECT_EQ(with_deviation(known(), 0), "22.87 \u00b1 0.41");
  EXPECT_EQ(constant_text(0.0019271), "0.001927");  // alpha and beta go with one over the reference area
  EXPECT_EQ(constant_text(22.8712), "22.87");
}

TEST(Words, ShowTwoConstantsByTheDigitsThatTellThemApart) {
  EXPECT_EQ(change_text(20.08, 23.0, "m2"), "20.08 m2 instead of 23");
  EXPECT_EQ(change_text(0.1121, 0.1149, "m"), "0.1121 m instead of 0.1149");
  EXPECT_EQ(change_text(0.11210, 0.11213, "m"), "0.1121 m instead of 0.11213");
  EXPECT_EQ(change_text(0.112101, 0.112102, "m"), "0.1121 m as before");
}

TEST(Words, SayHowWellANumberIsKnown) {
  Identification result = known();
  EXPECT_EQ(figures(precision_sentence(result, 0)), (std::vector<std::string>{"22.10", "23.72", "95", "3.5"}));
  EXPECT_TRUE(holds(precision_sentence(result, 0), "alpha"));
  EXPECT_TRUE(holds(precision_sentence(result, 3), "2 s into the window"));
  result.uncertainty->alpha_profile_m2 = {4.0, 40.0};
  EXPECT_TRUE(holds(precision_sentence(result, 0), "uncertain"));
  result.uncertainty->alpha_profile_m2 = {4.0, {}};
  EXPECT_EQ(figures(precision_sentence(result, 0)), (std::vector<std::string>{"22.87", "4.00"}));
}

TEST(ResultJson, OfOneResultIsTheResultItself) {
  const Study found = example();
  const auto json = json_of(found);
  for (const char* key :
       {"mean_abs_angle_error_deg", "mean_abs_rate_error_deg_s", "alpha_sd_m2", "beta_sd_m", "disturbance_sd_deg",
        "alpha_interval_m2", "beta_interval_m", "alpha_identifiable", "verdict", "window"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* key : {"results", "node_curve", "servo_lag_s", "huber_threshold_deg"}) {
    EXPECT_FALSE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["answer"], "yes");
  EXPECT_EQ(json["method"], "continuous");
  EXPECT_EQ(json["loop"], "open");
  EXPECT_EQ(json["samples"], 401);
  EXPECT_DOUBLE_EQ(json["seconds"].number(), 4.0);
  EXPECT_NEAR(json["alpha_m2"].number(), found.windows[0].results[0].model.alpha_m2, 1e-6);
  EXPECT_EQ(json["node_time_s"], (json::Value::array({2.0, 6.0}))) << "on the log's clock";
  EXPECT_EQ(json["disturbance_deg"].size(), 2U);
  EXPECT_NEAR(json["disturbance_deg"][0].number(), -5.0, 0.5);  // planted
  EXPECT_EQ(json["disturbance_interval_deg"].size(), 2U);
  EXPECT_EQ(json["correlation"].size(), 4U);
  EXPECT_EQ(json["correlation"][3].size(), 4U);
  EXPECT_EQ(json["remarks"][0], "angles look odd");
}

TEST(ResultJson, OfSeveralIsAListOfThem) {
  const auto json = json_of(example({Method::grid, Method::continuous}));
  ASSERT_EQ(json["results"].size(), 2U);
  EXPECT_EQ(json["results"][0]["method"], "grid");
  EXPECT_EQ(json["results"][1]["method"], "continuous");
  EXPECT_EQ(json["results"][1]["density"], "1.2 kg/m3");
}

TEST(ResultJson, HasNullForAnOpenEnd) {
  Study found = example();
  found.windows[0].results[0].uncertainty->alpha_profile_m2 = {.low = 3.0, .high = {}};
  const auto json = json_of(found);
  EXPECT_EQ(json["alpha_interval_m2"], (json::Value::array({3.0, {}})));
}

TEST(ResultJson, HasTheCurveOverTheNodesWhenTheyWereChosen) {
  const auto json = json_of(example({Method::continuous}, "auto"));
  ASSERT_EQ(json["node_curve"].size(), 6U);
  EXPECT_EQ(json["node_curve"][0]["intervals"], 1);
  EXPECT_TRUE(json["node_curve"][0].contains("mean_abs_angle_error_deg"));
}

TEST(ResultText, SetsTheMethodsSideBySideAndSaysWhatTheyAreWorth) {
  const std::string text = fantail::result::text(answer(example({Method::grid, Method::continuous})));
  for (const char* part : {"  grid, open loop  continuous, open loop\n", "damping alpha, m2", "angles look odd",
                           "2 s to 6 s", "401 samples", "identifiable"}) {
    EXPECT_TRUE(holds(text, part)) << part << "\n" << text;
  }
}

TEST(ModelCsv, HasARowASampleOnTheLogsClock) {
  Record record;
  record.time_s = {0.0, 1.0};
  record.window_begin_s = 2.0;
  record.roll_angle_rad = {0.1, 0.2};
  record.roll_rate_rad_s = {0.0, 1.0};
  Simulation simulation;
  simulation.roll_angle_rad = {0.1, 0.3};
  simulation.roll_rate_rad_s = {0.0, 2.0};
  simulation.canard_rad = {0.05, -0.05};
  const RollModel model{.alpha_m2 = 1.0, .beta_m = 1.0, .node_time_s = {0.0, 2.0}, .node_rad = {0.0, 0.2}};
  const WindowFindings window{.record = record, .results = {{.model = model, .simulation = simulation}}};
  const auto document = answer(Study{.windows = {window}});
  ASSERT_EQ(document.spreadsheets.size(), 1U);
  EXPECT_EQ(fantail::result::csv(document.spreadsheets.front()),
            "time_s,roll_angle_deg,model_roll_angle_deg,roll_rate_deg_s,model_roll_rate_deg_s,canard_deg,"
            "disturbance_deg\n"
            "2.000000,5.729578,5.729578,0.000000,0.000000,2.864789,0.000000\n"
            "3.000000,11.459156,17.188734,57.295780,114.591559,-2.864789,5.729578\n");
}

TEST(ResultPage, LoadsNothingAndEscapesNames) {
  Study found = example({Method::grid, Method::continuous}, "auto");
  found.data = "<img src=x>";
  const std::string page = fantail::result::html(answer(found));
  for (const char* way : {"src=x>", "@import", "<link", "href=\"http", "<script src", "fetch("}) {
    EXPECT_FALSE(holds(page, way)) << way;
  }
  for (const char* part :
       {"How well each number is known", "Residuals", "The error over alpha and beta", "How many nodes (grid)",
        "How many nodes (continuous)", "identifiable", "angles look odd", "95 % interval"}) {
    EXPECT_TRUE(holds(page, part)) << part;
  }
}

TEST(ResultPage, HasAPartForEachWindow) {
  Study found = example();
  found.windows.push_back(found.windows[0]);
  found.windows[1].record.window = "step:2";
  found.windows[1].results[0].uncertainty->alpha_identifiable = false;
  const std::string page = fantail::result::html(answer(found));
  EXPECT_TRUE(holds(page, "1 of 2 windows"));
  EXPECT_TRUE(holds(page, "<h2>Window all</h2>"));
  EXPECT_TRUE(holds(page, "<h2>Window step:2</h2>"));
}

std::vector<std::string> sheets(const fantail::result::Document& document) {
  std::vector<std::string> all;
  for (const auto& sheet : document.spreadsheets) {
    all.push_back(*sheet.key + ".csv");
  }
  return all;
}

TEST(ModelCsv, OfAnEarlierResultIsStaleAndAFileOfSomebodyElseIsNot) {
  const test::Folder folder;
  const auto one = answer(example());
  const auto two = answer(example({Method::grid, Method::continuous}));
  EXPECT_EQ(sheets(one), (std::vector<std::string>{"model.csv"}));
  EXPECT_EQ(sheets(two), (std::vector<std::string>{"model_1.csv", "model_2.csv"}));
  for (const auto& sheet : two.spreadsheets) {
    folder.write(*sheet.key + ".csv", fantail::result::csv(sheet));
  }
  EXPECT_EQ(stale_models(folder.path(), two), std::vector<std::string>{});
  EXPECT_EQ(stale_models(folder.path(), one), (std::vector<std::string>{"model_1.csv", "model_2.csv"}));
  folder.write("model_1.csv", "mine");
  EXPECT_EQ(stale_models(folder.path(), one), (std::vector<std::string>{"model_2.csv"}));
}

}  // namespace
}  // namespace fantail::identify::result
