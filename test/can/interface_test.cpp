// SPDX-License-Identifier: MIT
#include <csignal>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

Json last_object(const std::string& lines) {
  const std::size_t end = lines.rfind('\n');
  const std::size_t begin = end == std::string::npos || end == 0 ? 0 : lines.rfind('\n', end - 1) + 1;
  return end == std::string::npos ? Json{} : json::parse(lines.substr(begin, end - begin));
}

TEST_F(CanSystem, AnInterfaceThatGoesDownAndComesBackIsNoticedAndNothingHasToBeStartedAgain) {
  Node node{"vcan0"};
  node.await_rest();
  Program watch{{"bench", "watch", "--can", "vcan0", "--json"}};
  const auto shows = [&](const std::function<bool(const Json&)>& question) {
    return eventually([&] {
      const Json object = last_object(watch.said());
      return object.is_object() && question(object);
    });
  };
  EXPECT_TRUE(shows([](const Json& now) { return now["bus_state"] == "error active" && now["phase"] == "safe"; }));
  must("ip link set vcan0 down");
  EXPECT_TRUE(shows([](const Json& now) { return now["bus_state"] == "down" && now["phase"].is_null(); }));
  const auto frames_before = last_object(watch.said())["frames"].number();
  must("ip link set vcan0 up");
  EXPECT_TRUE(shows([&](const Json& now) {
    return now["bus_state"] == "error active" && now["phase"] == "safe" && now["frames"].number() > frames_before + 100;
  }));
  // It was down, and not switched off: the rocket's time has gone on.
  EXPECT_GT(last_object(watch.said())["uptime_s"].number(), 4.0);
  watch.signal(SIGINT);
  EXPECT_EQ(watch.outcome().exit_code, 0) << watch.outcome().err;
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0) << node.program.outcome().err;
}

TEST_F(CanSystem, ANodeThatAPcHeldUpSaysSoOnTheBusAndCanStillBeArmed) {
  Node node{"vcan0"};
  node.await_rest();
  Ear ear{"vcan0"};
  node.program.signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::seconds{1});
  node.program.signal(SIGCONT);
  EXPECT_TRUE(ear.until([&] { return ear.newest<protocol::BoardReport>().overruns == 255; }));
  EXPECT_EQ(ear.newest<protocol::BoardReport>().faults, 0U);
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0) << node.program.outcome().err;
}

}  // namespace
}  // namespace fantail::test
