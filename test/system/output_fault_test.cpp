// SPDX-License-Identifier: MIT
#include <cstdio>

#include <sys/resource.h>
#include <unistd.h>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

using Words = std::vector<std::string>;

void expect_output_fault(const Outcome& outcome, const std::string& said) {
  EXPECT_EQ(outcome.exit_code, 74) << outcome.err << "signal " << outcome.signal;
  EXPECT_TRUE(outcome.err.starts_with("fantail: ")) << outcome.err;
  expect_said(outcome.err, {said});
}

std::function<void()> limit_files_to(rlim_t bytes) {
  return [bytes] {
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  };
}

// The kernel refuses new files in /proc to everybody, root included, whom permission bits would not stop.
TEST(OutputFolder, ThatCannotBeMadeIsAnOutputFault) {
  const Outcome outcome = fantail({"fly", "--out", "/proc/fantail"});
  expect_output_fault(outcome, "/proc/fantail: ");
  EXPECT_EQ(outcome.out, "");
}

TEST(OutputFolder, ThatIsAFileIsAnOutputFault) {
  const Folder folder;
  const std::string file = folder.write("taken", "mine");
  expect_output_fault(fantail({"fly", "--out", file}), "taken: Not a directory");
  expect_output_fault(fantail({"fly", "--out", file + "/below"}), "taken/below: Not a directory");
  EXPECT_EQ(content(file), "mine");
  EXPECT_EQ(folder.listing(), Words{"taken"});
}

TEST(OutputFolder, WithAFolderInThePlaceOfAResultKeepsEverything) {
  const Folder folder;
  folder.write("out/report.html/mine", "mine");
  folder.write("out/flight.csv", "earlier");
  const Words before = folder.listing();
  expect_output_fault(fantail({"fly", "--out", folder / "out"}), "report.html");
  EXPECT_EQ(folder.listing(), before);
  EXPECT_EQ(content(folder / "out/flight.csv"), "earlier");
}

// flight.csv is some megabytes and report.html some hundred thousand bytes: each limit stops another write.
class FullDisk : public testing::TestWithParam<rlim_t> {};

TEST_P(FullDisk, LeavesNothingHalfWrittenAndKeepsAnEarlierResult) {
  const Folder folder;
  expect_output_fault(fantail({"fly", "--out", folder / "new/out"}, {.prepare = limit_files_to(GetParam())}),
                      "flight.csv: File too large");
  EXPECT_TRUE(folder.listing().empty());

  EXPECT_EQ(fantail({"fly", "--out", folder / "out"}).exit_code, 0);
  const Words before = folder.listing();
  const std::string csv = content(folder / "out/flight.csv");
  expect_output_fault(fantail({"fly", "--seed", "2", "--out", folder / "out"}, {.prepare = limit_files_to(GetParam())}),
                      "flight.csv: File too large");
  EXPECT_EQ(folder.listing(), before);
  EXPECT_EQ(content(folder / "out/flight.csv"), csv);
}

INSTANTIATE_TEST_SUITE_P(EachSize, FullDisk, testing::Values(0, 1, 4096, 2'000'000),
                         [](const auto& one) { return std::to_string(one.param) + "Bytes"; });

// A real full disk: 3 MB that only this test sees. Where a new name space is forbidden (some containers), the limits
// above are all there is, and this says so.
TEST(FullDisk, OfARealFileSystemLeavesNothingBehind) {
  const Folder folder;
  const std::string script =
      "mount -t tmpfs -o size=3m none \"$1\" && cd \"$1\" && mkdir out && echo earlier >out/summary.json && "
      "{ \"$2\" fly --out out; echo code $?; find . -type f; cat out/summary.json; }";
  if (run("unshare", {"-rm", "mount", "-t", "tmpfs", "none", folder.path().string()}).exit_code != 0) {
    std::puts("no new name space here: tested with file-size limits only");
    return;
  }
  const Outcome outcome = run("unshare", {"-rm", "sh", "-c", script, "sh", folder.path().string(), fantail_path()});
  EXPECT_EQ(outcome.out, "code 74\n./out/summary.json\nearlier\n");
  expect_said(outcome.err, {"flight.csv: No space left on device"});
}

TEST(PlanBlock, OnAFullDiskIsNotHalfWritten) {
  const Folder folder;
  const Outcome outcome =
      fantail({"plan", "compile", "tunnel_steps"}, {.working_folder = folder.path(), .prepare = limit_files_to(10)});
  expect_output_fault(outcome, "tunnel_steps.ftpl");
  EXPECT_TRUE(folder.listing().empty());
}

/// Commands that print, each with a name.
struct Printing {
  const char* name;
  Words words;
};

class StandardOutput : public testing::TestWithParam<Printing> {};

TEST_P(StandardOutput, ThatIsFullIsAnOutputFault) {
  const Folder folder;
  expect_output_fault(
      fantail(GetParam().words, {.working_folder = folder.path(), .prepare = redirect(STDOUT_FILENO, "/dev/full")}),
      "standard output");
}

TEST_P(StandardOutput, ThatIsClosedIsAnOutputFault) {
  const Folder folder;
  expect_output_fault(fantail(GetParam().words, {.working_folder = folder.path(), .prepare = [] { close(1); }}),
                      "standard output");
}

TEST_P(StandardOutput, ThatNobodyReadsAnyMoreEndsTheProgramQuietlyWithTheCodeOfABrokenPipe) {
  const Folder folder;
  const auto nobody_reads = [] {
    int ends[2];
    if (pipe(ends) == 0) {
      close(ends[0]);
      dup2(ends[1], STDOUT_FILENO);
      close(ends[1]);
    }
  };
  const Outcome outcome = fantail(GetParam().words, {.working_folder = folder.path(), .prepare = nobody_reads});
  EXPECT_EQ(outcome.exit_code, 141) << "128 and SIGPIPE, as a shell has it";
  EXPECT_EQ(outcome.err, "");
}

TEST_P(StandardOutput, BeyondAFileSizeLimitIsAnOutputFaultAndNoSignal) {
  const Folder folder;
  const auto full = [file = folder / "printed"] {
    limit_files_to(0)();
    redirect(STDOUT_FILENO, file)();
  };
  // The results of a flight are files too, and then they are what is said to be too large.
  expect_output_fault(fantail(GetParam().words, {.working_folder = folder.path(), .prepare = full}), "");
}

INSTANTIATE_TEST_SUITE_P(EachVerb, StandardOutput,
                         testing::Values(Printing{"Fly", {"fly"}}, Printing{"FlyJson", {"fly", "--json"}},
                                         Printing{"PlanShow", {"plan", "show", "tasha3_launch2"}},
                                         Printing{"PlanShowJson", {"plan", "show", "tasha3_launch2", "--json"}},
                                         Printing{"PlanCheck", {"plan", "check", "tasha3_launch2"}},
                                         Printing{"PlanCompile", {"plan", "compile", "tasha3_launch2"}},
                                         Printing{"Help", {"--help"}}, Printing{"FlyHelp", {"fly", "--help"}},
                                         Printing{"Version", {"--version"}}),
                         [](const auto& one) { return one.param.name; });

// The exit code is all that is left, so it must be right.
TEST(StandardError, ThatTakesNothingDoesNotChangeTheExitCode) {
  const Folder folder;
  for (const auto& prepare : {redirect(STDERR_FILENO, "/dev/full"), std::function<void()>{[] { close(2); }}}) {
    const Surroundings surroundings{.working_folder = folder.path(), .prepare = prepare};
    EXPECT_EQ(fantail({"fly", "nope"}, surroundings).exit_code, 66);
    EXPECT_EQ(fantail({"fly", "--bogus"}, surroundings).exit_code, 64);
    EXPECT_EQ(fantail({"fly"}, surroundings).exit_code, 0);
  }
  EXPECT_EQ(fantail({"plan", "show", "tasha3_launch1"}, {.prepare = [] { close(0), close(1), close(2); }}).exit_code,
            74);
}

}  // namespace
}  // namespace fantail::test
