// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/made_tunnel_log.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

TEST(IdentifyForeignLog, ReadsAnotherLoggersNamesAndUnits) {
  const Folder folder;
  std::string log = "t,phi,p,fin\n";
  for (const Row& r : tunnel_rows(shaken)) {
    log += std::to_string(r.time_s) + "," + std::to_string(r.angle_deg / degrees) + "," +
           std::to_string(r.rate_deg_s / degrees) + "," + std::to_string(r.canard_deg / degrees) + "\r\n";
  }
  folder.write("run.csv", log);
  const std::vector<std::string> older{
      "--column",       "time_s=t", "--column", "roll_angle_deg=phi", "--column", "roll_rate_deg_s=p", "--column",
      "canard_deg=fin", "--units",  "rad"};
  const std::vector<std::string> newer{"--columns", "rad,time_s=t,roll_angle_deg=phi,roll_rate=p:rad/s,canard_deg=fin"};
  for (const std::vector<std::string>& columns : {older, newer}) {
    std::vector<std::string> words{"identify", "run.csv"};
    words.insert(words.end(), columns.begin(), columns.end());
    for (const char* word : {"--speed", "22", "--inertia", "0.00393", "--area", "5.0265e-5", "--json"}) {
      words.emplace_back(word);
    }
    const auto json = identified(folder, words);
    EXPECT_EQ(json["window"], "all");
    EXPECT_NEAR(json["alpha_m2"].number(), 20.0, 0.1);
    EXPECT_NEAR(json["beta_m"].number(), 9.0, 0.05);
    EXPECT_NEAR(json["disturbance_deg"][0].number(), -5.0, 0.02);
    const std::string remarks = json["remarks"].dump();
    EXPECT_NE(remarks.find("No unit was stated for t; it is read in s."), std::string::npos) << remarks;
    EXPECT_EQ(remarks.find("stated for phi"), std::string::npos) << "rad states it: " << remarks;
  }
  EXPECT_FALSE(content(folder / "out/identify/run/report.html").empty());
}

// The example of docs/identification.md: in the order of that page the first lines of the log, the command, what it
// prints, and what it keeps.
std::vector<std::string> blocks_of_the_example() {
  const std::string page = content(std::string{FANTAIL_TEST_SOURCE} + "/docs/identification.md");
  std::vector<std::string> blocks;
  const std::string fence = "```\n";
  std::size_t at = page.find("## A log of another logger");
  while (blocks.size() < 4 && (at = page.find("```", at)) != std::string::npos) {
    const std::size_t begin = page.find('\n', at) + 1;
    const std::size_t end = page.find(fence, begin);
    blocks.push_back(page.substr(begin, end - begin));
    at = end + fence.size();
  }
  return blocks;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream{text};
  for (std::string line; std::getline(stream, line);) {
    all.push_back(line);
  }
  return all;
}

TEST(IdentifyForeignLog, TheManualsLogOfAnotherLoggerGivesWhatTheManualSays) {
  const std::vector<std::string> blocks = blocks_of_the_example();
  ASSERT_EQ(blocks.size(), 4U);
  const Folder folder;
  std::string log = "t,p,u,battery\n";
  for (const Row& r : tunnel_rows(shaken)) {
    log += fmt::format("{:.0f},{:.6f},{:.4f},7.9\n", 1000.0 * r.time_s, r.rate_deg_s / degrees, r.canard_deg);
  }
  EXPECT_TRUE(log.starts_with(blocks[0])) << log.substr(0, 100);
  folder.write("run7.csv", log);
  std::istringstream command{blocks[1]};
  Words words{std::istream_iterator<std::string>{command}, {}};
  ASSERT_EQ(words.front(), "./dev");
  words.erase(words.begin());
  std::erase(words, "\\");  // at the end of a line
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const std::string& line : lines(blocks[2])) {
    EXPECT_TRUE(line == "..." || outcome.out.find(line) != std::string::npos) << line << "\n" << outcome.out;
  }
  EXPECT_EQ(content(folder / "run7.csv.columns.toml"), blocks[3]);
  const Outcome again = fantail(
      {"identify", "run7.csv", "--speed", "22", "--inertia", "0.00393", "--area", "5.0265e-5", "--elevation", "1400"},
      {.working_folder = folder.path()});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("Columns from run7.csv.columns.toml"), std::string::npos) << again.out;
}

TEST(IdentifyForeignLog, RefusesAMapThatItWouldHaveToGuessAt) {
  const Words rocket{"--speed", "22", "--vehicle", "tasha3_tunnel"};
  const auto refuse = [&](Words more, int code, const std::vector<std::string>& said) {
    Words words{"identify", "a.csv"};
    words.insert(words.end(), rocket.begin(), rocket.end());
    words.insert(words.end(), more.begin(), more.end());
    Refusal({{"a.csv", "t,p,u\n0,1,2\n1,1,2\n"}}, words, code, said);
  };
  refuse({"--columns", "time=t:sec"}, 78, {"\"sec\" is not a unit of time", "s, ms, us"});
  refuse({"--columns", "time=t:s", "--column", "time_s=t"}, 64, {"time_s", "--column"});
  refuse({"--columns", "time=tt:s,roll_rate=p:rad/s,canard=u:deg"}, 65, {"no column tt", "t, p, u"});
  refuse({"--save-columns"}, 64, {"--save-columns"});
  refuse({"--columns", "time=t:s,roll_rate=p:rad/s,canard=u:deg", "--elevation", "20000"}, 64, {"--elevation"});
}

}  // namespace
}  // namespace fantail::test
