// SPDX-License-Identifier: MIT
// What the programs say and obey, in the words of cantools and can-utils, which were not written by us.
#include <algorithm>
#include <csignal>
#include <sstream>

#include <fmt/core.h>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

class InOthersWords : public WithCantools {};

/// Signals of one kind of message, numbers as the watch shows them.
std::vector<std::vector<std::string>> spoken_values(const std::vector<Spoken>& all, const std::string& name,
                                                    const std::vector<std::string>& signals) {
  std::vector<std::vector<std::string>> found;
  for (const Spoken& one : all) {
    if (one.name == name) {
      std::vector<std::string> values;
      for (const std::string& signal : signals) {
        values.push_back(one.signals.at(signal));
      }
      found.push_back(values);
    }
  }
  return found;
}

std::string in_hundredths(double value) {
  const std::string text = fmt::format("{:.2f}", value);
  return text == "-0.00" ? "0.00" : text;
}

std::vector<std::string> canards(const Json& object, const std::string& key) {
  std::vector<std::string> values;
  for (const Json& one : object["canards"]) {
    values.push_back(one[key].is_number() ? in_hundredths(one[key].number()) : one[key].text());
  }
  return values;
}

/// Every line of the watch must come up among the frames, one after the other.
void expect_in_order(std::vector<std::vector<std::string>> frames, const std::vector<std::vector<std::string>>& watched,
                     const std::string& what) {
  for (auto& frame : frames) {
    for (std::string& value : frame) {
      char* end = nullptr;
      const double number = std::strtod(value.c_str(), &end);
      value = *end == '\0' ? in_hundredths(number) : value;
    }
  }
  auto from = frames.begin();
  for (const auto& values : watched) {
    from = std::find(from, frames.end(), values);
    ASSERT_NE(from, frames.end()) << what << ": " << Json(values);
  }
}

TEST_F(InOthersWords, WatchSaysWhatCantoolsReadsOnTheBus) {
  Node node{"vcan0"};
  node.await_rest();
  Dump dump{"vcan0"};
  Program watch{{"bench", "watch", "--can", "vcan0", "--json"}};
  const Folder folder;
  const Outcome sine = fantail_bench({"sine", "--can", "vcan0", "--canard", "2", "--amplitude", "5", "--frequency",
                                      "0.7", "--cycles", "2", "--out", folder / "sheet"});
  EXPECT_EQ(sine.exit_code, 0) << sine.out << sine.err;
  watch.signal(SIGINT);
  const std::string said = watch.outcome().out;
  const std::vector<Spoken> all = decoded_by_cantools(dump.log());

  std::map<std::string, std::vector<std::vector<std::string>>> watched;
  std::istringstream lines{said};
  for (std::string line; std::getline(lines, line);) {
    const Json object = json::parse(line);
    watched["command"].push_back(canards(object, "command_deg"));
    watched["encoder"].push_back(canards(object, "encoder_deg"));
    watched["verdict"].push_back(canards(object, "verdict"));
    watched["phase"].push_back({object["phase"].text(), object["reason"].text()});
    watched["heartbeat"].push_back(
        {in_hundredths(1000.0 * object["uptime_s"].number()),
         in_hundredths(static_cast<double>(std::stoul(object["plan_crc"].text(), nullptr, 16)))});
  }
  ASSERT_GE(watched["phase"].size(), 4U) << said;
  const std::vector<std::string> angles{"canard_1", "canard_2", "canard_3", "canard_4"};
  expect_in_order(spoken_values(all, "CommandReport", angles), watched["command"], "command");
  expect_in_order(spoken_values(all, "EncoderReport", angles), watched["encoder"], "encoder");
  expect_in_order(spoken_values(all, "HealthReport", {"verdict_1", "verdict_2", "verdict_3", "verdict_4"}),
                  watched["verdict"], "verdict");
  expect_in_order(spoken_values(all, "StatusReport", {"phase", "reason"}), watched["phase"], "phase");
  // The watch shows hundredths of a second.
  auto heartbeats = spoken_values(all, "HeartbeatReport", {"uptime", "plan_crc"});
  for (auto& one : heartbeats) {
    one[0] = in_hundredths(10.0 * std::round(std::stod(one[0]) / 10.0));
  }
  expect_in_order(heartbeats, watched["heartbeat"], "heartbeat");
}

/// A bench session of 2.5 s, 625 frames, as a foreign program would hold it: canard 2 is asked to stand at 3 degrees.
std::string session(int number, bool right) {
  std::string lines;
  const std::string crc = right ? "" : "wrong_crc ";
  for (int i = 0; i < 500; ++i) {
    const double time_s = 0.005 * i;
    if (i % 4 == 0) {
      lines += fmt::format("{:.3f} BenchSession action={} session={} counter={}\n", time_s,
                           i == 0 ? "open" : (i == 496 ? "close" : "keep"), number, i / 4 % 16);
    }
    lines += fmt::format("{:.3f} BenchRequest {}in={} canard_2=3 asked_2=1 counter={}\n", time_s + 0.002, crc, number,
                         i % 16);
  }
  return lines;
}

std::string next_lines(std::istream& from, int count) {
  std::string lines;
  for (std::string line; count > 0 && std::getline(from, line); --count) {
    lines += line + "\n";
  }
  return lines;
}

TEST_F(InOthersWords, FramesOfCantoolsAreObeyedWhenTheirChecksumIsRightAndOnlyThen) {
  const Folder folder;
  Node node{"vcan0"};
  std::istringstream made{encoded_by_cantools(
      "0 ArmRequest wrong_crc action=self_test counter=7\n0 ArmRequest action=self_test counter=8\n" +
          session(4710, false) + session(4711, true),
      "vcan0")};
  std::string ignored;
  std::string spoilt_request;
  std::string good_request;
  made >> ignored >> ignored >> spoilt_request >> ignored >> ignored >> good_request >> std::ws;
  const std::string wrong = folder.write("wrong", next_lines(made, 625));
  const std::string right = folder.write("right", next_lines(made, 625));
  node.await_rest();
  Ear ear{"vcan0"};
  const auto wrong_crc = [&] {
    return ear.newest<protocol::RejectionReport>().count[static_cast<std::size_t>(protocol::Rejection::wrong_crc)];
  };
  const auto stands = [&](float degrees) {
    const auto command = ear.newest<protocol::CommandReport>().angle[1];
    const auto encoder = ear.newest<protocol::EncoderReport>().angle[1];
    return command && encoder && std::fabs(command->degrees() - degrees) < 0.005F &&
           std::fabs(encoder->degrees() - degrees) < 0.5F;
  };
  ASSERT_TRUE(ear.until([&] { return ear.link().newest<protocol::RejectionReport>().has_value(); }));
  EXPECT_EQ(wrong_crc(), 0);

  must("cansend vcan0 " + spoilt_request);
  EXPECT_TRUE(ear.until([&] { return wrong_crc() == 1; }));
  EXPECT_EQ(ear.newest<protocol::ArmReply>().self_test, protocol::SelfTestState::not_run);

  {
    Program player{"canplayer", {"-I", wrong}};
    bool opened = false;
    bool moved = false;
    EXPECT_TRUE(ear.until([&] {
      opened = opened || ear.newest<protocol::StatusReport>().session_open;
      moved = moved || !stands(0.0F);
      return opened && !ear.newest<protocol::StatusReport>().session_open;
    }));
    EXPECT_FALSE(moved);
    EXPECT_EQ(player.outcome().exit_code, 0);
  }
  // The last four come after the end of the session, when none is the right one: they are stale.
  EXPECT_TRUE(ear.until([&] { return wrong_crc() == (1 + 496) % 256; })) << int{wrong_crc()};

  {
    const Program player{"canplayer", {"-I", right}};
    EXPECT_TRUE(ear.until([&] { return stands(3.0F); }));
    EXPECT_EQ(ear.newest<protocol::SessionReply>().session, 4711);
    EXPECT_TRUE(ear.until([&] { return !ear.newest<protocol::StatusReport>().session_open && stands(0.0F); }));
    EXPECT_EQ(ear.newest<protocol::SessionReply>().reason, protocol::SessionReason::closed_by_bench);
  }
  EXPECT_EQ(wrong_crc(), (1 + 496) % 256);

  must("cansend vcan0 " + good_request);
  EXPECT_TRUE(ear.until([&] { return ear.newest<protocol::StatusReport>().self_test_running; }));
}

}  // namespace
}  // namespace fantail::test
