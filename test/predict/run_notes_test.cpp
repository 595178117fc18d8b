// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "predict/run.hpp"

namespace fantail::predict {
namespace {

using Notes = std::vector<std::string>;

Notes notes_of_runs(const std::vector<Notes>& each) {
  std::vector<struct Run> runs(each.size());
  for (std::size_t i = 0; i < each.size(); ++i) {
    runs[i].notes = each[i];
  }
  return notes_of(runs);
}

TEST(RunNotes, SaysOnceWhatAllRunsSay) {
  EXPECT_EQ(notes_of_runs({{"The guide leans."}, {"The guide leans."}}), Notes{"The guide leans."});
  EXPECT_EQ(notes_of_runs({{}, {}}), Notes{});
}

TEST(RunNotes, SaysInHowManyRunsAndWhoseTheFiguresAre) {
  EXPECT_EQ(notes_of_runs({{"Fault."}, {"At 250.0 m/s, Mach 0.73.", "Fault."}, {"Fault.", "At 9 m/s, Mach 0.7."}}),
            (Notes{"Fault.", "In 2 of 3 runs (figures of run 1): At 250.0 m/s, Mach 0.73."}));
  EXPECT_EQ(notes_of_runs({{"At 250 m/s."}, {"At 251 m/s."}}),
            Notes{"In all of 2 runs (figures of run 0): At 250 m/s."});
  EXPECT_EQ(notes_of_runs({{"Fault of canard 1.", "Fault of canard 2."}, {"Fault of canard 1.", "Fault of canard 2."}}),
            (Notes{"Fault of canard 1.", "Fault of canard 2."}))
      << "two notes, in two runs and not in four";
  EXPECT_EQ(notes_of_runs({{}, {"Weak."}}), Notes{"In 1 of 2 runs: Weak."});
}

}  // namespace
}  // namespace fantail::predict
