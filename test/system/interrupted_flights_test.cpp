// SPDX-License-Identifier: MIT
// Every verb that flies many flights goes on after a Ctrl-C, and what it writes in the end is what it would have
// written.
#include <csignal>
#include <filesystem>
#include <thread>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

struct Question {
  const char* name;
  Words words;
  const char* parts;   ///< where it keeps what it has flown
  const char* result;  ///< a file that must have the same bytes
  bool keeps_parts = false;
};

class InterruptedFlights : public testing::TestWithParam<Question> {};

TEST_P(InterruptedFlights, GoOnWhenTheSameCommandIsGivenAgain) {
  const Folder folder;
  const auto into = [&](const char* out) {
    Words words = GetParam().words;
    words.insert(words.end(), {"--threads", "1", "--out", folder / out});
    return words;
  };
  const fs::path parts = fs::path{folder / "all"} / GetParam().parts;
  const auto is_begun = [&] {
    std::error_code ignored;
    for (const auto& file : fs::directory_iterator{parts, ignored}) {
      if (file.path().extension() == ".part") {
        return true;
      }
    }
    return false;
  };
  std::string second;
  const auto interrupt = [&](int process) {
    for (int i = 0; i < 12'000 && !is_begun(); ++i) {  // it may have failed
      std::this_thread::sleep_for(5ms);
    }
    second = fantail(into("all"), {.working_folder = folder.path()}).err;
    kill(process, SIGINT);
  };
  const Outcome outcome = fantail(into("all"), {.working_folder = folder.path(), .meanwhile = interrupt});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("interrupted; finished flights are kept in " + (folder / "all") +
                             ", and the same command goes on from there"),
            std::string::npos)
      << outcome.err;
  expect_said(second, {"another run of Fantail is at work in this folder"});
  EXPECT_FALSE(fs::exists(fs::path{folder / "all"} / GetParam().result));
  EXPECT_TRUE(is_begun());
  const auto first_part = fs::directory_iterator { parts } -> path();
  const Outcome rest = fantail(into("all"), {.working_folder = folder.path()});
  const Outcome whole = fantail(into("whole"), {.working_folder = folder.path()});
  EXPECT_EQ(rest.exit_code, whole.exit_code) << rest.err;
  EXPECT_EQ(content(fs::path{folder / "all"} / GetParam().result),
            content(fs::path{folder / "whole"} / GetParam().result));
  EXPECT_EQ(is_begun(), GetParam().keeps_parts);
}

INSTANTIATE_TEST_SUITE_P(
    Of, InterruptedFlights,
    testing::Values(
        Question{"campaign", {"campaign", "--runs", "192"}, "parts", "runs.csv.gz"},
        Question{"detection",
                 {"campaign", "detection", "--kind", "launch", "--launches", "4096"},
                 "parts",
                 "summary.json",
                 true},
        Question{"faults",
                 {"campaign", "faults", "tasha3_launch2", "--device", "arm_switch", "--every", "1000"},
                 "parts",
                 "summary.json",
                 true},
        Question{"hardover", {"campaign", "hardover", "--step", "2"}, "hardover_parts", "hardover.json"},
        Question{
            "rare", {"campaign", "rare", "--flights", "100", "--share", "apogee_m>=340"}, "rare_parts", "rare.json"},
        Question{"predict", {"predict", "tasha3_launch2", "--runs", "100"}, "predict_parts", "predict.json"}),
    [](const auto& one) { return std::string{one.param.name}; });

}  // namespace
}  // namespace fantail::test
