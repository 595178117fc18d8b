// SPDX-License-Identifier: MIT
// Every verb that has --json says by the same three members whether it was yes, in words, and how it was made.

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

json::Value said_by(const Words& words, const Folder& folder) {
  const Outcome outcome = fantail(words, {.working_folder = folder.path()});
  SCOPED_TRACE(outcome.err);
  json::Value said = json::parse(outcome.out);
  const std::string answer = said["answer"].text();
  EXPECT_TRUE((std::set<std::string>{"yes", "no", "undecided", "none"}.contains(answer))) << answer;
  EXPECT_NE(said["sentence"].text(), "");
  EXPECT_EQ(said["made"]["command"].text().find("fantail " + words.front()), 0U) << said["made"];
  EXPECT_EQ(said["made"]["command"].text().find("--json"), std::string::npos);
  EXPECT_NE(said["made"]["version"].text(), "");
  if (outcome.exit_code != 0) {
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_NE(answer, "yes") << "a yes with exit code 1";
  }
  return said;
}

TEST(Answer, OfEveryVerbIsAMemberOfItsJson) {
  const Folder folder;
  EXPECT_EQ(said_by({"fly", "tasha3_launch2", "--json"}, folder)["answer"], "yes");
  EXPECT_EQ(said_by({"fly", "tasha3_launch1", "--json"}, folder)["answer"], "no");
  const std::string flight = "out/tasha3_launch2";
  for (const char* const tunnel :
       {"tunnel_steps", "tunnel_swirl_with", "tunnel_swirl_without", "tunnel_flow", "tunnel_stability"}) {
    (void)said_by({"fly", tunnel, "--json"}, folder);
  }
  EXPECT_EQ(said_by({"report", flight, "--json"}, folder)["answer"], "yes");
  EXPECT_EQ(said_by({"report", flight, "out/tasha3_launch1", "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"compare", flight, flight, "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"compare", flight, flight, "--require-angle", "1", "--json"}, folder)["answer"], "yes");
  EXPECT_EQ(said_by({"compare", flight, "out/tasha3_launch1", "--require-angle", "1", "--json"}, folder)["answer"],
            "no");
  EXPECT_EQ(said_by({"replay", flight, "--json"}, folder)["answer"], "yes");
  EXPECT_EQ(said_by({"replay", flight, "--set", "controller.canard_limit_deg=4", "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"log", "info", flight, "--json"}, folder)["answer"], "yes");
  (void)said_by({"identify", flight, "--json"}, folder);
  (void)said_by({"identify", flight, "out/tasha3_launch1", "--shared", "alpha,beta", "--json"}, folder);
  (void)said_by({"identify", flight, "--validate", "out/identify/tasha3_launch2", "--json"}, folder);
  (void)said_by(
      {"listen", flight + "/flight.csv", "--columns", "time=time_s:s,axial=specific_force_m_s2:m/s2", "--json"},
      folder);
  (void)said_by({"tunnel", "steps", "out/tunnel_steps", "--json"}, folder);
  (void)said_by({"tunnel", "swirl", "out/tunnel_swirl_without", "out/tunnel_swirl_with", "--json"}, folder);
  (void)said_by({"tunnel", "flow", "out/tunnel_flow", "--json"}, folder);
  EXPECT_EQ(said_by({"tunnel", "stability", "out/tunnel_stability", "--json"}, folder)["answer"], "yes");
  EXPECT_EQ(said_by({"airframe", "tasha3_launch2", "--json"}, folder)["made"]["inputs"][0]["file"],
            "tasha3_launch2.toml");
  EXPECT_EQ(said_by({"brief", "tasha3_launch2", "--step", "5", "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"plan", "check", "tasha3_launch2", "--json"}, folder)["answer"], "yes");
  EXPECT_EQ(said_by({"plan", "show", "tasha3_launch2", "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"plan", "compile", "tasha3_launch2", "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"predict", "tasha3_launch1", "--runs", "4", "--json"}, folder)["answer"], "no");
  EXPECT_EQ(said_by({"tune", "tasha3_launch1", "--flights", "2", "--json"}, folder)["answer"], "no");
  EXPECT_EQ(said_by({"campaign", "--runs", "4", "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"campaign", "--runs", "8", "--at-least", "1", "--json"}, folder)["answer"], "yes");
  EXPECT_EQ(said_by({"campaign", "faults", "--fault", "silent_3ms", "--every", "2000", "--json"}, folder)["answer"],
            "yes");
  EXPECT_EQ(said_by({"campaign", "detection", "--kind", "launch", "--launches", "4", "--at-most", "99", "--json"},
                    folder)["answer"],
            "yes");
  EXPECT_EQ(said_by({"campaign", "hardover", "--step", "9", "--json"}, folder)["answer"], "none");
  EXPECT_EQ(said_by({"campaign", "rare", "--flights", "100", "--share", "apogee_m>=440", "--at-most", "0.9", "--json"},
                    folder)["answer"],
            "yes");
}

}  // namespace
}  // namespace fantail::test
