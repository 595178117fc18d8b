// SPDX-License-Identifier: MIT
#include "tunnel/swirl.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "logs/refused.hpp"
#include "tunnel/made_logs.hpp"

namespace fantail::tunnel {
namespace {

const SwirlOptions tasha3{.roll = published_roll()};

// A session of 60 s at each speed, rolling at the steady rate of an offset: p = beta v u / alpha.
RollSession made_session(const std::vector<double>& speeds_m_s, double offset_deg) {
  RollSession session;
  session.roll.name = "rolls.csv";
  const auto speed_at = [&](double t) { return speeds_m_s[static_cast<std::size_t>(t / 60.0)]; };
  const double end_s = 60.0 * static_cast<double>(speeds_m_s.size());
  session.wind = made_tunnel_log(end_s, [&](double t) { return 50.0 * speed_at(t); }, speed_at);
  for (int i = 0; i < 10.0 * end_s; ++i) {
    session.roll.time_s.push_back(0.1 * i);
    session.roll.roll_rate_rad_s.push_back(offset_deg * degree * 9.6 * speed_at(0.1 * i) / 19.4);
  }
  session.steady = find_steady(session.wind, {});
  return session;
}

TEST(Swirl, IsTheDifferenceOfTheTwoOffsets) {
  const Swirl swirl =
      examine_swirl(made_session({10.0, 22.0, 30.0}, -6.1), made_session({10.0, 22.0, 30.0}, -4.1), tasha3);
  ASSERT_EQ(swirl.without.size(), 3U);
  ASSERT_EQ(swirl.with.size(), 3U);
  EXPECT_NEAR(swirl.without[1].rate_rad_s.mean / degree, -66.41, 0.005);
  EXPECT_NEAR(swirl.with[1].rate_rad_s.mean / degree, -44.64, 0.005);
  EXPECT_NEAR(swirl.without[1].offset_rad / degree, -6.1, 1e-9);
  EXPECT_NEAR(swirl.with[1].offset_rad / degree, -4.1, 1e-9);
  ASSERT_TRUE(swirl.swirl.has_value());
  EXPECT_NEAR(swirl.swirl->offset_rad / degree, -2.0, 1e-9);
  EXPECT_EQ(swirl.swirl->speeds, 2U);  // 10 m/s does not count
}

// Eq 27 with the numbers of the printed runs.
TEST(Swirl, TheOffsetOfARollRateIsThatOfTheSteadyState) {
  RollSession session = made_session({22.0}, 0.0);
  session.roll.roll_rate_rad_s.assign(session.roll.time_s.size(), -66.0 * degree);
  EXPECT_NEAR(examine_swirl(session, session, tasha3).without[0].offset_rad / degree, -6.0625, 1e-4);
  EXPECT_NEAR(examine_swirl(session, session, {.roll = {.alpha_m2 = 23.0, .beta_m = 9.0, .source = "as given"}})
                      .without[0]
                      .offset_rad /
                  degree,
              -23.0 * 66.0 / (9.0 * 22.0), 1e-9);
}

TEST(Swirl, WhatTheCanardsDidIsNoOffsetOfTheFins) {
  RollSession session = made_session({22.0}, -6.0);
  session.roll.canard_rad.assign(session.roll.time_s.size(), 0.5 * degree);
  const Swirl swirl = examine_swirl(session, made_session({22.0}, -4.0), tasha3);
  EXPECT_NEAR(swirl.without[0].canard_rad / degree, 0.5, 1e-9);
  EXPECT_NEAR(swirl.without[0].offset_rad / degree, -6.5, 1e-9);
  // An encoder that was silent for a while says nothing about the mean.
  session.roll.canard_rad[300] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(examine_swirl(session, session, tasha3).without[0].offset_rad / degree, -6.0, 1e-9);
}

TEST(Swirl, SpeedsOfOneSessionOnlyAreInterpolatedOrLeftOut) {
  // Offsets that grow with speed, so that a point taken from the wrong place shows.
  RollSession with = made_session({12.0, 24.0}, 0.0);
  for (std::size_t i = 0; i < with.roll.time_s.size(); ++i) {
    const double speed_m_s = with.roll.time_s[i] < 60.0 ? 12.0 : 24.0;
    with.roll.roll_rate_rad_s[i] = (speed_m_s / 12.0) * degree * 9.6 * speed_m_s / 19.4;  // 1 and 2 deg
  }
  const Swirl swirl = examine_swirl(made_session({6.0, 12.2, 18.0, 24.0, 30.0}, 3.0), with,
                                    {.roll = published_roll(), .from_speed_m_s = 15.0});
  ASSERT_EQ(swirl.differences.size(), 3U);
  EXPECT_NEAR(swirl.differences[0].difference_rad / degree, 2.0, 1e-9);  // 12.2 m/s is the same as 12
  EXPECT_NEAR(swirl.differences[1].difference_rad / degree, 1.5, 1e-9);
  EXPECT_NEAR(swirl.differences[2].difference_rad / degree, 1.0, 1e-9);
  EXPECT_NEAR(swirl.swirl->offset_rad / degree, 1.25, 1e-9);
  EXPECT_NEAR(swirl.swirl->deviation_rad.value() / degree, 0.5 / std::sqrt(2.0), 1e-9);
}

// Without a common speed there is nothing to subtract, and that is a result.
TEST(Swirl, WithoutACommonSpeedThatIsFastEnoughThereIsNone) {
  const Swirl swirl = examine_swirl(made_session({10.0}, -6.0), made_session({10.0}, -4.0), tasha3);
  EXPECT_FALSE(swirl.swirl.has_value());
  EXPECT_EQ(swirl.remarks.size(), 1U);
  EXPECT_EQ(swirl_answer({made_session({10.0}, -6.0), made_session({10.0}, -4.0)}, swirl, {}).verdict.answer,
            result::Answer::undecided);
}

// Speeds that scatter by a twentieth of a step of the sensor all read alike: the mean is not known better than that.
TEST(Swirl, AConstantReadingIsNotKnownBetterThanItsRounding) {
  RollSession session = made_session({22.0, 24.3}, -6.0);
  const Swirl swirl = examine_swirl(session, session, tasha3);
  EXPECT_NEAR(swirl.without[0].speed_m_s.standard_error, 0.1 / std::sqrt(12.0), 1e-9);
  EXPECT_NEAR(swirl.without[0].standard_error_rad / degree, 6.0 * 0.1 / std::sqrt(12.0) / 22.0, 1e-6);
}

// Of many noisy sessions, 95 % give a swirl within two of the standard errors they state.
TEST(Swirl, ItsUncertaintyHoldsInManySessions) {
  constexpr int sessions = 300;
  const std::uint64_t seed = 27;
  Gaussian gaussian{seed};
  const auto noisy = [&](double offset_deg) {
    RollSession session = made_session({21.0, 24.0, 27.0}, offset_deg);
    double slow = 0.0;
    for (double& rate : session.roll.roll_rate_rad_s) {
      slow = 0.9 * slow + std::sqrt(1.0 - 0.81) * gaussian();
      rate += 2.0 * degree * slow;
    }
    for (double& speed : session.wind.wind_speed_m_s) {
      speed = to_tenths(speed + 0.1 * gaussian());
    }
    session.steady = take_steady(session.wind, {{.begin_s = 0.0}, {.begin_s = 60.0}, {.begin_s = 120.0}}, {});
    return session;
  };
  int within = 0;
  for (int i = 0; i < sessions; ++i) {
    const Swirl swirl = examine_swirl(noisy(-6.1), noisy(-4.1), tasha3);
    within += std::abs(swirl.swirl->offset_rad / degree + 2.0) < 2.0 * swirl.swirl->standard_error_rad / degree ? 1 : 0;
  }
  EXPECT_GE(within, sessions * 92 / 100) << "seed " << seed;
}

TEST(Swirl, WhatCannotBeComparedIsRefused) {
  RollSession session = made_session({22.0}, -6.0);
  RollSession elsewhere = session;
  for (double& time_s : elsewhere.roll.time_s) {
    time_s += 1000.0;
  }
  test::expect_refused(text::ErrorKind::bad_data, {"rolls.csv", "no roll rates from 0 to 58 s", "1000"},
                       [&] { (void)examine_swirl(elsewhere, session, tasha3); });
  RollSession still = session;
  still.wind.wind_speed_m_s.assign(still.wind.time_s.size(), 0.0);
  test::expect_refused(text::ErrorKind::bad_data, {"mean wind speed 0 m/s"},
                       [&] { (void)examine_swirl(session, still, tasha3); });
  RollSession never = session;
  never.steady.found.clear();
  test::expect_refused(text::ErrorKind::bad_data, {"was not steady"},
                       [&] { (void)examine_swirl(never, session, tasha3); });
}

TEST(SwirlReport, SaysTheSameToPersonScriptAndPage) {
  const SwirlSessions sessions{made_session({22.0, 30.0}, -6.1), made_session({22.0, 30.0}, -4.1)};
  const Swirl swirl = examine_swirl(sessions.without, sessions.with, tasha3);
  const result::Document found = swirl_answer(sessions, swirl, {});
  const std::string text = result::text(found);
  EXPECT_NE(text.find("\nSwirl: -2.000 \u00b1"), std::string::npos) << text;
  EXPECT_NE(text.find("alpha 19.4 m2 and beta 9.6 m"), std::string::npos) << text;
  EXPECT_NE(text.find("clockwise"), std::string::npos);
  const json::Value json = json::parse(result::json(found));
  EXPECT_NEAR(json["swirl_deg"].number(), -2.0, 1e-6);
  EXPECT_NEAR(json["without"]["set_points"][0]["offset_deg"].number(), -6.1, 1e-6);
  EXPECT_NEAR(json["without"]["set_points"][0]["roll_rate_deg_s"].number(), -66.41, 0.005);
  EXPECT_NE(json["alpha_and_beta"].text().find("Tasha III"), std::string::npos);
  EXPECT_NE(text.find(json["alpha_and_beta"].text()), std::string::npos) << text;
  EXPECT_EQ(json["differences"].size(), 2U);
}

}  // namespace
}  // namespace fantail::tunnel
