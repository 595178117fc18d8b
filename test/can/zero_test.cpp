// SPDX-License-Identifier: MIT
#include <cmath>
#include <sstream>

#include "can/rig.hpp"
#include "json/value.hpp"

namespace fantail::test {
namespace {

TEST_F(CanSystem, ZeroFindsAHornThatIsOffAndWritesAPlanThatCorrectsIt) {
  Node node{"vcan0", "bench_canard3_wrong_trim"};
  node.await_rest();
  const Folder folder;
  const std::string plan = folder / "corrected.toml";
  const Outcome measured =
      fantail_bench({"zero", "--can", "vcan0", "--plan", "tasha3_launch2", "--json", "--write", plan});
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  const json::Value zero = json::parse(measured.out);
  EXPECT_EQ(zero["trusted"], "encoder");
  EXPECT_NEAR(zero["canards"][2]["centre_deg"]["value"].number(), 2.5, 0.6);
  // The file is the plan in force but for the two lines.
  std::istringstream before{fantail({"plan", "show", "tasha3_launch2"}).out};
  std::istringstream after{content(plan)};
  std::string changed;
  std::string old_line;
  std::string new_line;
  while (std::getline(before, old_line) && std::getline(after, new_line)) {
    changed += old_line == new_line ? "" : new_line.substr(0, new_line.find(' ')) + ' ';
  }
  EXPECT_EQ(changed, "pulse_centre_us pulse_per_degree_us ");

  const Outcome again = fantail({"bench", "zero", "--can", "vcan0", "--write", plan});
  EXPECT_EQ(again.exit_code, 74);
  EXPECT_PRED2(contains, again.err, "exists; choose another name for the new plan");
  ASSERT_EQ(fantail_bench({"plan", plan, "--can", "vcan0"}).exit_code, 0);
  const Outcome step = fantail_bench({"hold", "3", "0", "--can", "vcan0", "--wait", "30", "--for", "2", "--json"});
  ASSERT_EQ(step.exit_code, 0) << step.err;
  const std::string last = step.out.substr(step.out.find('\n') + 1);
  EXPECT_NEAR(json::parse(last)["encoder_deg"].number(), 0.0, 0.2) << "it was 2.5";
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

TEST_F(CanSystem, ZeroRefusesAReversedCanardAndWritesNothing) {
  Node node{"vcan0", "bench_canard3_reversed"};
  node.await_rest();
  const Folder folder;
  const Outcome refused = fantail_bench({"zero", "--can", "vcan0", "--write", folder / "plan.toml"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_PRED2(contains, refused.err, "Canard 3 is not measured: its encoder goes the other way than the command.");
  EXPECT_PRED2(contains, refused.err, "Nothing was written.");
  EXPECT_EQ(refused.out, "");
  EXPECT_TRUE(folder.listing().empty());
  node.program.type("quit");
  EXPECT_EQ(node.program.outcome().exit_code, 0);
}

}  // namespace
}  // namespace fantail::test
