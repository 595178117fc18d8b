// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "identify/doubts.hpp"
#include "identify/planted_log.hpp"
#include "identify/study.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

constexpr double clock_begin_s = 2.0;  // of planted_log()
constexpr double length_s = 4.0;

Question exactly() {
  Question question = planted_question("0");
  question.options.with_error_map = false;
  return question;
}

std::string said(const Study& found) {
  std::string all;
  for (const std::vector<std::string>* sentences : {&found.warnings, &found.windows[0].remarks}) {
    for (const std::string& sentence : *sentences) {
      all += sentence + "\n";
    }
  }
  return all;
}

// A third of the propellant's share of the inertia has burnt where a third of the impulse has been given.
TEST(RollInertiaCourse, FollowsTheImpulseOfTheMotor) {
  sim::Vehicle vehicle;
  vehicle.mass_kg = 4.0;
  vehicle.roll_plant.inertia_kg_m2 = 0.004;
  vehicle.motor = sim::ThrustCurve{{{0.0, 300.0}, {2.0, 0.0}}, 0.5};  // impulse 300 t - 75 t^2 of 300 N s
  EXPECT_TRUE(sim::roll_inertia_course(vehicle).empty());
  vehicle.airframe = sim::Airframe{};
  EXPECT_TRUE(sim::roll_inertia_course(vehicle).empty());
  vehicle.airframe->roll_inertia_after_burnout_kg_m2 = 0.003;
  const sim::RollInertiaCourse course = sim::roll_inertia_course(vehicle);
  for (const double time_s : {-1.0, 0.0, 0.37, 1.0, 1.71, 2.0, 9.0}) {
    const double burning_s = std::min(2.0, std::max(0.0, time_s));
    EXPECT_NEAR(sim::roll_inertia_kg_m2(course, time_s), 0.004 - 0.001 * (burning_s - 0.25 * burning_s * burning_s),
                1e-6)
        << time_s;
  }
}

// Only density over inertia shows in a motion: with both larger by the same course, alpha and beta are those planted.
TEST(RollInertia, ThatChangesWithinAWindowIsCountedWith) {
  logs::RollLog log = planted_log({});
  Question question = exactly();
  question.record.density_kg_m3.reset();
  question.record.atmosphere.model = sim::DensityModel::exponential;
  for (const double time_s : log.time_s) {
    const double times = 1.3 - 0.1 * (time_s - clock_begin_s);
    log.height_m.push_back(-8500.0 * std::log(1.2 * times / 1.225));
  }
  question.record.roll_inertia = {{clock_begin_s, 1.3 * tasha.inertia_kg_m2},
                                  {clock_begin_s + length_s, 0.9 * tasha.inertia_kg_m2}};
  const Study found = study(log, question);
  EXPECT_NEAR(found.windows[0].results[0].model.alpha_m2, 20.0, 0.01);
  EXPECT_NEAR(found.windows[0].results[0].model.beta_m, 9.0, 0.005);
  EXPECT_EQ(figures(said(found)), (Numbers{"0.005109", "0.003537"})) << said(found);
}

// The motor burns for 1 s and is out at 1.5 s of the log, before the window.
TEST(RollInertia, AfterBurnOutIsUsedInAWindowAfterBurnOut) {
  logs::RollLog log = planted_log({});
  Question question = exactly();
  question.airframe.inertia_kg_m2 = 2.0 * tasha.inertia_kg_m2;
  question.inertia_since_ignition = {{0.0, 2.0 * tasha.inertia_kg_m2}, {1.0, tasha.inertia_kg_m2}};
  log.burnout_s = 1.5;
  const Study found = study(log, question);
  EXPECT_NEAR(found.windows[0].results[0].model.alpha_m2, 20.0, 0.01);
  EXPECT_EQ(figures(said(found)), Numbers{"0.00393"}) << said(found);
  EXPECT_NE(said(found).find("burn-out"), std::string::npos) << said(found);
}

TEST(RollInertia, AtLiftOffIsUsedWithAWordWhereTheLogShowsNoBurnOut) {
  Question question = exactly();
  question.inertia_since_ignition = {{0.0, tasha.inertia_kg_m2}, {1.0, 0.5 * tasha.inertia_kg_m2}};
  const Study found = study(planted_log({}), question);
  EXPECT_NEAR(found.windows[0].results[0].model.alpha_m2, 20.0, 0.01);
  EXPECT_EQ(figures(said(found)), (Numbers{"0.00393", "0.001965", "0.500"})) << said(found);
  EXPECT_NE(said(found).find("--inertia"), std::string::npos) << said(found);
}

// At sea level sound has 340.29 m/s: 68.06 to 163.3 m/s are Mach 0.2 to 0.48, whose factors are 1.0206 and 1.1399.
TEST(Mach, GrowthOfAlphaAndBetaInASimulationIsSaid) {
  const logs::RollLog log = planted_log({.speed_begin_m_s = 68.06, .speed_end_m_s = 163.34});
  Question question = exactly();
  EXPECT_EQ(figures(said(study(log, question))), (Numbers{"0.20", "0.48", "2.1", "14.0"}));
  question.grows_with_mach = true;
  EXPECT_EQ(figures(said(study(log, question))), (Numbers{"0.20", "0.48", "2.1", "14.0"}));
  question.grows_with_mach = false;
  EXPECT_EQ(said(study(log, question)), "");
}

// The planted roll as a rocket makes it whose alpha and beta at low speed are smaller by its factor at Mach
// 0.4, 1.0911.
TEST(Mach, GrowthThatIsKnownIsTakenFromTheResult) {
  const logs::RollLog log = planted_log({.speed_begin_m_s = 136.12, .speed_end_m_s = 136.12});
  Question question = exactly();
  question.grows_with_mach = true;
  const Study found = study(log, question);
  EXPECT_NEAR(found.windows[0].results[0].model.alpha_m2, 20.0 * std::sqrt(1.0 - 0.16), 0.01);
  EXPECT_NEAR(found.windows[0].results[0].model.beta_m, 9.0 * std::sqrt(1.0 - 0.16), 0.005);
  question.grows_with_mach = false;
  EXPECT_NEAR(study(log, question).windows[0].results[0].model.beta_m, 9.0, 0.005);
}

TEST(Mach, IsWorthNoWordInSlowAir) {
  Question question = exactly();
  for (const std::optional<bool> grows : {std::optional<bool>{}, std::optional{true}}) {
    question.grows_with_mach = grows;
    EXPECT_EQ(said(study(planted_log({.speed_begin_m_s = 22.0, .speed_end_m_s = 22.0}), question)), "");
  }
}

}  // namespace
}  // namespace fantail::identify
