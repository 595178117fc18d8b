// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <csignal>
#include <numeric>
#include <random>
#include <thread>

#include "avionics/can_frame.hpp"
#include "can/rig.hpp"
#include "json/value.hpp"
#include "seed.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

constexpr std::size_t frames_of_each = 1'000;
constexpr std::chrono::milliseconds pause{8};

/// Random identifiers, lengths and bytes, but no report of the avionics, whole and in range: those carry no CRC, so a
/// bench cannot tell who sent them.
void send_random_frames(std::uint32_t seed) {
  hal::on_linux::CanBus bus{"vcan0"};
  std::mt19937 random{seed};
  for (std::size_t sent = 0; sent < frames_of_each;) {
    hal::CanFrame frame{.id = static_cast<std::uint32_t>(random() % 2048),
                        .length = static_cast<std::uint8_t>(random() % 9)};
    std::ranges::generate(frame.data, [&random] { return static_cast<std::uint8_t>(random()); });
    if (!protocol::decode_from_avionics(avionics::bus_frame(frame)).message) {
      (void)bus.send(frame);
      std::this_thread::sleep_for(pause);
      ++sent;
    }
  }
}

// As from other devices on the bus and from broken ones, 500 frames a second. With 2000 the guest would be busy with
// them alone.
TEST_F(CanSystem, ABusFullOfOthersFramesNeitherMovesACanardNorDisturbsTheBench) {
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};
  ASSERT_TRUE(ear.until([&] { return ear.link().newest<protocol::LimitReport>().has_value(); }));
  const auto limits = ear.newest<protocol::LimitReport>().limit;
  Dump dump{"vcan0"};
  const auto noise = [](const std::string& kind) {
    return std::make_unique<Program>("cangen", std::vector<std::string>{"vcan0", "-g", std::to_string(pause.count()),
                                                                        "-n", std::to_string(frames_of_each), kind});
  };
  const auto others = {noise("-e"), noise("-R"), noise("-f")};  // extended, remote, CAN FD
  std::jthread sender{send_random_frames, seed()};
  Program watch{{"bench", "watch", "--can", "vcan0", "--json"}};
  const Folder folder;
  const Outcome step = fantail_bench(
      {"step", "--can", "vcan0", "--canard", "1", "--vehicle", "tasha3_bench", "--out", folder / "sheet"});
  EXPECT_EQ(step.exit_code, 0) << step.out << step.err;
  for (const auto& other : others) {
    EXPECT_EQ(other->outcome().exit_code, 0) << other->outcome().err;
  }
  sender.join();
  ASSERT_TRUE(ear.until([&] {
    const auto counts = ear.newest<protocol::RejectionReport>().count;
    return std::accumulate(counts.begin(), counts.end(), 0) > 0;
  }));
  const std::size_t seen = watch.said().size();
  EXPECT_TRUE(eventually([&] { return watch.said().size() > seen + 3000; }));
  watch.signal(SIGINT);

  const std::string said = watch.outcome().out;
  const std::size_t last = said.rfind('\n', said.size() - 2);
  const Json object = json::parse(said.substr(last == std::string::npos ? 0 : last + 1));
  EXPECT_GT(object["frames_foreign"].number(), 1000);
  EXPECT_GT(object["frames_damaged"].number(), 0);
  const auto& rejected = object["frames_refused_by_avionics"];
  EXPECT_GT(rejected["unknown_id"].number(), 0);
  EXPECT_GT(rejected["wrong_length"].number(), 0);

  const std::string log = dump.log();
  float farthest = 0.0F;
  for (const auto& command : reports<protocol::CommandReport>(log)) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      EXPECT_LE(std::fabs(command.angle[i].value_or(core::Angle{}).degrees()), limits[i].degrees());
      EXPECT_TRUE(i == 0 || command.angle[i].value_or(core::Angle{}).degrees() == 0.0F) << "canard " << i + 1;
    }
    farthest = std::max(farthest, farthest_deg(command.angle));
  }
  EXPECT_NEAR(farthest, 5.0F, 0.005F) << "what the bench asked for";
}

}  // namespace
}  // namespace fantail::test
