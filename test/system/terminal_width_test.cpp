// SPDX-License-Identifier: MIT
// How wide the lines are that a person sees.
#include <algorithm>
#include <iterator>
#include <sstream>

#include "system/on_terminal.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

// Columns of a line that has no colours.
std::size_t width(const std::string& line) {
  return static_cast<std::size_t>(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }));
}

// One word, which may be a command, or a part of one that goes on below.
bool is_unbreakable(const std::string& line) {
  std::string words = line.substr(line.find_first_not_of(' '));
  words.erase(words.ends_with(" \\") ? words.size() - 2 : words.size());
  return words.starts_with("fantail ") || words.find(' ') == std::string::npos;
}

// Lines that are too wide and could have been broken.
std::string too_wide(const std::string& text, std::size_t columns) {
  std::string found;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find("\r\n", begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    found += width(line) > columns && !is_unbreakable(line) ? line + "\n" : "";
    begin = end + 2;
  }
  return found;
}

constexpr unsigned short narrowest = 40;

// Of a flight in the folder: what people run after it, and what needs none.
std::vector<Words> usual_commands() {
  return {
      {"fly", "--out", "flight"},
      {"fly", "tasha3_launch1", "--out", "first"},
      {"fly", "tunnel_steps", "--out", "steps"},
      {"report", "flight/flight.ftl"},
      {"report", "flight", "flight/flight.ftl"},
      {"compare", "flight", "flight/flight.ftl", "--out", "compared"},
      {"compare", "flight", "first", "--require-angle", "0.1", "--out", "apart"},
      {"identify", "flight", "--method", "both", "--grid-alpha", "20:24:1", "--grid-beta", "8:10:0.5"},
      {"identify", "flight", "--shared", "alpha,beta", "--window", "1:4", "--window", "4:8"},
      {"log", "info", "flight"},
      {"replay", "flight"},
      {"replay", "flight", "--set", "controller.proportional_gain=0.3"},
      {"listen", "flight/flight.csv"},
      {"plan", "show", "tasha3_launch2"},
      {"plan", "check", "tasha3_launch1"},
      {"airframe", "tasha3_launch2"},
      {"tunnel", "steps", "steps"},
      {"tunnel", "flow", "steps"},
      {"predict", "tasha3_launch1", "--runs", "20"},
      {"campaign", "tasha3_launch2", "--runs", "12"},
      {"campaign", "hardover", "tasha3_launch2", "--step", "5", "--out", "hardover"},
      {"brief", "tasha3_launch2", "--step", "5"},
      {"campaign", "detection", "--plan", "tasha3_launch2", "--events", "20", "--launches", "20", "--out", "detection"},
      {"campaign", "faults", "--list"}};
}

// Each in the narrowest terminal, and what takes no time in one of the usual ones, too.
TEST(Terminal, NoLineIsWiderThanItButOneOfASingleWordOrCommand) {
  const Folder folder;
  unsigned short usual = 80;
  for (const Words& words : usual_commands()) {
    usual = usual == 80 ? 60 : 80;
    const bool takes_long = words[0] == "campaign" || words[0] == "predict" || words[0] == "tunnel";
    for (const unsigned short columns : takes_long ? std::vector{narrowest} : std::vector{narrowest, usual}) {
      const Outcome outcome = on_terminal(words, folder, columns, {{"TERM", "xterm"}, {"NO_COLOR", "1"}});
      ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << words.front() << ": " << outcome.err;
      EXPECT_EQ(too_wide(outcome.out, columns), "") << words.front() << " in " << columns;
      EXPECT_FALSE(has_escape(outcome.out)) << words.front();
      EXPECT_FALSE(outcome.out.empty()) << words.front();
    }
  }
}

TEST(Terminal, NoPictureOfWatchIsWiderThanIt) {
  const Folder folder;
  const std::string url = "file://" + (folder / "flight.lcmlog");
  ASSERT_EQ(fantail({"fly", "--lcm", url}, {.working_folder = folder.path()}).exit_code, 0);
  const std::string drawn = on_terminal({"watch", "--lcm", url, "--for", "0.5", "--color", "never"}, folder, 40).out;
  const std::size_t left = drawn.find("\033[?1049l");
  ASSERT_NE(left, std::string::npos);
  EXPECT_EQ(too_wide(drawn.substr(left + 8), 40), "");
}

TEST(Terminal, ThatDoesNotKnowItsWidthHasThatOfTheSurroundings) {
  const Folder folder;
  const auto width_with = [&](const char* columns) {
    const std::string help = on_terminal({"fly", "--help"}, folder, 0, {{"TERM", "xterm"}, {"COLUMNS", columns}}).out;
    return too_wide(help, 40).empty() ? 40 : too_wide(help, 80).empty() ? 80 : 0;
  };
  EXPECT_EQ(width_with("40"), 40);
  EXPECT_EQ(width_with(nullptr), 80);
  EXPECT_EQ(width_with("wide"), 80);
}

TEST(Terminal, NoHelpIsWiderThanIt) {
  const Folder folder;
  for (const char* verb : {"",
                           "new",
                           "airframe",
                           "plan",
                           "plan check",
                           "plan show",
                           "plan pack",
                           "tune",
                           "fly",
                           "predict",
                           "campaign",
                           "campaign detection",
                           "campaign faults",
                           "campaign hardover",
                           "brief",
                           "report",
                           "replay",
                           "identify",
                           "tunnel",
                           "tunnel flow",
                           "tunnel swirl",
                           "tunnel steps",
                           "tunnel stability",
                           "compare",
                           "listen",
                           "log",
                           "log info",
                           "log export",
                           "convert",
                           "paper",
                           "bench",
                           "bench limits",
                           "bench zero",
                           "bench axes",
                           "node",
                           "gateway",
                           "watch"}) {
    std::istringstream rest{verb};
    Words asked{std::istream_iterator<std::string>{rest}, {}};
    asked.emplace_back("--help");
    for (const unsigned short columns : std::initializer_list<unsigned short>{40, 60, 80, 100}) {
      const Outcome outcome = on_terminal(asked, folder, columns);
      EXPECT_EQ(outcome.exit_code, 0) << verb;
      EXPECT_EQ(too_wide(outcome.out, columns), "") << verb << " in " << columns;
    }
  }
}

TEST(Terminal, NoExitCodeIsParted) {
  const Folder folder;
  for (const unsigned short columns : std::initializer_list<unsigned short>{60, 80, 120}) {
    const std::string help = on_terminal({"--help"}, folder, columns).out;
    expect_said(help, {"1 a requirement was not met,", "66 no such input,", "70 internal error,"});
  }
}

TEST(Terminal, ATableThatIsTooWideHasItsRowsAsSentences) {
  const Folder folder;
  const std::string narrow = on_terminal({"airframe", "tasha3_launch2"}, folder).out;
  expect_said(narrow, {"number mass at lift-off; from shape 3.990; file 3.99; unit kg\r\n"});
  const std::string wide = on_terminal({"airframe", "tasha3_launch2"}, folder, 120).out;
  EXPECT_NE(wide.find("1.05 to 1.81      1.5  calibres\r\n"), std::string::npos) << wide;
  folder.write("a.csv", "time_s,roll_angle_deg,roll_rate_deg_s\n0,0,1\n1,1,1\n2,2,1\n");
  const std::string compared = on_terminal({"compare", "a.csv", "a.csv"}, folder, 40).out;
  EXPECT_EQ(too_wide(compared, 40), "");
}

}  // namespace
}  // namespace fantail::test
