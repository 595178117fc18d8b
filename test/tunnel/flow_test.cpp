// SPDX-License-Identifier: MIT
#include "tunnel/flow.hpp"

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "logs/refused.hpp"
#include "tunnel/made_logs.hpp"

namespace fantail::tunnel {
namespace {

// 40 readings in turns above and below 10 m/s, at a fan of 500 rpm: a sample with a standard deviation of 0.05 m/s.
TunnelLog alternating() {
  const double apart = 0.05 * std::sqrt(39.0 / 40.0);
  return made_tunnel_log(
      80.0, [](double) { return 500.0; },
      [apart](double t) { return std::lround(t / 2.0) % 2 == 0 ? 10.0 + apart : 10.0 - apart; });
}

TEST(Flow, OfSpeedsThatAlternateHasTheTurbulenceOfTheClosedForm) {
  const TunnelLog log = alternating();
  const Flow flow = examine_flow(log, find_steady(log, {}));
  ASSERT_EQ(flow.points.size(), 1U);
  EXPECT_EQ(flow.points[0].segment.count, 40U);
  EXPECT_NEAR(flow.points[0].mean_m_s, 10.0, 1e-12);
  EXPECT_NEAR(flow.points[0].deviation_m_s, 0.05, 1e-12);
  EXPECT_NEAR(flow.points[0].gamma_m_s, 0.00025, 1e-14);
  EXPECT_NEAR(flow.points[0].relative_deviation, 0.005, 1e-14);
  EXPECT_FALSE(flow.line.has_value());
}

TEST(Flow, SaysWhatRoundingAloneMakes) {
  const TunnelLog log = made_tunnel_log(
      80.0, [](double) { return 500.0; }, [](double t) { return std::lround(t / 2.0) % 2 == 0 ? 10.0 : 10.1; });
  const Flow flow = examine_flow(log, find_steady(log, {}));
  EXPECT_EQ(flow.rounding_m_s, 0.1);
  EXPECT_NEAR(flow.points[0].rounding_share, 0.1 / std::sqrt(12.0) / 10.05, 1e-12);
  ASSERT_EQ(flow.remarks.size(), 1U);
  EXPECT_NE(flow.remarks[0].find("0.029 m/s"), std::string::npos) << flow.remarks[0];
}

TEST(Flow, SpeedsOnALineGiveTheLine) {
  const auto fan = [](double t) { return 500.0 + 100.0 * std::floor(t / 60.0); };
  const TunnelLog log = made_tunnel_log(240.0, fan, [&](double t) { return 1.0 + 0.02 * fan(t); });
  const Flow flow = examine_flow(log, find_steady(log, {}));
  ASSERT_EQ(flow.points.size(), 4U);
  ASSERT_TRUE(flow.line.has_value());
  EXPECT_NEAR(flow.line->slope, 0.02, 1e-12);
  EXPECT_NEAR(flow.line->offset, 1.0, 1e-9);
  EXPECT_NEAR(flow.line->r_squared, 1.0, 1e-12);
}

TEST(Flow, NothingSteadyOrStillAirIsRefused) {
  const TunnelLog ramp = made_tunnel_log(100.0, [](double) { return 500.0; }, [](double t) { return 0.1 * t; });
  test::expect_refused(text::ErrorKind::bad_data, {"made.csv", "was not steady", "500 rpm from 0 to 98 s"},
                       [&] { (void)examine_flow(ramp, find_steady(ramp, {})); });
  const TunnelLog still = made_tunnel_log(100.0, [](double) { return 500.0; }, [](double) { return 0.0; });
  test::expect_refused(text::ErrorKind::bad_data, {"made.csv", "mean wind speed 0 m/s"},
                       [&] { (void)examine_flow(still, find_steady(still, {})); });
}

TEST(FlowReport, SaysTheSameToPersonScriptAndPage) {
  const TunnelLog log = alternating();
  const Flow flow = examine_flow(log, find_steady(log, {}));
  const result::Document found = flow_answer(log, flow, {});
  const std::string text = result::text(found);
  EXPECT_NE(text.find(" 0.00025 "), std::string::npos) << text;
  EXPECT_NE(text.find(" 0.500 "), std::string::npos) << text;
  const json::Value json = json::parse(result::json(found));
  EXPECT_EQ(json["set_points"][0]["gamma_m_s"], 0.00025);
  EXPECT_EQ(json["set_points"][0]["relative_deviation"], 0.005);
  EXPECT_TRUE(json["line"].is_null());
}

}  // namespace
}  // namespace fantail::tunnel
