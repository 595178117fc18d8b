// SPDX-License-Identifier: MIT
// What goes wrong before there is a bus to talk on, on any machine; test/can has the rest.

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

// No machine has an interface of that name.
const std::string nowhere = "can_of_nobody";

class EachVerbOnTheBus : public testing::TestWithParam<Words> {};

// A kernel without CAN answers before anybody looks for the interface; both answers say how a bus is got.
TEST_P(EachVerbOnTheBus, SaysWhatToDoWhenThereIsNoBus) {
  Words words = GetParam();
  words.insert(words.end(), {"--can", nowhere});
  Refusal({}, words, 74,
          {nowhere + ": ",
           "with_vcan COMMAND (in tools/ of the sources, in libexec/fantail/ of an installation), or sudo ip link add "
           "vcan0 type vcan && sudo ip link set "
           "vcan0 up"});
}

TEST_P(EachVerbOnTheBus, MustBeToldTheInterface) { Refusal({}, GetParam(), 64, {"--can is required"}); }

INSTANTIATE_TEST_SUITE_P(All, EachVerbOnTheBus,
                         testing::Values(Words{"node", "bench_healthy"}, Words{"bench", "watch"},
                                         Words{"bench", "limits"}, Words{"bench", "step", "--canard", "1"},
                                         Words{"bench", "sine", "--canard", "1"}, Words{"bench", "hold", "2", "-5"},
                                         Words{"bench", "cycle"}, Words{"bench", "zero"}, Words{"bench", "arm"},
                                         Words{"bench", "plan", "tasha3_launch2"}),
                         [](const auto& one) { return one.param[0] == "node" ? "node" : one.param[1]; });

// Files come first, so that nothing has moved when one is wrong: here the bus, which is not there, is not even asked.
TEST(BenchInput, IsReadBeforeTheBusIsTouched) {
  Refusal({}, {"bench", "limits", "--can", nowhere, "--vehicle", "tasha9"}, 66, {"unknown vehicle \"tasha9\""});
  Refusal({}, {"bench", "limits", "--can", nowhere, "--plan", "tasha9"}, 66, {"unknown flight plan \"tasha9\""});
  Refusal({}, {"bench", "plan", "none.ftpl", "--can", nowhere}, 66, {"none.ftpl: no such file"});
  Refusal({}, {"node", "bench_helthy", "--can", nowhere}, 66,
          {"unknown scenario \"bench_helthy\"", "did you mean bench_healthy?"});
  Refusal({}, {"node", "bench_healthy", "--can", nowhere, "--set", "timing.pad_time_s=-1"}, 78, {"pad_time_s"});
  Refusal({}, {"node", "bench_healthy", "--can", nowhere, "--set", "no.such_key=1"}, 78, {"no.such_key"});
}

TEST(BenchSheet, ThatCannotBeWrittenIsSaidBeforeTheBusIsTouched) {
  const Folder folder;
  const std::string file = folder.write("taken", "mine");
  for (const std::string& in_the_way : {file, std::string{"/dev/full"}}) {
    for (const std::string& out : {in_the_way, in_the_way + "/x"}) {
      Refusal({}, {"bench", "limits", "--can", nowhere, "--out", out}, 74, {in_the_way + ": not a folder"});
      Refusal({}, {"bench", "zero", "--can", nowhere, "--write", out + "/plan.toml"}, 74,
              {in_the_way + ": not a folder; choose another one for the plan with --write"});
    }
  }
  EXPECT_EQ(content(file), "mine");
  EXPECT_EQ(folder.listing(), Words{"taken"});
}

TEST(BenchOptions, OutOfRangeAreUsageErrors) {
  Refusal({}, {"bench", "step", "--can", nowhere}, 64, {"--canard"});
  Refusal({}, {"bench", "step", "--can", nowhere, "--canard", "5"}, 64, {"--canard"});
  Refusal({}, {"bench", "step", "--can", nowhere, "--canard", "1", "--to", "21"}, 64, {"--to"});
  Refusal({}, {"bench", "sine", "--can", nowhere, "--canard", "1", "--frequency", "0"}, 64, {"--frequency"});
  Refusal({}, {"bench", "sine", "--can", nowhere, "--canard", "1", "--amplitude", "0.2"}, 64,
          {"--amplitude", "0.20", "1.10 to 20.47"});
  Refusal({}, {"bench", "limits", "--can", nowhere, "--canard", "0"}, 64, {"--canard"});
  Refusal({}, {"bench", "watch", "--can", nowhere, "--for", "-1"}, 64, {"--for"});
  Refusal({}, {"bench", "zero", "--can", nowhere, "--trust", "me"}, 64, {"--trust"});
  Refusal({}, {"bench", "cycle", "--can", nowhere, "--for", "0"}, 64, {"--for"});
  Refusal({}, {"bench", "hold", "5", "0", "--can", nowhere}, 64, {"CANARD"});
  Refusal({}, {"bench", "hold", "1", "-21", "--can", nowhere}, 64, {"DEG"});
  Refusal({}, {"bench", "arm", "--can", nowhere, "--wait", "-1"}, 64, {"--wait"});
  Refusal({}, {"bench"}, 64,
          {"a verb is missing; allowed: watch, limits, step, sine, hold, cycle, zero, axes, arm, plan, dormancy"});
}

}  // namespace
}  // namespace fantail::test
