// SPDX-License-Identifier: MIT
#include "predict/tunnel_result.hpp"

#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "logs/refused.hpp"
#include "system/folder.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::predict {
namespace {

using test::Folder;
using text::degrees;
using text::radians;

TunnelResult shipped(const std::string& name, const std::optional<double>& swirl_rad = {}) {
  return read_tunnel_result(input::find_input(input::Shipped::tunnel_result, name), swirl_rad);
}

struct Means {
  double damping_m2 = 0.0;
  double torque_m = 0.0;
  double begin_deg = 0.0;
  double end_deg = 0.0;
};

Means means(const TunnelResult& result) {
  Means m;
  const auto n = static_cast<double>(result.steps.size());
  for (const TunnelStep& step : result.steps) {
    m.damping_m2 += step.damping_m2 / n;
    m.torque_m += step.torque_m / n;
    m.begin_deg += degrees(step.offset_begin_rad) / n;
    m.end_deg += degrees(step.offset_end_rad) / n;
  }
  return m;
}

void expect_swirl(const TunnelResult& result, const char* degrees, const char* source) {
  EXPECT_EQ(figures(result.swirl_words), std::vector<std::string>{degrees});
  EXPECT_NE(result.swirl_words.find(source), std::string::npos) << result.swirl_words;
}

TEST(Oracle, Row25MeansOfTable2) {
  const Means m = means(shipped("tasha3_table2", 0.0));
  EXPECT_NEAR(m.damping_m2, 19.375, 0.001);
  EXPECT_NEAR(m.torque_m, 9.625, 0.001);
  EXPECT_NEAR(m.begin_deg, -5.529, 0.001);
  EXPECT_NEAR(m.end_deg, -6.616, 0.001);
}

// Published: an average offset of -6.1 degrees over the steps, "taking into account the swirl ... -4.1".
TEST(TunnelResult, TakesOffTheSwirlThatItsFileNames) {
  const TunnelResult result = shipped("tasha3_table2");
  EXPECT_NEAR(degrees(result.swirl_rad), -2.0, 1e-12);
  const Means m = means(result);
  EXPECT_NEAR(0.5 * (m.begin_deg + m.end_deg), -4.1, 0.05);
  expect_swirl(result, "-2", "swirl_deg of tasha3_table2.csv");
}

TEST(TunnelResult, SwirlThatIsGivenCountsInsteadOfTheFiles) {
  const TunnelResult result = shipped("tasha3_table2", radians(-1.0));
  EXPECT_NEAR(degrees(result.steps.front().offset_begin_rad), -4.59, 1e-12);
  expect_swirl(result, "-1", "--swirl");
}

// It was taken for none: steps that the swirl had made look straighter became a go.
TEST(TunnelResult, IsRefusedWhereNobodySaysWhatTheSwirlWas) {
  const Folder folder;
  const std::string file =
      folder.write("steps.csv",
                   "step,begin_s,alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg\n1,0,20,"
                   "9,-5,-6\n2,5,18,8,-4,-7\n3,9,18,8,-4,-7\n");
  test::expect_refused(
      text::ErrorKind::bad_configuration,
      {"steps.csv: the swirl of the tunnel is not given", "--swirl DEG", "fantail tunnel swirl", "--swirl 0 means"},
      [&] { (void)read_tunnel_result(file, {}); });
  const TunnelResult none = read_tunnel_result(file, 0.0);
  EXPECT_NEAR(degrees(none.steps[1].offset_end_rad), -7.0, 1e-12);
  expect_swirl(none, "0", "--swirl");
  EXPECT_TRUE(none.sources.empty());
}

TEST(TunnelResult, ReadsTheStandardErrorsOfTheSteps) {
  const Folder folder;
  const std::string head = "alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg";
  const std::string errors =
      ",alpha_standard_error_m2,beta_standard_error_m,disturbance_begin_standard_error_deg,"
      "disturbance_end_standard_error_deg";
  const TunnelResult result =
      read_tunnel_result(folder.write("steps.csv", head + errors +
                                                       "\n20,9,-5,-6,0.4,0.1,0.02,0.03\n18,8,-4,-7,0.5,0.1,0.02,0.03\n"
                                                       "19,9,-5,-6,0.4,0.1,0.02,0.03\n"),
                         0.0);
  ASSERT_EQ(result.standard_errors.size(), 3U);
  EXPECT_EQ(result.standard_errors[1].damping_m2, 0.5);
  EXPECT_NEAR(degrees(result.standard_errors[0].offset_end_rad), 0.03, 1e-12);
  EXPECT_TRUE(shipped("tasha3_table2").standard_errors.empty());
}

TEST(TunnelResult, OfTheFirstLaunchSaysThatItIsHindsight) {
  const TunnelResult result = shipped("tasha3_launch1_flight");
  ASSERT_EQ(result.sources.size(), 1U);
  EXPECT_NE(result.sources[0].find("wind-tunnel"), std::string::npos);
  EXPECT_NE(result.sources[0].find("hindsight"), std::string::npos);
  EXPECT_NEAR(means(result).damping_m2, 8.0, 1e-12);
  EXPECT_NEAR(means(result).end_deg, -7.15, 1e-12);
}

TEST(TunnelResult, SaysWhoseItIsWhereItsFileDoes) {
  EXPECT_EQ(shipped("tasha3_table2").vehicle, "Tasha III, launch 2");
  EXPECT_EQ(shipped("tasha3_launch1_flight").vehicle, "Tasha III, launch 1");
  EXPECT_FALSE(shipped("tasha3_table2").reference_area_m2);  // not printed
  const Folder folder;
  const TunnelResult own = read_tunnel_result(
      folder.write("steps.csv",
                   "alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,vehicle,reference_area_m2\n"
                   "20,9,-5,-6,\"A, B\",5e-3\n18,8,-4,-7,\"A, B\",5e-3\n18,8,-4,-7,\"A, B\",5e-3\n"),
      0.0);
  EXPECT_EQ(own.vehicle, "A, B");
  EXPECT_EQ(own.reference_area_m2, 5e-3);
}

TEST(TunnelResult, IsNamedByTheShippedLaunchesAndNobodyElse) {
  EXPECT_TRUE(input::load_scenario("tasha3_launch1", {}).tunnel_result->ends_with("/tasha3_launch1_flight.csv"));
  EXPECT_TRUE(input::load_scenario("tasha3_launch2", {}).tunnel_result->ends_with("/tasha3_table2.csv"));
  EXPECT_FALSE(input::load_scenario("tunnel_steps", {}).tunnel_result);
}

struct BadFile {
  const char* text;
  const char* said;
};

class BadTunnelResult : public testing::TestWithParam<BadFile> {};

TEST_P(BadTunnelResult, IsRefusedAndSaysWhere) {
  const Folder folder;
  const std::string file = folder.write("steps.csv", GetParam().text);
  try {
    (void)read_tunnel_result(file, {});
    FAIL() << "not refused";
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), text::ErrorKind::bad_data);
    EXPECT_NE(std::string{error.what()}.find(GetParam().said), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadTunnelResult,
    testing::Values(
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg\n1,1,1\n1,1,1\n1,1,1\n", "disturbance_end_deg"},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg\n19,9,-5,-6\n-19,9,-5,-6\n19,9,-5,-6\n",
                "steps.csv:3: alpha_m2 = \"-19\"; allowed: 0.001 to 10000"},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg\n19,nan,-5,-6\n19,9,-5,-6\n19,9,-5,-6\n",
                "steps.csv:2: beta_m = \"nan\""},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,swirl_deg\n19,9,-5,-6,\n19,9,-5,-6,0\n19,9,-"
                "5,-6,0\n",
                "steps.csv:2: swirl_deg = \"\""},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg\n19,9,-5,-6\n", "has 1 of the rows"},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg\n19,9,-5,-6\n20,9,-5,-6\n",
                "has 2 of the rows that a spread is made from, one for each step. Allowed: 3 or more"},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,vehicle\n19,9,-5,-6,A\n20,9,-5,-6,B\n"
                "19,9,-5,-6,A\n",
                "steps.csv:3: vehicle = \"B\", and \"A\" in the first row"},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,reference_area_m2\n19,9,-5,-6,0\n"
                "20,9,-5,-6,0\n19,9,-5,-6,0\n",
                "steps.csv:2: reference_area_m2 = \"0\"; allowed: 1e-08 to 1"},
        BadFile{"alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,alpha_standard_error_m2\n19,9,-5,-6,1\n"
                "19,9,-5,-6,1\n19,9,-5,-6,1\n",
                "no column beta_standard_error_m"}),
    [](const auto& one) { return "Number" + std::to_string(one.index); });

}  // namespace
}  // namespace fantail::predict
