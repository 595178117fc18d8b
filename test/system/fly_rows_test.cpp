// SPDX-License-Identifier: MIT
// How many rows of a flight are kept.
#include <algorithm>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"

namespace fantail::test {
namespace {

TEST(Fly, AScenarioMaySayHowManyRowsAreKept) {
  const Folder folder;
  const std::vector<std::string> short_run{"fly", "tunnel_swirl_with", "--set", "run.control_time_s=3", "--out"};
  const auto flown = [&](const char* name, const char* change) {
    std::vector<std::string> arguments = short_run;
    arguments.insert(arguments.end(), {folder / name, "--set", change});
    const Outcome outcome = fantail(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string said = flown("thin", "timing.log_period_s=0.02");
  EXPECT_NE(said.find("a row every 0.02 s instead of every millisecond"), std::string::npos) << said;
  EXPECT_EQ(flown("full", "timing.log_period_s=0.001").find("instead of"), std::string::npos);
  const std::string thin = content(folder / "thin/flight.csv");
  const std::string full = content(folder / "full/flight.csv");
  EXPECT_EQ(std::ranges::count(full, '\n') / std::ranges::count(thin, '\n'), 19);  // 20 but for the header
  // What is kept is as it was.
  for (std::size_t begin = 0; begin < thin.size();) {
    const std::size_t end = thin.find('\n', begin) + 1;
    ASSERT_NE(full.find(thin.substr(begin, end - begin)), std::string::npos);
    begin = end;
  }
  EXPECT_EQ(content(folder / "thin/tunnel.csv"), content(folder / "full/tunnel.csv"));
}

TEST(Fly, HowManyRowsALaunchKeepsChangesNoFigure) {
  const Folder folder;
  const auto summary = [&folder](const char* period) {
    const std::vector<std::string> words{"fly", "--json", "--set", std::string{"timing.log_period_s="} + period};
    json::Value all = json::parse(fantail(words, {.working_folder = folder.path()}).out);
    all["notes"] = all["changes"] = all["made"] = nullptr;
    return all.pretty();
  };
  EXPECT_EQ(summary("0.001"), summary("1"));
}

}  // namespace
}  // namespace fantail::test
