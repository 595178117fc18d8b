// SPDX-License-Identifier: MIT
#include <cmath>
#include <csignal>

#include "can/rig.hpp"
#include "json/value.hpp"
#include "telemetry/multicast.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

// Two ports and not two addresses: the kernel hands what comes to a port to everyone who has joined any of its groups.
const std::string from_node = "udpm://239.255.76.67:7671?ttl=0";
const std::string from_gateway = "udpm://239.255.76.67:7672?ttl=0";

class GatewaySystem : public CanSystem {
 protected:
  void SetUp() override {
    CanSystem::SetUp();
    follow_the_advice();
  }
  [[nodiscard]] std::vector<std::string> node_with_lcm() const {
    return {"node", "bench_healthy", "--can", "vcan0", "--flash", folder / "flash.bin", "--lcm", from_node};
  }
  Folder folder;
};

bool is_live(const Watcher& watcher) {
  const auto seen = watcher.seen();
  return !seen.empty() && seen.back()["link"] == "live" && !seen.back()["health"]["gyro"].is_null() &&
         !seen.back()["canards"]["each"][0]["limit_deg"].is_null() &&
         !seen.back()["canards"]["each"][0]["verdict"].is_null();
}

// One rocket, heard in two ways: from within, and through its bus and a gateway.
TEST_F(GatewaySystem, SaysOfARealBusWhatTheNodeSaysOfItself) {
  Program node{node_with_lcm()};
  ASSERT_TRUE(node.says(" on vcan0;")) << node.outcome().err;
  Dump dump{"vcan0"};
  Program gateway{{"gateway", "--can", "vcan0", "--lcm", from_gateway}};
  Watcher inside{from_node};
  Watcher outside{from_gateway};
  ASSERT_TRUE(eventually([&] { return is_live(inside) && is_live(outside); }));
  Program arm{{"bench", "arm", "--can", "vcan0", "--yes"}};
  ASSERT_TRUE(arm.says("Close the arm switch at the rocket.")) << arm.said();
  ASSERT_TRUE(eventually([&] { return is_live(inside) && is_live(outside); }));  // a busy machine loses frames
  const auto at_rest_inside = inside.seen().back();
  const auto at_rest_outside = outside.seen().back();
  node.type("switch close");
  EXPECT_EQ(arm.outcome().exit_code, 0) << arm.outcome().err;
  const std::vector<std::string> armed{"safe -> armed (armed_by_switch_and_command)"};
  EXPECT_TRUE(eventually([&] { return events(inside.seen()) == armed && events(outside.seen()) == armed; }))
      << testing::PrintToString(events(outside.seen()));
  gateway.signal(SIGINT);
  EXPECT_EQ(gateway.outcome().exit_code, 0);
  EXPECT_FALSE(contains(gateway.outcome().err, "silent"));  // lost frames it may tell of, on a busy machine
  EXPECT_PRED2(contains, gateway.outcome().out, "vcan0 to " + from_gateway + "; Ctrl-C ends\nframes: ");
  EXPECT_PRED2(contains, gateway.outcome().out, " messages to " + from_gateway + "\n");

  // At rest both say the same, as far as the bus's steps let them.
  const auto near = [](const Json& a, const Json& b, double tolerance) {
    return std::abs(a.number() - b.number()) <= tolerance;
  };
  EXPECT_PRED3(near, at_rest_inside["state"]["roll_angle_deg"], at_rest_outside["state"]["roll_angle_deg"], 0.3);
  EXPECT_PRED3(near, at_rest_inside["state"]["height_m"], at_rest_outside["state"]["height_m"], 0.5);
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& one = at_rest_inside["canards"]["each"][i];
    const Json& other = at_rest_outside["canards"]["each"][i];
    EXPECT_PRED3(near, one["limit_deg"], other["limit_deg"], 0.02);
    EXPECT_EQ(one["verdict"], other["verdict"]);
  }
  EXPECT_EQ(at_rest_inside["health"]["gyro"], at_rest_outside["health"]["gyro"]);
  EXPECT_TRUE(at_rest_inside["health"]["gateway"].is_null());
  EXPECT_GT(at_rest_outside["health"]["gateway"]["frames"].number(), 0);
  EXPECT_FALSE(at_rest_inside["state"]["specific_force_m_s2"].is_null());
  EXPECT_TRUE(at_rest_outside["state"]["specific_force_m_s2"].is_null());
  // Nothing on the bus is the gateway's: the avionics speaks with 0x100 and more, and the bench that armed with less.
  // Of the bench's, arming takes three frames; a gateway has nothing to say that would not be one more.
  std::size_t of_others = 0;
  for (const LoggedFrame& logged : frames(dump.log())) {
    of_others += logged.frame.id < 0x100 ? 1 : 0;
  }
  EXPECT_EQ(of_others, 3U);
}

TEST_F(GatewaySystem, ABusThatGoesDownAndComesBackIsToldAndSoIsSilence) {
  Program gateway{"sh", {"-c", "exec \"$0\" gateway --can vcan0 --lcm \"$1\" 2>&1", fantail_path(), from_gateway}};
  ASSERT_TRUE(gateway.says("vcan0 to "));
  must("ip link set vcan0 down");
  EXPECT_TRUE(gateway.says("vcan0: bus: down\n"));
  must("ip link set vcan0 up");
  EXPECT_TRUE(gateway.says("vcan0: bus: error active\n"));
  EXPECT_TRUE(gateway.says("vcan0: the avionics is silent\n"));
  const Node node{"vcan0"};
  EXPECT_TRUE(gateway.says("vcan0: the avionics reports again\n"));
  gateway.signal(SIGTERM);
  EXPECT_EQ(gateway.outcome().exit_code, 0);
}

TEST_F(GatewaySystem, WithoutABusOrARouteItSaysWhatToDo) {
  const Outcome no_bus = fantail({"gateway", "--can", "vcan7", "--lcm", from_gateway});
  EXPECT_EQ(no_bus.exit_code, 74);
  EXPECT_PRED2(contains, no_bus.err, "vcan7");
  take_the_route_away();
  const std::string advice = "sudo ip route add 224.0.0.0/4 dev lo";
  for (const auto& arguments :
       {std::vector<std::string>{"gateway", "--can", "vcan0", "--lcm", from_gateway}, node_with_lcm()}) {
    const Outcome outcome = fantail(arguments);
    EXPECT_EQ(outcome.exit_code, 74);
    EXPECT_PRED2(contains, outcome.err, advice);
  }
}

// The rocket and its bench go on; only at the end is it an error.
TEST_F(GatewaySystem, ANetworkThatGoesAwayDoesNotEndAFlight) {
  Program node{node_with_lcm()};
  ASSERT_TRUE(node.says(" on vcan0;")) << node.outcome().err;
  {
    Watcher inside{from_node};
    EXPECT_TRUE(eventually([&] { return is_live(inside); }));
  }
  take_the_route_away();
  EXPECT_TRUE(Ear{"vcan0"}.at_rest());
  node.signal(SIGTERM);
  EXPECT_EQ(node.outcome().exit_code, 74);
  EXPECT_PRED2(contains, node.outcome().err, " messages could not be sent: is the network down?");
  EXPECT_PRED2(contains, node.outcome().out, "ended after ");
}

}  // namespace
}  // namespace fantail::test
