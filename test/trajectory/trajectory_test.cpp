// SPDX-License-Identifier: MIT
#include "trajectory/trajectory.hpp"

#include <cmath>
#include <functional>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "input/scenario_file.hpp"
#include "logs/refused.hpp"

namespace fantail::trajectory {
namespace {

using test::expect_refused;
using text::ErrorKind;

constexpr double degree_rad = 3.14159265358979323846 / 180.0;

const sim::Scenario& scenario() {
  static const sim::Scenario loaded = input::load_scenario("tasha3_launch2", {});
  return loaded;
}

Trajectory parse(const std::string& text) { return parse_trajectory(text, "flight.csv", scenario()); }

/// A second of 60 m/s2 along an axis that leans, then 10 m/s2 backwards until the rocket stands still at 7 s, and back.
struct Throw {
  double tilt_rad = 0.0;
  [[nodiscard]] static double speed_m_s(double t) { return t < 0.0 ? 0.0 : t < 1.0 ? 60.0 * t : 70.0 - 10.0 * t; }
  [[nodiscard]] static double way_m(double t) {
    return t < 0.0 ? 0.0 : t < 1.0 ? 30.0 * t * t : 30.0 + 70.0 * (t - 1.0) - 5.0 * (t * t - 1.0);
  }
  [[nodiscard]] double up_m_s(double t) const { return speed_m_s(t) * std::cos(tilt_rad); }
  [[nodiscard]] double height_m(double t) const { return way_m(t) * std::cos(tilt_rad); }
};

using Cells = std::function<std::string(double time_s)>;

std::string rows(const std::string& header, const Cells& cells, double step_s = 0.01, double end_s = 9.0) {
  std::string text = header + "\n";
  for (int i = -10; step_s * i <= end_s; ++i) {
    text += fmt::format("{:.6f},{}\n", step_s * i, cells(step_s * i));
  }
  return text;
}

const Throw upright{};
const std::string heights_and_speeds = "# Time (s),Altitude (m),Vertical velocity (m/s)";
std::string height_and_speed(double t) { return fmt::format("{:.6f},{:.6f}", upright.height_m(t), upright.up_m_s(t)); }

const sim::PathSample& at(const Trajectory& trajectory, double time_s) {
  for (const sim::PathSample& sample : trajectory.path.samples) {
    if (sample.time_s >= time_s - 1e-9) {
      return sample;
    }
  }
  return trajectory.path.samples.back();
}

// Against the wind the speed over ground that RASAero writes is negative.
TEST(Trajectory, OfRasaeroHasItsHorizontalSpeedWithoutItsSign) {
  const Trajectory found = parse(rows("Time (sec),Altitude (ft),Vel-V (ft/sec),Vel-H (ft/sec)", [](double t) {
    return fmt::format("{:.6f},{:.6f},{:.6f}", upright.height_m(t) / 0.3048, upright.up_m_s(t) / 0.3048,
                       t < 0.0 ? 0.0 : -3.0 * t / 0.3048);
  }));
  EXPECT_NEAR(at(found, 2.0).across_m_s, 6.0, 0.05);
  EXPECT_NEAR(at(found, 2.0).up_m_s, upright.up_m_s(2.0), 0.1);
}

TEST(Trajectory, HasTheEventsOfTheFlight) {
  const Trajectory read = parse(rows(heights_and_speeds, height_and_speed));
  EXPECT_NEAR(read.path.liftoff_s, 0.0, 1e-9);
  EXPECT_NEAR(read.path.burnout_s.value(), 1.0, 0.021);
  EXPECT_NEAR(read.path.apogee_s.value(), 7.0, 0.011);
}

TEST(Trajectory, KnowsNoBurnOutWhereTheMotorPushesToTheEndOfTheFile) {
  EXPECT_FALSE(parse(rows(heights_and_speeds, height_and_speed, 0.01, 0.8)).path.burnout_s);
  EXPECT_NEAR(parse(rows(heights_and_speeds, height_and_speed, 0.01, 1.5)).path.burnout_s.value(), 1.0, 0.021);
}

// Highest at 7 s, and the file says that the motor pushes until 8 s: the rocket turned over.
TEST(Trajectory, KnowsABurnOutBehindTheHighestRow) {
  const auto pushed_until = [](double end_s) {
    return parse(rows(heights_and_speeds + ",Axial Acceleration (m/s2)",
                      [end_s](double t) {
                        return fmt::format("{},{}", height_and_speed(t), t >= 0.0 && t < end_s ? 20.0 : -12.0);
                      }))
        .path;
  };
  const auto turned_over = pushed_until(8.0);
  EXPECT_NEAR(turned_over.apogee_s.value(), 7.0, 0.011);
  EXPECT_NEAR(turned_over.burnout_s.value(), 8.0, 0.021);
  EXPECT_FALSE(pushed_until(20.0).burnout_s);
  EXPECT_NEAR(pushed_until(1.0).burnout_s.value(), 1.0, 0.021);
}

TEST(Trajectory, WithHeightAndVerticalSpeedAloneGoesAlongTheGuideInTheScenariosAir) {
  sim::Scenario leaning = scenario();
  leaning.guide.tilt_rad = 10.0 * degree_rad;
  const Trajectory read = parse_trajectory(rows(heights_and_speeds, height_and_speed), "flight.csv", leaning);
  const sim::PathSample& sample = at(read, 3.0);
  EXPECT_NEAR(sample.height_m, 30.0 + 140.0 - 40.0, 1e-6);
  EXPECT_NEAR(sample.up_m_s, 40.0, 1e-6);
  EXPECT_NEAR(sample.along_axis_m_s, 40.0 / std::cos(10.0 * degree_rad), 1e-6);
  EXPECT_NEAR(sample.tilt_rad, 10.0 * degree_rad, 1e-12);
  EXPECT_NEAR(sample.density_kg_m3, 1.225 * std::exp(-130.0 / 8500.0), 1e-9);
  ASSERT_FALSE(read.notes.empty());
  EXPECT_NE(read.notes[0].find("flight.csv"), std::string::npos) << read.notes[0];
  EXPECT_NE(read.notes[0].find("along the scenario's guide"), std::string::npos) << read.notes[0];
  EXPECT_NE(read.notes[0].find("air density is that of the scenario"), std::string::npos) << read.notes[0];
}

TEST(Trajectory, TheTiltIsCountedFromTheHorizonByBothPrograms) {
  const Throw leaning{.tilt_rad = 20.0 * degree_rad};
  for (const char* column : {"Vertical orientation (zenith) (\u00b0)", "Attitude Angle (\u00b0)"}) {
    const Trajectory read =
        parse(rows("# Time (s),Altitude (m),Total velocity (m/s)," + std::string{column}, [&](double t) {
          return fmt::format("{:.6f},{:.6f},70", leaning.height_m(t), std::abs(Throw::speed_m_s(t)));
        }));
    EXPECT_NEAR(at(read, 3.0).tilt_rad, 20.0 * degree_rad, 1e-9);
    EXPECT_NEAR(at(read, 3.0).up_m_s, leaning.up_m_s(3.0), 1e-5);
    EXPECT_NEAR(at(read, 3.0).across_m_s, 40.0 * std::sin(20.0 * degree_rad), 1e-5);
  }
}

TEST(Trajectory, WithoutTiltButWithTwoSpeedsLeansAsItsPathDoes) {
  const Throw leaning{.tilt_rad = 12.0 * degree_rad};
  const auto flat = [](double t) { return std::abs(Throw::speed_m_s(t)) * std::sin(12.0 * degree_rad); };
  const Trajectory lateral =
      parse(rows("# Time (s),Altitude (m),Vertical velocity (m/s),Lateral velocity (m/s)", [&](double t) {
        return fmt::format("{:.6f},{:.6f},{:.6f}", leaning.height_m(t), leaning.up_m_s(t), flat(t));
      }));
  EXPECT_NEAR(at(lateral, 3.0).tilt_rad, 12.0 * degree_rad, 1e-6);
  EXPECT_NEAR(at(lateral, -0.05).tilt_rad, 12.0 * degree_rad, 1e-4);  // as it stood
  // Three decimals, as OpenRocket writes: the difference of two speeds says less.
  const Trajectory total =
      parse(rows("# Time (s),Altitude (m),Vertical velocity (m/s),Total velocity (m/s)", [&](double t) {
        return fmt::format("{:.3f},{:.3f},{:.3f}", leaning.height_m(t), leaning.up_m_s(t),
                           std::abs(Throw::speed_m_s(t)));
      }));
  EXPECT_NEAR(at(total, 3.0).tilt_rad, 12.0 * degree_rad, 0.1 * degree_rad);
}

TEST(Trajectory, UnitsAreThoseOfTheHeader) {
  const Trajectory read = parse(rows(
      "# Time (min),Altitude (ft),Vertical velocity (km/h),Vertical orientation (zenith) (rad),Air temperature "
      "(\u00b0F),Air pressure (mbar)",
      [](double t) {
        return fmt::format("{:.8f},{:.8f},1.5707963268,59,1013.25", upright.height_m(60.0 * t) / 0.3048,
                           upright.up_m_s(60.0 * t) * 3.6);
      },
      0.01 / 60.0, 9.0 / 60.0));
  EXPECT_NEAR(at(read, 3.0).height_m, 130.0, 1e-2);
  EXPECT_NEAR(at(read, 3.0).up_m_s, 40.0, 1e-2);
  EXPECT_NEAR(at(read, 3.0).tilt_rad, 0.0, 1e-9);
  EXPECT_NEAR(at(read, 3.0).density_kg_m3, 1.225, 1e-4);  // 15 degrees Celsius at the pressure of the sea
}

TEST(Trajectory, SuperscriptsAndDegreesMayBeOfAnOlderAlphabet) {
  const Trajectory read = parse(rows(
      "# Time (s),Altitude (m),Vertical velocity (m/s),Air density (kg/m\xB3),Vertical orientation (zenith) (\xB0)",
      [](double t) { return height_and_speed(t) + ",1.100,90"; }));
  EXPECT_NEAR(at(read, 3.0).density_kg_m3, 1.1, 1e-12);
}

TEST(Trajectory, HeightAboveTheSeaCountsFromTheFirstRow) {
  const Trajectory read = parse(rows("# Time (s), Z (m), Vz (m/s)", [](double t) {
    return fmt::format("{:.6f},{:.6f}", 1400.0 + upright.height_m(t), upright.up_m_s(t));
  }));
  EXPECT_NEAR(at(read, 3.0).height_m, 130.0, 1e-5);
}

// 0.001 g/cm3 for air: OpenRocket's own unit with its own three decimals.
TEST(Trajectory, ADensityThatIsRoundedTooFarIsNotUsed) {
  const Trajectory read = parse(
      rows(heights_and_speeds + ",Air density (g/cm\u00b3)", [](double t) { return height_and_speed(t) + ",0.001"; }));
  EXPECT_NEAR(at(read, 3.0).density_kg_m3, 1.225 * std::exp(-130.0 / 8500.0), 1e-9);
  EXPECT_NE(read.notes[0].find("rounded"), std::string::npos) << read.notes[0];
}

TEST(Trajectory, AnAccelerationAlongTheAxisIsFeltWithGravityTakenOff) {
  const Trajectory read =
      parse(rows("# Time (s), Altitude AGL (m), Vz (m/s), Axial Acceleration (m/s\u00b2)", [](double t) {
        return height_and_speed(t) + (t < 0.0 ? ",0" : t < 1.0 ? ",60" : ",-10");
      }));
  EXPECT_NEAR(at(read, 0.5).axial_specific_force_m_s2.value(), 69.80665, 1e-9);
  EXPECT_NEAR(at(read, 2.0).axial_specific_force_m_s2.value(), -0.19335, 1e-9);
  EXPECT_NEAR(at(read, -0.05).axial_specific_force_m_s2.value(), 9.80665, 1e-9);
}

TEST(Trajectory, AirSpeedAndAngleOfAttackTellTheFlowAlongTheAxis) {
  const Trajectory read =
      parse(rows("# Time (s), Altitude AGL (m), Vz (m/s), Freestream Speed (m/s), Angle of Attack (\u00b0)",
                 [](double t) { return height_and_speed(t) + ",50,60"; }));
  EXPECT_NEAR(at(read, 3.0).along_axis_m_s, 25.0, 1e-9);
}

TEST(Trajectory, RowsOfTheSameTimeCountOnceAndCellsWithoutANumberAreFilled) {
  const Trajectory read = parse(rows(heights_and_speeds + ",Air density (kg/m3)", [](double t) {
    const std::string cells = height_and_speed(t) + (std::abs(t - 3.0) < 1e-9 ? ",NaN" : ",1.100");
    return std::abs(t - 4.0) < 1e-9 ? cells + fmt::format("\n{:.6f},", t) + cells : cells;
  }));
  EXPECT_NEAR(at(read, 3.0).density_kg_m3, 1.1, 1e-12);
  ASSERT_EQ(read.notes.size(), 3U);
  EXPECT_NE(read.notes[1].find("1 of 912 rows have the time of the row before"), std::string::npos) << read.notes[1];
  EXPECT_NE(read.notes[2].find("1 of 911 cells of Air density"), std::string::npos) << read.notes[2];
}

TEST(Trajectory, AFileThatEndsBeforeApogeeSaysSo) {
  const Trajectory read = parse(rows(heights_and_speeds, height_and_speed, 0.01, 5.0));
  EXPECT_FALSE(read.path.apogee_s);
  // At 6.9 s the rocket climbs with 1 m/s.
  EXPECT_FALSE(parse(rows(heights_and_speeds, height_and_speed, 0.01, 6.85)).path.apogee_s);
  EXPECT_NEAR(parse(rows(heights_and_speeds, height_and_speed, 0.01, 6.95)).path.apogee_s.value(), 6.95, 0.011);
}

TEST(Trajectory, HeightsCountFromLiftOff) {
  const auto on = [](double pad_m) {
    return rows(heights_and_speeds, [pad_m](double t) {
      return fmt::format("{:.6f},{:.6f}", pad_m + upright.height_m(t), upright.up_m_s(t));
    });
  };
  const Trajectory tower = parse(on(12.0));
  EXPECT_NEAR(at(tower, 3.0).height_m, 130.0, 1e-6);
  EXPECT_EQ(tower.notes.at(1), "Altitude is 12 m at lift-off; heights count from there.");
  EXPECT_NEAR(at(parse(on(-49.0)), 3.0).height_m, 130.0, 1e-6);
  EXPECT_EQ(parse(on(0.4)).notes.size(), 1U);
  for (const double above_sea_m : {1500.0, 50.1, -51.0}) {
    expect_refused(ErrorKind::bad_data,
                   {"flight.csv:12", "Altitude", fmt::format("\"{:.6f}\"", above_sea_m).c_str(), "allowed: -50 to 50 m",
                    "Altitude above sea level"},
                   [&] { (void)parse(on(above_sea_m)); });
  }
}

TEST(Trajectory, ColumnsThatAreNotUsedAreNamed) {
  const Trajectory few =
      parse(rows(heights_and_speeds + ",Mass (g),Air pressure (mbar),\"Total velocity (m/s)\"", [](double t) {
        return height_and_speed(t) + fmt::format(",4000,1013,{:.6f}", std::abs(Throw::speed_m_s(t)));
      }));
  // Pressure alone makes no density; two speeds make a third.
  EXPECT_EQ(few.notes.at(1), "Columns of the file that are not used: \"Mass (g)\", \"Air pressure (mbar)\".");
  std::string header = heights_and_speeds;
  std::string cells;
  for (int i = 1; i <= 9; ++i) {
    header += fmt::format(",X{}", i);
    cells += ",1";
  }
  const Trajectory many = parse(rows(header, [&](double t) { return height_and_speed(t) + cells; }));
  EXPECT_EQ(many.notes.at(1),
            R"(Columns of the file that are not used: "X1", "X2", "X3", "X4", "X5", "X6" and 3 more columns.)");
}

TEST(Trajectory, HeightsThatDoNotFitTheSpeedsAreRemarkedOn) {
  const Trajectory read = parse(rows("# Time (s),Altitude (ft),Vertical velocity (m/s)", height_and_speed));
  EXPECT_NE(read.notes.at(1).find("do not agree"), std::string::npos) << read.notes.at(1);
}

TEST(Trajectory, WhatIsNoFlightIsRefusedWithFileLineAndColumn) {
  const auto refused = [](const std::string& text, std::initializer_list<const char*> expected) {
    expect_refused(ErrorKind::bad_data, expected, [&] { (void)parse(text); });
  };
  const auto with = [](const std::string& header) { return rows(header, height_and_speed); };
  refused(with("# Time (s),Altitude (m),Mass (g)"),
          {"flight.csv:1", "no column for the speed", "Total velocity", "\"Mass (g)\""});
  refused(with("# Time (s),Height (m),Vz (m/s)"), {"flight.csv:1", "no column for the height", "Altitude AGL"});
  refused(with("# Time (s),Altitude (furlong),Vz (m/s)"),
          {"flight.csv:1", "Altitude (furlong)", "not known", "ft", "nmi"});
  refused(with("# Time (s),Altitude,Vz (m/s)"), {"flight.csv:1", "Altitude", "no unit"});
  refused(rows(heights_and_speeds, [](double t) { return t > 2.0 && t < 3.0 ? "NaN,1" : height_and_speed(t); }),
          {"flight.csv", "99 of 911 rows", "line 213", "Altitude", "\"NaN\"", "1 %"});
  refused(rows(heights_and_speeds, height_and_speed, 0.2), {"flight.csv:13", "0.2 s", "0.1 s", "time_step"});
  refused(rows(heights_and_speeds, [](double) { return "0,0"; }), {"flight.csv", "never moves"});
  refused(rows(heights_and_speeds, [](double t) { return fmt::format("{},{}", 100.0 + 50.0 * t, 50.0); }),
          {"flight.csv:2", "50 m/s", "at rest"});
  refused("# Time (s),Altitude (m),Vz (m/s)\n0,0,0\n0.1,1,1\n0.05,2,2\n",
          {"flight.csv:4", "0.05", "0.1", "line 3", "increase"});
  refused("# Time (s),Altitude (m),Vz (m/s)\n", {"flight.csv", "no rows"});
  refused(rows(heights_and_speeds + ",Air density (kg/m3)", [](double t) { return height_and_speed(t) + ",1225"; }),
          {"flight.csv:2", "Air density", "\"1225\"", "allowed: 0.0001 to 5"});
  refused(rows(heights_and_speeds + ",Air density (kg/m3)",
               [](double t) { return height_and_speed(t) + (t > 2.0 && t < 3.0 ? "," : ",1.100"); }),
          {"flight.csv:213", "Air density", "line 312", "0.1 s"});
}

TEST(Trajectory, IsNoMatterForATunnel) {
  const sim::Scenario tunnel = input::load_scenario("tunnel_steps", {});
  expect_refused(ErrorKind::bad_configuration, {"tunnel_steps", "surroundings", "tunnel"},
                 [&] { (void)parse_trajectory(rows(heights_and_speeds, height_and_speed), "flight.csv", tunnel); });
}

}  // namespace
}  // namespace fantail::trajectory
