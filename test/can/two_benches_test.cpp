// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <numeric>
#include <random>
#include <thread>

#include "avionics/can_frame.hpp"
#include "can/rig.hpp"
#include "json/value.hpp"
#include "seed.hpp"

namespace fantail::test {
namespace {

// Two bench programs at one rocket: one session is one sender's.

const std::string another_has_the_session =
    "fantail: another bench has the session; end that one, or wait until it has ended\n";

// Because a busy machine kept it silent: were it not so every time, the first bench would never end its work.
bool has_lost_its_session(const Outcome& outcome) {
  return outcome.exit_code == 74 && outcome.err == another_has_the_session;
}

TEST_F(CanSystem, ASecondBenchIsSentAwayAndTheFirstEndsItsWork) {
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};
  const Folder folder;
  const auto step = [&](const std::string& out) {
    return std::vector<std::string>{"bench", "step", "--can", "vcan0", "--canard", "2", "--to", "-5", "--out", out};
  };
  Outcome first;
  int sent_away = 0;
  for (int again = 0; again < 12; ++again) {
    Program limits{{"bench", "limits", "--can", "vcan0", "--out", folder / "limits"}};
    if (!ear.until([&] { return farthest_deg(ear.newest<protocol::CommandReport>().angle) > 1.0F; })) {
      first = limits.outcome();
      ASSERT_TRUE(starved(first) || has_lost_its_session(first)) << first.out << first.err;
      continue;
    }
    const std::uint16_t session = ear.newest<protocol::SessionReply>().session;
    std::vector<Outcome> seconds;
    bool session_stayed = true;
    for (int i = 0; i < 4 && !limits.ended(); ++i) {
      const Outcome second = fantail(step(folder / "second"));
      if (ear.until([&] { return !limits.ended(); }, std::chrono::milliseconds{1})) {
        seconds.push_back(second);
        session_stayed = session_stayed && ear.newest<protocol::SessionReply>().session == session;
      }
    }
    first = limits.outcome();
    if (starved(first) || has_lost_its_session(first)) {
      continue;  // a bench that is silent too long gives way to the next
    }
    EXPECT_TRUE(session_stayed);
    for (const Outcome& second : seconds) {
      EXPECT_EQ(second.exit_code, 74) << second.out;
      EXPECT_EQ(second.err, another_has_the_session);
      sent_away += 1;
    }
    break;
  }
  EXPECT_EQ(first.exit_code, 0) << first.out << first.err;
  EXPECT_GE(sent_away, 3);
  const Folder after;
  const Outcome last = fantail_bench({"step", "--can", "vcan0", "--canard", "2", "--out", after / "sheet"});
  EXPECT_EQ(last.exit_code, 0) << last.out << last.err;
}

// Two rockets on one bus: every verb says so and does nothing more.

constexpr const char* told = "two rockets, or a device that imitates one, report on this bus";

// Again where a busy machine kept one of the two nodes silent for as long as the verb listened.
Outcome until_told(const std::vector<std::string>& verb) {
  std::vector<std::string> words{"bench"};
  words.insert(words.end(), verb.begin(), verb.end());
  words.insert(words.end(), {"--can", "vcan0"});
  Outcome outcome = fantail(words);
  for (int again = 0; again < 11 && !contains(outcome.err, told); ++again) {
    std::printf("%s did not hear both nodes, once more: %s", verb[0].c_str(), outcome.err.c_str());
    outcome = fantail(words);
  }
  return outcome;
}

TEST_F(CanSystem, EveryVerbNamesASecondRocketAndStops) {
  Node one{"vcan0"};
  one.await_rest();
  Node other{"vcan0", "bench_canard3_reversed"};
  ASSERT_TRUE(other.program.says(" on vcan0;"));
  Ear ear{"vcan0"};
  ASSERT_TRUE(ear.until([&] { return ear.link().two_rockets().has_value(); }));
  const Folder folder;
  const std::string out = folder / "out";
  for (const std::vector<std::string>& verb : std::vector<std::vector<std::string>>{{"watch", "--for", "20"},
                                                                                    {"watch", "--json", "--for", "20"},
                                                                                    {"limits", "--out", out},
                                                                                    {"cycle", "--out", out},
                                                                                    {"hold", "1", "2", "--for", "20"},
                                                                                    {"zero"},
                                                                                    {"axes"},
                                                                                    {"arm", "--yes"},
                                                                                    {"plan", "tasha3_launch2"},
                                                                                    {"plan", "show"},
                                                                                    {"log", "--out", out}}) {
    const Outcome outcome = until_told(verb);
    EXPECT_EQ(outcome.exit_code, 74) << verb[0] << ": " << outcome.out;
    EXPECT_PRED2(contains, outcome.err, told) << verb[0];
  }
}

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
