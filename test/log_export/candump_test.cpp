// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "log_export/formats.hpp"
#include "made_flight.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::log_export {
namespace {

struct Line {
  core::Microseconds time{};
  protocol::FromAvionics message;
  std::optional<std::uint8_t> counter;
};

// The other way round from the text; refuses what is not exactly a line of candump's log format.
std::vector<Line> read(const std::string& text) {
  std::vector<Line> lines;
  std::istringstream stream{text};
  for (std::string one; std::getline(stream, one);) {
    long long seconds = 0;
    long long micro = 0;
    unsigned id = 0;
    int end = 0;
    EXPECT_EQ(std::sscanf(one.c_str(), "(%lld.%6lld) can0 %3X#%n", &seconds, &micro, &id, &end), 3) << one;
    protocol::BusFrame frame{.id = static_cast<std::uint16_t>(id)};
    for (auto at = static_cast<std::size_t>(end); at + 1 < one.size(); at += 2) {
      frame.data.at(frame.length++) = static_cast<std::uint8_t>(std::stoul(one.substr(at, 2), nullptr, 16));
    }
    const auto decoded = protocol::decode_from_avionics(frame);
    EXPECT_TRUE(decoded.message) << one;
    if (decoded.message) {
      lines.push_back({core::Microseconds{seconds * 1'000'000 + micro}, *decoded.message, decoded.counter});
    }
  }
  return lines;
}

template <typename Message>
std::vector<Line> only(const std::vector<Line>& lines) {
  std::vector<Line> some;
  std::ranges::copy_if(lines, std::back_inserter(some),
                       [](const Line& line) { return std::holds_alternative<Message>(line.message); });
  return some;
}

TEST(CandumpExport, CommandsAndEncodersComeEveryMillisecondFromDetectionOnAndEveryTenBefore) {
  const MadeFlight made;
  const auto lines = read(candump(made.source()));
  // 10 before detection, 400 up to the gap, 440 from where the replay can go on.
  EXPECT_EQ(only<protocol::CommandReport>(lines).size(), 850U);
  const auto encoders = only<protocol::EncoderReport>(lines);
  ASSERT_EQ(encoders.size(), 850U);
  EXPECT_EQ(encoders[1].time - encoders[0].time, core::Microseconds{10'000});
  EXPECT_EQ(encoders[20].time - encoders[19].time, core::Microseconds{1000});
}

TEST(CandumpExport, FramesCarryTheValuesOfTheirTickToTheResolutionOfTheBus) {
  const MadeFlight made;
  const auto lines = read(candump(made.source()));
  for (const Line& line : only<protocol::EncoderReport>(lines)) {
    const auto tick = static_cast<int>((line.time - MadeFlight::time(0)).count() / 1000);
    const auto& angle = std::get<protocol::EncoderReport>(line.message).angle;
    ASSERT_TRUE(angle[1]);
    EXPECT_NEAR(angle[1]->degrees(), MadeFlight::command_deg(tick, 2) / 2.0F, 0.006);
    EXPECT_FALSE(angle[3]);
  }
  const auto motion = only<protocol::MotionReport>(lines);
  ASSERT_FALSE(motion.empty());
  EXPECT_EQ(motion.front().time, MadeFlight::time(6));
  EXPECT_NEAR(std::get<protocol::MotionReport>(motion.front().message).speed_m_s, 0.75F, 0.02F);
}

TEST(CandumpExport, CountersRunOnFromFrameToFrame) {
  const MadeFlight made;
  protocol::Sequence sequence;
  for (const Line& line : only<protocol::CommandReport>(read(candump(made.source())))) {
    EXPECT_EQ(sequence.lost_before(line.counter.value()), 0);
  }
}

TEST(CandumpExport, HealthIsThatOfTheLogAndTheHeartbeatNamesThePlan) {
  const MadeFlight made;
  const auto lines = read(candump(made.source()));
  const auto health = only<protocol::HealthReport>(lines);
  ASSERT_EQ(health.size(), 3U);
  EXPECT_EQ(health[1].time, MadeFlight::time(150));
  EXPECT_EQ(std::get<protocol::HealthReport>(health[1].message).longest_tick_us, 150);
  const auto beats = only<protocol::HeartbeatReport>(lines);
  ASSERT_FALSE(beats.empty());
  EXPECT_EQ(std::get<protocol::HeartbeatReport>(beats[0].message).plan_crc, protocol::plan_crc(core::default_plan()));
  EXPECT_EQ(std::get<protocol::HeartbeatReport>(beats[0].message).uptime_ms, 10'044U);
}

TEST(CandumpExport, LinesAreInOrderOfTimeAndAGapStaysAGap) {
  const MadeFlight made;
  const auto lines = read(candump(made.source()));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_LE(lines[i - 1].time, lines[i].time);
    EXPECT_FALSE(lines[i].time > MadeFlight::time(499) && lines[i].time < MadeFlight::time(560));
  }
}

}  // namespace
}  // namespace fantail::log_export
