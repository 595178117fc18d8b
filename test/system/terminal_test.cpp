// SPDX-License-Identifier: MIT
// What a person sees: standard output is a terminal.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "system/on_terminal.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

std::string in_a_pipe(const Words& words, const Folder& folder, const Variables& variables) {
  return fantail(words, {.working_folder = folder.path(), .prepare = surroundings(variables)}).out;
}

// Names of files and folders, and what stands in them.
TEST(Terminal, HearsNoControlCharactersOfAnyFile) {
  const Folder folder;
  const std::string hostile = "a\\u001b[31mb\\u0007c\\nGo: yes\\u009b2J";
  const std::string row = "time_s,phase,roll_angle_deg,roll_rate_deg_s\n0,safe,0,0\n1,safe,0,0\n";
  folder.write("day/flight.csv", row);
  folder.write("day/summary.json", "{\"scenario\": \"" + hostile + "\", \"vehicle\": \"" + hostile +
                                       "\", \"notes\": [\"" + hostile + "\"], \"changes\": [\"" + hostile +
                                       "\"], \"why_not_armed\": \"" + hostile + "\"}");
  const std::string name = "x\033[31my\a\nGo: yes";
  folder.write(name + ".csv", row);
  folder.write(name + ".toml",
               "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\nassumed = [\"" + hostile + "\"]\n");
  for (const Words& words :
       {Words{"report", "day"}, Words{"report", name + ".csv"}, Words{"report", name + ".csv", name + ".csv"},
        Words{"compare", name + ".csv", "day"}, Words{"fly", name + ".toml"}, Words{"fly", name}, Words{name},
        Words{"report", name}, Words{"predict", name + ".toml", "--runs", "2"},
        Words{"campaign", name + ".toml", "--runs", "2"}, Words{"identify", name + ".csv"},
        Words{"listen", name + ".csv"}, Words{"plan", "check", name}, Words{"airframe", name},
        Words{"fly", "--set", name + "=1"}, Words{"log", "info", name}}) {
    const Outcome outcome = fantail(words, {.working_folder = folder.path()});
    for (const std::string& said : {outcome.out, outcome.err}) {
      EXPECT_EQ(said.find_first_of("\033\a"), std::string::npos) << words[0] << ": " << said;
      EXPECT_EQ(said.find("\u009b"), std::string::npos) << words[0] << ": " << said;
      EXPECT_FALSE(("\n" + said).find("\nGo: yes") != std::string::npos) << words[0] << ": " << said;
    }
  }
}

TEST(Terminal, AVerdictIsColouredWhereNobodyObjects) {
  const Folder folder;
  const Words held{"fly"};
  EXPECT_NE(on_terminal(held, folder).out.find("\r\n\033[32mHeld\033[0m: Steady"), std::string::npos);
  EXPECT_NE(on_terminal({"fly", "tasha3_launch1"}, folder).out.find("\r\n\033[31mNot held\033[0m: "),
            std::string::npos);
  EXPECT_NE(on_terminal({"predict", "tasha3_launch1", "--runs", "8"}, folder).out.find("\033[31mNo go\033[0m: "),
            std::string::npos);
  EXPECT_FALSE(has_escape(on_terminal(held, folder, 80, {{"NO_COLOR", "1"}, {"TERM", "xterm"}}).out));
  EXPECT_FALSE(has_escape(on_terminal(held, folder, 80, {{"NO_COLOR", nullptr}, {"TERM", "dumb"}}).out));
  EXPECT_FALSE(has_escape(on_terminal({"fly", "--color", "never"}, folder).out));
}

TEST(Pipe, HasTheSameBytesWhateverTerminalTheSurroundingsSpeakOf) {
  const Folder folder;
  for (const Words& words : {Words{"fly"}, Words{"plan", "show", "tasha3_launch2"}, Words{"airframe", "tasha3_launch2"},
                             Words{"fly", "--help"}, Words{"campaign", "tasha3_launch2", "--runs", "4"}}) {
    const std::string without = in_a_pipe(words, folder, {{"TERM", nullptr}, {"COLUMNS", nullptr}});
    EXPECT_EQ(in_a_pipe(words, folder, {{"TERM", "xterm-256color"}, {"COLUMNS", "40"}}), without) << words.front();
    EXPECT_FALSE(has_escape(without)) << words.front();
    EXPECT_NE(without, "") << words.front();
  }
}

TEST(Pipe, HasColoursForWhoAsksForThemAndIsNotWrappedForThat) {
  const Folder folder;
  std::string coloured = in_a_pipe({"fly", "--color=always"}, folder, {{"NO_COLOR", "1"}});
  for (const std::string escape : {"\033[32m", "\033[0m"}) {
    const std::size_t place = coloured.find(escape);
    ASSERT_NE(place, std::string::npos) << coloured;
    coloured.erase(place, escape.size());
  }
  EXPECT_EQ(coloured, in_a_pipe({"fly"}, folder, {}));
}

TEST(Color, TakesThreeWords) {
  const Outcome outcome = fantail({"plan", "show", "--color", "red"});
  EXPECT_EQ(outcome.exit_code, 64);
  expect_said(outcome.err, {"--color: red not in {auto,always,never}"});
}

TEST(Watch, DrawsOverTheLastPictureAndClearsNoScreen) {
  const Folder folder;
  const std::string url = "file://" + (folder / "flight.lcmlog");
  ASSERT_EQ(fantail({"fly", "--lcm", url}, {.working_folder = folder.path()}).exit_code, 0);
  const std::string drawn = on_terminal({"watch", "--lcm", url, "--for", "1.5"}, folder).out;
  EXPECT_TRUE(drawn.starts_with("\033[?1049h\033[?2026h")) << drawn.substr(0, 200);
  EXPECT_EQ(drawn.find("\033[2J"), std::string::npos);
  std::size_t frames = 0;
  for (std::size_t at = 0; (at = drawn.find("\033[H", at)) != std::string::npos; ++at) {
    ++frames;
  }
  EXPECT_GE(frames, 4U);
  const std::size_t left = drawn.find("\033[?1049l");
  ASSERT_NE(left, std::string::npos) << "the alternate screen";
  expect_said(drawn.substr(left), {"link, last "});  // the last picture stays
  expect_said(drawn, {"phase \033["});
}

TEST(Watch, GivesTheShellItsScreenWhileItIsStopped) {
  const Folder folder;
  const std::string url = "file://" + (folder / "flight.lcmlog");
  ASSERT_EQ(fantail({"fly", "--lcm", url}, {.working_folder = folder.path()}).exit_code, 0);
  Screen screen{80};
  std::jthread person;
  const auto stop_and_go_on = [&person](int process, const std::string& drawn) {
    if (!person.joinable() && drawn.find("link, last ") != std::string::npos) {
      kill(process, SIGTSTP);
      person = std::jthread{[process](const std::stop_token& ended) {
        while (!ended.stop_requested()) {
          std::this_thread::sleep_for(std::chrono::milliseconds{50});
          kill(process, SIGCONT);
        }
      }};
    }
  };
  const Outcome outcome =
      screen.fantail({"watch", "--lcm", url, "--for", "1.5"},
                     {.working_folder = folder.path(), .prepare = surroundings(plain)}, stop_and_go_on);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::size_t left = outcome.out.find("\033[?1049l");
  const std::size_t back = outcome.out.find("\033[?1049h", left);
  ASSERT_NE(back, std::string::npos) << "left at " << left;
  expect_said(outcome.out.substr(back), {"\033[?1049l"});  // and at the end
}

TEST(Watch, IsLinesOnATerminalThatCannotDraw) {
  const Folder folder;
  const std::string url = "file://" + (folder / "flight.lcmlog");
  ASSERT_EQ(fantail({"fly", "--lcm", url}, {.working_folder = folder.path()}).exit_code, 0);
  const Outcome outcome = on_terminal({"watch", "--lcm", url, "--for", "1.1"}, folder, 80, {{"TERM", "dumb"}});
  EXPECT_FALSE(has_escape(outcome.out)) << outcome.out;
  expect_said(outcome.out, {"link: "});
}

}  // namespace
}  // namespace fantail::test
