// SPDX-License-Identifier: MIT
#include <csignal>

#include <nlohmann/json.hpp>

#include "can/rig.hpp"

namespace fantail::test {
namespace {

using nlohmann::json;

json last_object(const std::string& lines) {
  const std::size_t end = lines.rfind('\n');
  const std::size_t begin = end == std::string::npos || end == 0 ? 0 : lines.rfind('\n', end - 1) + 1;
  return end == std::string::npos ? json{} : json::parse(lines.substr(begin, end - begin));
}

TEST_F(CanSystem, AnInterfaceThatGoesDownAndComesBackIsNoticedAndNothingHasToBeStartedAgain) {
  Node node{"vcan0"};
  node.await_rest();
  Program watch{{"bench", "watch", "--can", "vcan0", "--json"}};
  const auto shows = [&](const std::function<bool(const json&)>& question) {
    return eventually(
        [&] {
          const json object = last_object(watch.said());
          return object.is_object() && question(object);
        },
        std::chrono::seconds{20});
  };
  EXPECT_TRUE(shows([](const json& now) { return now["bus_state"] == "error active" && now["phase"] == "safe"; }));
  must("ip link set vcan0 down");
  EXPECT_TRUE(shows([](const json& now) { return now["bus_state"] == "down" && now["phase"].is_null(); }));
  const auto frames_before = last_object(watch.said())["frames"].get<std::uint64_t>();
  must("ip link set vcan0 up");
  EXPECT_TRUE(shows([&](const json& now) {
    return now["bus_state"] == "error active" && now["phase"] == "safe" && now["frames"] > frames_before + 100;
  }));
  // It was down, and not switched off: the rocket's time has gone on.
  EXPECT_GT(last_object(watch.said())["uptime_s"].get<double>(), 4.0);
  watch.signal(SIGINT);
  EXPECT_EQ(watch.outcome().exit_code, 0) << watch.outcome().err;
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0) << node.program.outcome().err;
}

}  // namespace
}  // namespace fantail::test
