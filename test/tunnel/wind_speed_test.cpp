// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "system/folder.hpp"
#include "tunnel/made_logs.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {
namespace {

using test::Folder;

const std::string wind_rows = "time_s,fan_rpm,wind_speed_m_s\n0,1250,22.0\n2,1250,22.2\n4,1250,22.1\n";

// One step of the reference at 1 s, six seconds long; the log's own speed as given.
logs::RollLog roll_log(double speed_m_s) {
  logs::RollLog log;
  log.name = "run.csv";
  for (int i = 0; i <= 60; ++i) {
    log.time_s.push_back(0.1 * i);
    log.roll_rate_rad_s.push_back(0.0);
    log.reference_rad.push_back(i < 10 ? 0.0 : 45.0 * degree);
    log.speed_m_s.push_back(speed_m_s);
  }
  return log;
}

TEST(WindOf, TheNamedLogComesFirstThenTheOneBesideThenTheRollLogItself) {
  const Folder folder;
  const std::string named = folder.write("other/named.csv", "time_s,fan_rpm,wind_speed_m_s\n0,900,15\n2,900,15\n");
  const std::string run = folder.write("run.csv", "");
  EXPECT_EQ(wind_of(roll_log(25.0), run, "", false).wind_speed_m_s[0], 25.0);
  EXPECT_TRUE(wind_of(roll_log(25.0), run, "", false).fan_rpm.empty());
  folder.write("tunnel.csv", wind_rows);
  EXPECT_EQ(wind_of(roll_log(25.0), run, "", false).wind_speed_m_s[0], 22.0);
  EXPECT_EQ(wind_of(roll_log(25.0), run, named, false).wind_speed_m_s[0], 15.0);
}

TEST(WindOf, TruthIsPreferredWhereItIsAskedForAndThere) {
  const Folder folder;
  folder.write("tunnel.csv", wind_rows);
  const std::string run = folder.write("run.csv", "");
  EXPECT_EQ(wind_of(roll_log(25.0), run, "", true).wind_speed_m_s[0], 25.0);
  EXPECT_EQ(wind_of(roll_log(0.0), run, "", true).wind_speed_m_s[0], 22.0);
}

// On board, the speed in a tunnel is zero or the drift of an integral.
TEST(WindOf, NobodyKnowingTheSpeedIsRefused) {
  const Folder folder;
  test::expect_refused(text::ErrorKind::bad_data, {"run.csv", "no wind speed", "tunnel.csv"},
                       [&] { (void)wind_of(roll_log(0.01), folder / "run.csv", "", false); });
  test::expect_refused(text::ErrorKind::bad_data, {"run.csv", "no wind speed", "--speed"},
                       [&] { (void)speed_of_steps(roll_log(0.01), folder / "run.csv", {}); });
}

TEST(SpeedOfSteps, IsByHandOrTheMeanWhileTheStepsLastedOrTheLogsOwn) {
  const Folder folder;
  const std::string run = folder.write("run.csv", "");
  EXPECT_EQ(speed_of_steps(roll_log(25.0), run, {}).speed_m_s, std::nullopt);
  EXPECT_EQ(speed_of_steps(roll_log(25.0), run, {.speed_m_s = 21.0}).speed_m_s, 21.0);
  folder.write("tunnel.csv", wind_rows);
  EXPECT_NEAR(*speed_of_steps(roll_log(25.0), run, {}).speed_m_s, 22.15, 1e-12);  // of 2 and 4 s
}

TEST(MeanWindSpeed, OfAFanThatChangesOrOutsideTheLogIsRefused) {
  const std::vector<ReferenceStep> steps{{.begin_s = 10.0, .end_s = 20.0}};
  const TunnelLog changing =
      made_tunnel_log(40.0, [](double t) { return t < 15.0 ? 1000.0 : 1250.0; }, [](double) { return 22.0; });
  test::expect_refused(text::ErrorKind::bad_data, {"made.csv", "1000 to 1250 rpm"},
                       [&] { (void)mean_wind_speed_m_s(changing, steps); });
  const TunnelLog early = made_tunnel_log(8.0, [](double) { return 1000.0; }, [](double) { return 22.0; });
  test::expect_refused(text::ErrorKind::bad_data, {"made.csv", "no wind speed between 10 and 20 s"},
                       [&] { (void)mean_wind_speed_m_s(early, steps); });
}

}  // namespace
}  // namespace fantail::tunnel
