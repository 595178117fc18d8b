// SPDX-License-Identifier: MIT
// A flight whose processor is reset, as a person flies it and reads it.

#include "figures.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

struct ResumedFlight : testing::Test {
  Folder folder;
  Outcome run(const std::vector<std::string>& arguments) {
    return fantail(arguments, {.working_folder = folder.path()});
  }
  void fly(const std::string& more) { fly_with_fault("kind = \"reset\"\nfrom_s = 3\n" + more); }
  void fly_with_fault(const std::string& fault) {
    folder.write("r.toml",
                 "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[disturbance]\ntimes_s = [0]\n"
                 "angles_deg = [-4.9]\n[[faults]]\n" +
                     fault);
    const Outcome outcome = run({"fly", "r.toml", "--out", "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    said = outcome.out;
  }
  std::string said;
};

const std::string gap =
    "The processor was reset (watchdog): no tick is on record from 2.986 s to 3.047 s, and then the "
    "flight was resumed.";

TEST_F(ResumedFlight, SaysSoWhenItIsFlownAndWhenItIsReported) {
  fly("");
  EXPECT_TRUE(says(said, gap)) << said;
  EXPECT_TRUE(says(said, "Fault: reset (watchdog) at 3 s after ignition; no tick for 0.06 s, backup memory kept."));
  EXPECT_TRUE(says(content(folder / "out/report.html"), gap));
  const Outcome report = run({"report", "out", "--out", "again"});
  EXPECT_EQ(report.exit_code, 0);
  EXPECT_TRUE(says(report.out, gap)) << report.out;
}

TEST_F(ResumedFlight, ItsLogHoldsTwoPartsThatBothReplayExactlyAndAreReportedAsOne) {
  fly("");
  const Outcome info = run({"log", "info", "out"});
  EXPECT_EQ(info.exit_code, 0) << info.out;
  EXPECT_TRUE(says(info.out, "2 flights"));
  EXPECT_TRUE(says(info.out, "ends early: the processor was reset, and flight 2 is the rest")) << info.out;
  EXPECT_TRUE(says(info.out, "the flight was resumed after a reset (watchdog), for the first time"));
  EXPECT_TRUE(says(info.out, "seconds from lift-off")) << info.out;
  for (const char* const part : {"1", "2"}) {
    const Outcome replay = run({"replay", "out", "--flight", part});
    EXPECT_EQ(replay.exit_code, 0);
    EXPECT_TRUE(says(replay.out, "every output byte as recorded")) << replay.out;
  }
  const Outcome report = run({"report", "out/flight.ftl", "--out", "again"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_TRUE(says(report.out,
                   "The processor was reset (watchdog): no tick is on record from 2.976 s to 3.092 s, and "
                   "then the flight was resumed."))
      << report.out;
}

TEST_F(ResumedFlight, EachPartOfItsLogSaysWhatItsTimesCountFrom) {
  fly_with_fault("kind = \"reset\"\nfrom_s = 0.3\n");
  const Outcome info = run({"log", "info", "out"});
  EXPECT_TRUE(says(info.out, "seconds from the beginning of the record, which does not show lift-off")) << info.out;
  EXPECT_TRUE(says(info.out, "seconds from lift-off")) << info.out;
}

// A gap that lasts beyond apogee, and one that lasts beyond the end of the run.
TEST_F(ResumedFlight, OneOfWhichNothingIsOnRecordAnyMoreIsNotHeld) {
  fly("gap_s = 7.38\n");
  EXPECT_TRUE(says(said, "Control ended at 2.99 s, 7.37 s before apogee")) << said;
  EXPECT_TRUE(says(said, "After that the rocket turned by up to 7")) << said;
  fly("gap_s = 10\n");
  EXPECT_TRUE(says(said, "Control ended at 2.99 s, 7.37 s before apogee")) << said;
  EXPECT_TRUE(says(content(folder / "out/summary.json"), "\"outcome\": \"cut_short\"")) << said;
}

TEST_F(ResumedFlight, ARunInTheTunnelThatIsNotResumedComesToItsEnd) {
  folder.write("t.toml",
               "vehicle = \"tasha3_tunnel\"\nplan = \"tunnel_steps\"\n[environment]\nsurroundings = \"tunnel\"\n"
               "[[faults]]\nkind = \"reset\"\nfrom_s = 3\nmemory = \"lost\"\n");
  const Outcome outcome = run({"fly", "t.toml", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(says(outcome.out, "the flight was not resumed")) << outcome.out;
}

TEST_F(ResumedFlight, OneThatIsNotResumedEndsWithTheReset) {
  fly("cause = \"brown_out\"\n");
  EXPECT_TRUE(says(said,
                   "Control ended at 2.99 s, 7.37 s before apogee: the processor was reset, and the flight was not "
                   "resumed. After that the rocket turned by up to"))
      << said;
  const Outcome info = run({"log", "info", "out"});
  EXPECT_TRUE(says(info.out, "one flight"));
  EXPECT_TRUE(says(info.out, "the simulation ended or reset the processor, or the file was cut off"));
}

// Nothing resets it, so the phase is still Controlling when it goes on.
TEST_F(ResumedFlight, OneWhoseProcessorStoodStillWasControlledUntilThen) {
  const std::string dead = "kind = \"device\"\ndevice = \"processor\"\nbehaviour = \"dead\"\nfrom_s = 1.5\nuntil_s = ";
  const std::string ended = "Control ended at 1.49 s, 8.87 s before apogee: ";
  fly_with_fault(dead + "9\n");
  EXPECT_TRUE(says(said, ended + "a timing fault, seen at 8.99 s. After that the rocket turned by up to")) << said;
  EXPECT_TRUE(says(said, " No tick is on record from 1.486 s to 8.987 s.")) << said;
  EXPECT_TRUE(says(said, "control lasted only 0.85 s")) << said;
  const json::Value summary = json::parse(content(folder / "out/summary.json"));
  EXPECT_EQ(summary["events"]["control_end_s"], 1.486);
  EXPECT_NEAR(summary["ended_before_apogee_s"].number(), 8.874, 1e-9);
  const std::string page = content(folder / "out/report.html");
  EXPECT_TRUE(says(page, "<td>control ends</td><td>with the last tick before 8.987 s</td>"));
  EXPECT_TRUE(says(run({"report", "out", "--out", "again"}).out, ended + "a timing fault, seen at 8.99 s."));
  // On its own clock, which begins where the log shows the first thrust.
  const Outcome of_log = run({"report", "out/flight.ftl", "--out", "again"});
  EXPECT_TRUE(says(of_log.out, "Control ended at 1.48 s: a timing fault, seen at 8.98 s.")) << of_log.out;
  EXPECT_TRUE(says(of_log.out, " No tick is on record from 1.480 s to 8.981 s.")) << of_log.out;

  fly_with_fault(dead + "600\n");
  EXPECT_TRUE(says(said, ended + "the processor stopped then.")) << said;
  EXPECT_TRUE(says(said, " No tick is on record from 1.486 s on.")) << said;
}

}  // namespace
}  // namespace fantail::test
