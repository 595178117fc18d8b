// SPDX-License-Identifier: MIT
#include "identify/make_record.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "identify/flown_log.hpp"
#include "logs/refused.hpp"

namespace fantail::identify {
namespace {

using namespace model;

using test::cut_out;
using test::expect_refused;
using test::flown_log;
using text::ErrorKind;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Window seconds(double from_s, double to_s) { return {from_s, to_s, ""}; }

void expect_bad(const logs::RollLog& log, const Window& window, const RecordOptions& options,
                std::initializer_list<const char*> words) {
  expect_refused(ErrorKind::bad_data, words, [&] { (void)make_record(log, window, options); });
}

TEST(Record, HoldsTheWindowWithTimeFromItsBegin) {
  const Record record = make_record(flown_log(), seconds(2.0 - 1e-9, 3.5 + 1e-9), {});
  ASSERT_EQ(record.size(), 151U);
  EXPECT_EQ(record.time_s.front(), 0.0);
  EXPECT_NEAR(record.time_s.back(), 1.5, 1e-9);
  EXPECT_NEAR(record.window_begin_s, 2.0, 1e-9);
  EXPECT_EQ(record.window, "2:3.5");
  EXPECT_NEAR(record.roll_angle_rad[0], 1.0, 1e-9);
  EXPECT_EQ(record.roll_rate_rad_s[0], 0.5);
  EXPECT_NEAR(record.canard_rad[150], 0.035, 1e-9);
  EXPECT_NEAR(record.speed_m_s[0], 20.0, 1e-9);
  EXPECT_EQ(record.reference_rad[0], 0.0);
  EXPECT_EQ(record.reference_rad[150], 0.3);
  EXPECT_EQ(record.excitation_rad.size(), 151U);
  EXPECT_EQ(record.segment_begin, (std::vector<std::size_t>{0}));
}

// With another speed for the plant the law still went by its own.
TEST(Record, KeepsWhatTheLawKnewAndTookOff) {
  logs::RollLog log = flown_log();
  log.estimated_speed_m_s = log.speed_m_s;
  log.offset_estimate_rad = log.canard_rad;
  log.speed_bound_from_s = 3.0;
  const Record record = make_record(log, seconds(2.0 - 1e-9, 3.5 + 1e-9), {.speed_m_s = 22.0});
  EXPECT_EQ(record.speed_m_s[0], 22.0);
  ASSERT_EQ(record.law_speed_m_s.size(), 151U);
  EXPECT_NEAR(record.law_speed_m_s[0], 20.0, 1e-9);
  EXPECT_NEAR(record.law_speed_is_bound_s, 1.0, 1e-9);
  EXPECT_NEAR(record.offset_estimate_rad[150], 0.035, 1e-9);
  log.offset_estimate_rad[250] = std::nan("");
  EXPECT_TRUE(make_record(log, {}, {}).offset_estimate_rad.empty());
}

TEST(Record, OfAWholeLogHasEverySample) {
  const Record record = make_record(flown_log(), {}, {});
  EXPECT_EQ(record.size(), 1101U);
  EXPECT_EQ(record.window, ":");
  EXPECT_FALSE(record.in_control[0]);
  EXPECT_TRUE(record.in_control[205]);
  EXPECT_FALSE(record.in_control[1100]);
}

TEST(Record, WithoutPhasesIsUnderControl) {
  logs::RollLog log = flown_log();
  log.phase.clear();
  EXPECT_TRUE(make_record(log, {}, {}).in_control[0]);
}

TEST(Record, TakesTheCanardAngleLaterByTheLag) {
  // Canards turn by 0.01 rad/s, so a lag of 24 ms is 0.00024 rad, between two samples too.
  const Record late = make_record(flown_log(), seconds(2.0, 3.0), {.lag_s = 0.024});
  EXPECT_NEAR(late.canard_rad[0], 0.01 * (late.window_begin_s + 0.024), 1e-12);
  const Record early = make_record(flown_log(), seconds(2.0, 3.0), {.lag_s = -0.024});
  EXPECT_NEAR(early.canard_rad[0], 0.01 * (early.window_begin_s - 0.024), 1e-12);
}

TEST(Record, LeavesOutWhatTheLagMovesBeyondTheLog) {
  EXPECT_NEAR(make_record(flown_log(), {}, {.lag_s = 0.035}).time_s.back(), 9.96 + 1.0, 1e-9);
  EXPECT_NEAR(make_record(flown_log(), {}, {.lag_s = -0.035}).window_begin_s, -0.96, 1e-9);
}

TEST(Record, HasASegmentBehindEachGap) {
  logs::RollLog log = flown_log();
  cut_out(log, 2.005, 2.195);  // 0.2 s
  cut_out(log, 3.005, 3.045);  // 50 ms are no gap yet
  const Record record = make_record(log, seconds(1.0 - 1e-9, 4.0 + 1e-9), {});
  ASSERT_EQ(record.segment_begin, (std::vector<std::size_t>{0, 101}));
  EXPECT_NEAR(record.time_s[101], 1.2, 1e-9);
}

TEST(Record, OfASlowLogHasNoGapBetweenAnyTwoSamples) {
  logs::RollLog log;
  log.name = "slow.csv";
  for (int i = 0; i < 20; ++i) {
    log.time_s.push_back(i * 0.2);
    log.roll_angle_rad.push_back(0.0);
    log.roll_rate_rad_s.push_back(0.0);
    log.canard_rad.push_back(0.0);
  }
  const RecordOptions options{.density_kg_m3 = 1.2, .speed_m_s = 22.0};
  EXPECT_EQ(make_record(log, {}, options).segment_begin.size(), 1U);
}

TEST(Record, LeavesOutCrumbsBetweenGaps) {
  logs::RollLog log = flown_log();
  cut_out(log, 2.005, 2.295);
  cut_out(log, 2.315, 2.595);  // leaves 2.30 and 2.31 s
  const Record record = make_record(log, seconds(1.0 - 1e-9, 4.0 + 1e-9), {});
  ASSERT_EQ(record.segment_begin, (std::vector<std::size_t>{0, 101}));
  EXPECT_NEAR(record.time_s[101], 1.6, 1e-9);
}

TEST(Record, DoesNotInventCanardAnglesInsideAGap) {
  logs::RollLog log = flown_log();
  cut_out(log, 2.005, 2.195);
  const Record record = make_record(log, seconds(1.0 - 1e-9, 4.0 + 1e-9), {.lag_s = 0.015});
  ASSERT_EQ(record.segment_begin.size(), 2U);
  EXPECT_NEAR(record.time_s[record.segment_begin[1] - 1], 0.98, 1e-9);
}

TEST(Record, TakesTheDensityFromTheHeight) {
  const Record record = make_record(flown_log(), seconds(2.0, 3.0), {});
  const double height_m = 5.0 * record.window_begin_s * record.window_begin_s;
  EXPECT_NEAR(record.density_kg_m3[0], 1.225 * std::exp(-height_m / 8500.0), 1e-9);
  EXPECT_EQ(make_record(flown_log(), seconds(2.0, 3.0), {.density_kg_m3 = 1.1}).density_kg_m3[50], 1.1);
  const RecordOptions constant{.atmosphere = {.model = sim::DensityModel::constant, .constant_kg_m3 = 1.15}};
  EXPECT_EQ(make_record(flown_log(), seconds(2.0, 3.0), constant).density_kg_m3[50], 1.15);
  logs::RollLog log = flown_log();
  log.height_m.clear();
  expect_bad(log, {}, {}, {"flown.csv: no column height_m", "--density"});
}

TEST(Record, TakesAStatedSpeed) {
  const Record record = make_record(flown_log(), seconds(2.0, 3.0), {.speed_m_s = 22.0});
  EXPECT_EQ(record.speed_m_s.front(), 22.0);
  EXPECT_EQ(record.speed_m_s.back(), 22.0);
}

TEST(Record, WithoutASpeedIsRefused) {
  logs::RollLog log = flown_log();
  log.speed_m_s.assign(log.time_s.size(), 0.03);
  expect_bad(log, {}, {}, {"flown.csv: no speed", "never above 0.03 m/s", "--speed", "--truth"});
  log.speed_m_s.clear();
  expect_bad(log, {}, {}, {"flown.csv: no speed", "the column speed_m_s is missing", "--speed"});
}

TEST(Record, OutsideTheDataIsRefused) {
  expect_bad(flown_log(), seconds(20.0, 25.0), {}, {"window 20:25", "outside the data", "from -1 s to 10 s"});
  expect_bad(flown_log(), seconds(5.0, 25.0), {}, {"outside the data"});
  expect_bad(flown_log(), seconds(-5.0, 5.0), {}, {"outside the data"});
  EXPECT_NO_THROW((void)make_record(flown_log(), seconds(-1.05, 10.05), {}));
  expect_refused(ErrorKind::bad_configuration, {"window 5:2: begins at 5 s, after its end at 2 s"},
                 [] { (void)make_record(flown_log(), seconds(5.0, 2.0), {}); });
}

TEST(Record, OfTooFewSamplesIsRefused) {
  expect_bad(flown_log(), seconds(2.0, 2.015), {}, {"window 2:2.015", "at least 3"});
}

TEST(Record, ACellWithoutANumberIsRefusedWhereItIsNeeded) {
  logs::RollLog log = flown_log();
  log.canard_rad[350] = not_a_number;
  expect_bad(log, {}, {}, {"canard_deg has no number at 2.5 s"});
  log = flown_log();
  log.height_m[350] = not_a_number;
  expect_bad(log, {}, {}, {"height_m has no number at 2.5 s"});
  EXPECT_NO_THROW((void)make_record(log, {}, {.density_kg_m3 = 1.2}));
  EXPECT_NO_THROW((void)make_record(log, seconds(3.0, 4.0), {}));
  log.reference_rad[350] = not_a_number;
  EXPECT_TRUE(make_record(log, {}, {.density_kg_m3 = 1.2}).reference_rad.empty());
  log.canard_rad.clear();
  expect_bad(log, {}, {}, {"the column canard_deg is missing"});
}

using sim::DensityModel;

logs::RollLog log_between(double low_m, double high_m) {
  logs::RollLog log;
  log.height_m = {low_m, 0.5 * (low_m + high_m), high_m};
  return log;
}

TEST(Air, OfALogThatClimbsThinsWithHeight) {
  const Air air = choose_air(log_between(0.0, 420.0), {});
  EXPECT_EQ(air.atmosphere.model, DensityModel::exponential);
  EXPECT_NE(air.description.find("height_m"), std::string::npos);
}

TEST(Air, OfATunnelIsTheSameThroughout) {
  for (const logs::RollLog& log : {logs::RollLog{}, log_between(0.0, 0.0), log_between(-3.0, 0.4)}) {
    const Air air = choose_air(log, {});
    EXPECT_EQ(air.atmosphere.model, DensityModel::constant);
    EXPECT_EQ(air.atmosphere.constant_kg_m3, 1.2);
    EXPECT_NE(air.description.find("1.2 kg/m3"), std::string::npos);
  }
}

// ISO 2533, over geopotential height: 1.11164 kg/m3 at 1000 m, 1.00649 at 2000 m.
TEST(Air, OfASiteIsThatOfTheStandardAtmosphereThere) {
  const Air tunnel = choose_air({}, {}, 1000.0);
  EXPECT_EQ(tunnel.atmosphere.model, DensityModel::constant);
  EXPECT_NEAR(tunnel.atmosphere.constant_kg_m3, 1.11164, 1e-5);
  const std::vector<std::string> said = figures(tunnel.description);
  EXPECT_NEAR(std::stod(said.front()), 1.11164, 0.005) << tunnel.description;
  EXPECT_EQ(said.back(), "1000") << tunnel.description;
  EXPECT_EQ(choose_air(log_between(0.0, 1000.0), "isa", 1000.0).atmosphere.model, DensityModel::isa);
  EXPECT_EQ(choose_air(log_between(0.0, 1000.0), {}, 1000.0).atmosphere.model, DensityModel::isa);
  test::expect_refused(text::ErrorKind::bad_configuration, {"--density 1.1", "--elevation"},
                       [&] { (void)choose_air({}, "1.1", 1000.0); });
}

TEST(Record, CountsHeightsFromTheSite) {
  logs::RollLog log = flown_log();
  log.height_m.assign(log.time_s.size(), 1000.0);
  RecordOptions options;
  options.atmosphere.model = DensityModel::isa;
  options.site_elevation_m = 1000.0;
  EXPECT_NEAR(make_record(log, {}, options).density_kg_m3[0], 1.00649, 1e-5);
}

TEST(Air, OfALogWithoutHeightsIsNotSaidToStandStill) {
  EXPECT_NE(choose_air({}, {}).description.find("without heights"), std::string::npos);
}

TEST(Air, IsWhatThePersonSays) {
  const logs::RollLog log = log_between(0.0, 420.0);
  EXPECT_EQ(choose_air(log, "1.1").atmosphere.constant_kg_m3, 1.1);
  EXPECT_EQ(choose_air(log, "1.1").atmosphere.model, DensityModel::constant);
  EXPECT_EQ(choose_air(log, "isa").atmosphere.model, DensityModel::isa);
  EXPECT_EQ(choose_air({}, "exponential").atmosphere.model, DensityModel::exponential);
  for (const char* wrong : {"", "thin", "0", "-1.2", "nan", "1e9"}) {
    test::expect_refused(text::ErrorKind::bad_configuration, {"--density", wrong, "kg/m3, exponential, isa"},
                         [&] { (void)choose_air(log, wrong); });
  }
}

}  // namespace
}  // namespace fantail::identify
