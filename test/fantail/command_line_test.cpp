// SPDX-License-Identifier: MIT
#include "fantail/command_line.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fantail::tool {
namespace {

using Words = std::vector<std::string>;

struct Options {
  std::string scenario = "tasha3_launch2";
  Words plans;
  std::optional<double> swirl_deg;
  double margin_deg = 45.0;
  bool is_other = false;
  bool both_well = false;
  unsigned threads = 0;
};

Asked last_asked;

void fill(const Verb& verb) {
  auto options = std::make_shared<Options>();
  verb.option("SCENARIO", options->scenario, "").belongs_to_command();
  verb.option("--plan", options->plans, "").one_word_each_time().changes_result();
  verb.option("--swirl", options->swirl_deg, "").changes_result();
  verb.option("--margin", options->margin_deg, "").changes_result();
  verb.flag("--other-vehicle", options->is_other, "").belongs_to_command();
  verb.flag("--both-well", options->both_well, "").changes_result();
  add_threads_option(verb, options->threads);
  verb.action([options, verb] { last_asked = verb.asked(); });
}

struct Case {
  Words typed;
  std::string command;
  Words changes;
};

TEST(Asked, HasWhatMakesAnotherResultAndTheCommandThatMakesItAgain) {
  for (const auto& [typed, command, changes] :
       std::vector<Case>{{{"--threads", "2"}, "fantail try tasha3_launch2", {}},
                         {{"--margin", "45.0", "my rocket.toml"}, "fantail try 'my rocket.toml'", {}},
                         {{"--swirl=-2.0"}, "fantail try tasha3_launch2 --swirl -2", {"swirl=-2"}},
                         {{"--both-well", "--other-vehicle"},
                          "fantail try tasha3_launch2 --other-vehicle --both-well",
                          {"both-well"}},
                         {{"--margin", "50", "--plan", "a", "--plan", "b"},
                          "fantail try tasha3_launch2 --plan a --plan b --margin 50",
                          {"plan=a", "plan=b", "margin=50"}}}) {
    read_command_line("try", "", fill, typed);
    EXPECT_EQ(last_asked.command, command);
    EXPECT_EQ(last_asked.changes, changes) << command;
  }
}

}  // namespace
}  // namespace fantail::tool
