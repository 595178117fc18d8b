// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>

#include "brief/sentences.hpp"
#include "briefs.hpp"
#include "fly/fly_scenario.hpp"
#include "hardover/study.hpp"
#include "test.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"

namespace fantail::brief {
namespace {

// A reaches from 1.26 to 2.5 N s, and each letter to twice as much.
TEST(MotorClass, DoublesWithEachLetter) {
  EXPECT_EQ(motor_class(1.25), "below A");
  EXPECT_EQ(motor_class(1.26), "A");
  EXPECT_EQ(motor_class(2.5), "A");
  for (int n = 0; n < 26; ++n) {
    const std::string letter{static_cast<char>('A' + n)};
    EXPECT_EQ(motor_class(std::ldexp(2.5, n)), letter);
    EXPECT_EQ(motor_class(std::ldexp(2.5, n) * 0.51), letter);
  }
  EXPECT_EQ(motor_class(640.0), "I");
  EXPECT_EQ(motor_class(640.1), "J");
  EXPECT_EQ(motor_class(std::ldexp(2.51, 25)), "beyond Z");
}

TEST(Brief, TellsWhenTheGateOpensAsTheFlightHasIt) {
  const std::vector<std::string> changes{"dormancy.until=max_dynamic_pressure", "flight.motion=six_dof"};
  const flight::Flight flown = fly::fly_scenario(scenario(changes));
  const NominalFlight nominal = fly_nominal(scenario(changes));
  const double start_s = flown.events.control_start_s.value();
  EXPECT_NEAR(nominal.control_start.value().time_s, start_s, 1e-9);
  const flight::PathPoint* const at = flight::point_at(flown.path, start_s);
  ASSERT_NE(at, nullptr);
  EXPECT_NEAR(nominal.control_start->height_m, at->height_m, 1.0) << "a hundredth of a second at 82 m/s";
  EXPECT_NEAR(nominal.control_start->speed_m_s, std::hypot(at->north_m_s, at->east_m_s, at->up_m_s), 0.3);
  EXPECT_EQ(nominal.burns_at_control_start, start_s < flown.events.burnout_s.value());
  EXPECT_TRUE(nominal.was_dormant);
}

TEST(Brief, SaysThatAGateIsNeverReachedAndComputesNoWindLimitThen) {
  const Brief brief = brief_of({"dormancy.until=height", "dormancy.height_m=1500"});
  EXPECT_FALSE(brief.nominal.control_start);
  EXPECT_FALSE(brief.wind_limit);
  const std::string text = text_of(brief);
  EXPECT_NE(text.find("Simulated: the gate never opens, and the canards are commanded to trim throughout."),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("No limit is computed: control does not begin."), std::string::npos) << text;
}

TEST(Brief, TheWindLimitIsTheLastWindBeforeAFlightLeavesTheModelOrReachesTheTiltLimit) {
  const WindLimit limit = wind_limit(scenario({"flight.motion=six_dof"}), [] {});
  ASSERT_TRUE(limit.passed_m_s);
  const auto largest_attack_deg = [](double wind_m_s) {
    double largest_rad = 0.0;
    for (const double from_deg : {0.0, 90.0, 180.0, 270.0}) {
      sim::Scenario windy = scenario({"flight.motion=six_dof"});
      windy.wind.speed_m_s = wind_m_s;
      windy.wind.from_rad = text::radians(from_deg);
      largest_rad = std::max(largest_rad, fly::fly_scenario(windy).extremes.angle_of_attack_rad.value());
    }
    return text::degrees(largest_rad);
  };
  EXPECT_LE(largest_attack_deg(*limit.passed_m_s), 15.0);
  EXPECT_GT(largest_attack_deg(*limit.passed_m_s + wind_step_m_s), 15.0);
}

// With the canards at trim until burn-out it stands in more wind than the roll model allows as it leaves the guide.
TEST(Brief, TheWindLimitSaysWhatItDoesNotJudgeAtTheEndOfTheGuide) {
  Brief brief{.is_six_dof = true};
  brief.wind_limit =
      wind_limit(scenario({"flight.motion=six_dof", "dormancy.until=burn_out", "dormancy.burn_time_s=3.2"}), [] {});
  ASSERT_TRUE(brief.wind_limit->passed_m_s);
  const double speed_m_s = fly_nominal(scenario({"flight.motion=six_dof"})).guide_exit.speed_m_s;
  const double by_hand_rad = std::atan2(*brief.wind_limit->passed_m_s, speed_m_s);  // across the guide
  EXPECT_GT(text::degrees(by_hand_rad), 15.0);
  EXPECT_NEAR(brief.wind_limit->exit_attack_rad, by_hand_rad, 0.2 * by_hand_rad);
  const std::vector<std::string> said = wind_sentences(brief);
  EXPECT_NE(said.at(0).find("m/s control stays within the roll model."), std::string::npos) << said[0];
  EXPECT_NE(said.at(1).find("Not judged: the end of the guide, where the angle of attack then reaches "),
            std::string::npos)
      << said[1];
}

TEST(Brief, AWindFailsByTheTiltLimitWhereTheFlightReportCallsItAnEarlyEnd) {
  const std::vector<std::string> from_guide{"flight.motion=six_dof", "launch_guide.tilt_deg=6",
                                            "run.tilt_limit_deg=20"};
  const WindLimit strict = wind_limit(scenario(from_guide), [] {});
  EXPECT_FALSE(strict.passed_m_s);
  EXPECT_EQ(strict.first_failure, "the tilt limit ends control more than 0.5 s before apogee");
  std::vector<std::string> allowed = from_guide;
  allowed.emplace_back("verdict.tilt_end_before_apogee_s=10");
  const WindLimit later = wind_limit(scenario(allowed), [] {});
  EXPECT_TRUE(later.passed_m_s) << later.first_failure;
}

// In wind the healthy rocket falls from apogee as a stone without air: h = g t^2 / 2, carried by its own speed alone.
TEST(Brief, AFallWithoutParachuteIsThatOfAStoneWithoutAir) {
  const Brief brief = brief_of({"wind.speed_m_s=4"});
  const flight::Flight flown = fly::fly_scenario(scenario({"wind.speed_m_s=4", "flight.motion=six_dof"}));
  const flight::PathPoint top = *std::ranges::max_element(flown.path, {}, &flight::PathPoint::height_m);
  const double falls_s = std::sqrt(2.0 * top.height_m / 9.80665);
  EXPECT_NEAR(brief.landing.value().healthy_fall_m,
              std::hypot(top.north_m + falls_s * top.north_m_s, top.east_m + falls_s * top.east_m_s), 2.0);
  EXPECT_GT(brief.landing->failed_fall_m, brief.landing->healthy_fall_m);
  EXPECT_FALSE(brief.landing->healthy_m);
  EXPECT_NE(text_of(brief).find("not computed, the vehicle has no section [recovery]"), std::string::npos);
}

TEST(Brief, TheCircleOfAFailedCanardReachesToTheFarthestLandingUnderTheParachute) {
  const std::vector<std::string> changes{"wind.speed_m_s=3", "recovery.drag_area_m2=0.8"};
  const Landing landing = brief_of(changes).landing.value();
  const hardover::Study study = hardover::fly(scenario(changes), {.step_s = 5.0, .threads = 2}, [](auto, auto) {});
  double farthest_m = 0.0;
  for (const hardover::Effect& effect : study.effects) {
    farthest_m = std::max(farthest_m, effect.landing_from_guide_m.value());
  }
  EXPECT_EQ(landing.failed_m, farthest_m);
  EXPECT_EQ(landing.flights, study.effects.size());
  EXPECT_NEAR(text::degrees(landing.healthy_bearing_rad.value()), 180.0, 10.0) << "the wind comes from the north";
}

TEST(Brief, AVehicleWithoutAirframeHasNoLandingAndNoWindLimit) {
  const Brief brief = make({.scenario = scenario({}, "bench_healthy")}, [](std::size_t, std::size_t) {});
  EXPECT_FALSE(brief.landing);
  EXPECT_FALSE(brief.wind_limit);
  const std::string text = text_of(brief);
  EXPECT_NE(text.find("Where it comes down is not computed."), std::string::npos) << text;
  EXPECT_NE(text.find("No limit is computed: the vehicle has no section [airframe]."), std::string::npos) << text;
}

TEST(Brief, RefusesAScenarioThatLaunchesNothingByItsName) {
  for (const char* const name : {"tunnel_steps", "gimbal"}) {
    try {
      (void)make({.scenario = scenario({}, name)}, [](std::size_t, std::size_t) {});
      ADD_FAILURE() << name;
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), text::ErrorKind::bad_configuration);
      EXPECT_NE(std::string{error.what()}.find(name), std::string::npos) << error.what();
    }
  }
}

TEST(Brief, FaultsOfTheScenarioAreSaid) {
  sim::Scenario broken = scenario({});
  broken.faults.push_back({.device = sim::Device::servo, .how = sim::Behaviour::cut, .from_s = 1.0, .until_s = 1.02});
  const Brief brief =
      make({.scenario = broken, .step_s = 10.0, .threads = 2, .rules = {}}, [](std::size_t, std::size_t) {});
  EXPECT_NE(text_of(brief).find("Every flight here has the 1 fault of the scenario."), std::string::npos);
}

}  // namespace
}  // namespace fantail::brief
