// SPDX-License-Identifier: MIT
// The program `fantail` itself: finds the program of a verb and becomes it.
#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <unistd.h>

#include "fantail/help.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "fantail/verb_table.hpp"
#include "input/messages.hpp"
#include "manual/command.hpp"
#include "manual/completion.hpp"
#include "text/quoting.hpp"

namespace {

using fantail::tool::ExitCode;
using fantail::tool::say;
using fantail::tool::show;
using fantail::tool::verb_table;

constexpr const char* meaning = "roll control for sounding rockets, from the wind tunnel to flight";
constexpr const char* description =
    "It simulates sounding rockets with roll canards, using the control code of the real avionics. It checks the "
    "canards of a rocket over CAN. It finds the roll model in tunnel and flight logs, and predicts the next flight.\n"
    "`--help` explains each verb, with examples. Each has a page in this manual: `man fantail-fly`.\n"
    "\n";
constexpr const char* examples =
    "Examples:\n"
    "  fantail fly                          the second launch of Tasha III, with a report\n"
    "  fantail fly tunnel_steps --json      the wind-tunnel runs, for a script\n"
    "  fantail plan show tasha3_launch2     every number of a flight plan\n"
    "  fantail predict tasha3_launch1       in hindsight, with the fin offsets of its own log: no go\n"
    "  fantail bench limits --can can0      four real canards to their limits, and a sheet to sign\n";

std::string list_of_exit_codes() {
  const std::size_t widest = std::min<std::size_t>(110, fantail::tool::output_columns());
  std::string text = "Exit codes: ";
  std::size_t begin = 0;  // of the last line
  for (const fantail::manual::ExitCode& code : fantail::tool::exit_codes) {
    const std::string entry =
        fmt::format("{} {}{}", code.code, code.meaning, &code == &fantail::tool::exit_codes.back() ? "\n" : ", ");
    if (text.size() - begin + entry.size() > widest) {
      text.back() = '\n';
      begin = text.size();
      text += "  ";
    }
    text += entry;
  }
  return text;
}

/// This program as shells and the manual see it. Which options a verb has, the verb's own program says.
fantail::manual::Command command() {
  fantail::manual::Command program{
      .name = "fantail",
      .meaning = meaning,
      .options = {{.names = {"-h", "--help"}, .meaning = "Print this; fantail VERB --help is about one verb"},
                  {.names = {"--version"}, .meaning = "Print the version"}},
      .needs_command = true,
      .notes = description + std::string{examples}};
  for (const auto& verb : verb_table) {
    if (verb.is_installed) {
      program.commands.push_back({.name = "fantail " + std::string{verb.name}, .meaning = std::string{verb.meaning}});
    }
  }
  return program;
}

ExitCode printed() {
  return fantail::tool::output_was_taken() ? ExitCode::done : fantail::tool::complain_about_output();
}

/// What a person sees who does not know where to begin.
std::string overview() {
  std::string text =
      fmt::format("Fantail: {}\nUsage: fantail VERB ...; fantail VERB --help explains one verb\n", meaning);
  std::string_view group;
  for (const auto& verb : verb_table) {
    text += verb.group == group ? "" : fmt::format("\n{}:\n", verb.group);
    group = verb.group;
    text += fmt::format("  {:<10} {}{}\n", verb.name,
                        verb.is_installed ? "" : "(in the sources only, with libunicorn-dev) ", verb.meaning);
  }
  return text;
}

ExitCode help() {
  show(
      "{}\n"
      "  -h,--help    Print this\n"
      "  --version    Print the version\n\n"
      "{}\n{}",
      overview(), examples, list_of_exit_codes());
  return printed();
}

ExitCode refuse(const std::string& complaint) {
  say("fantail: " + fantail::text::printable(complaint) + " (see --help)\n");
  return ExitCode::usage;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  std::ranges::transform(verb_table, std::back_inserter(all), [](const auto& verb) { return std::string{verb.name}; });
  return all;
}

std::string list() {
  std::string text;
  for (const auto& verb : verb_table) {
    text += (text.empty() ? "" : ", ") + std::string{verb.name};
  }
  return text;
}

ExitCode become(const std::string& verb, char** argv) {
  // Beside a program that was built, or where an installed one has its parts.
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string program = "fantail-" + verb;
  for (const std::filesystem::path& folder : {here / "libexec", here / "../libexec/fantail"}) {
    execv((folder / program).c_str(), argv);  // returns only when it fails
    if (errno != ENOENT && errno != ENOTDIR) {
      say(fmt::format("fantail: {} cannot be started: {}\n", (folder / program).lexically_normal().string(),
                      std::strerror(errno)));
      return ExitCode::not_installed;
    }
  }
  say(fmt::format(
      "fantail: the verb {} is not installed: {} is neither in {} nor in {}; in the sources, ./dev {} builds it\n",
      verb, program, (here / "libexec").string(), (here / "../libexec/fantail").lexically_normal().string(), verb));
  return ExitCode::not_installed;
}

bool is_verb(const std::string& word) {
  return std::ranges::find(verb_table, word, &fantail::tool::VerbEntry::name) != verb_table.end();
}

/// What no person types: `--complete WORD...` is a shell's question, which the program of a verb answers once that
/// stands there; `--manual DATE` makes the page of the manual.
ExitCode answer_hidden(int argc, char** argv) {
  const std::vector<std::string> words{argv + 2, argv + argc};
  if (words.empty()) {
    return refuse("unknown option " + std::string{argv[1]});
  }
  if (argv[1] == std::string{"--manual"}) {
    fmt::print("{}", fantail::tool::program_page(command(), words[0]));
  } else if (words.size() > 1 && is_verb(words[0])) {
    std::swap(argv[1], argv[2]);
    return become(words[0], argv + 1);
  } else {
    fmt::print("{}", fantail::manual::completion(command(), words));
  }
  return printed();
}

ExitCode start(int argc, char** argv) {
  if (argc < 2) {
    say(overview());
    return ExitCode::usage;
  }
  const std::string word = argv[1];
  if (word == "--help" || word == "-h") {
    return help();
  }
  if (word == "--version") {
    show("fantail {}\n", FANTAIL_VERSION);
    return printed();
  }
  if (word == "--complete" || word == "--manual") {
    return answer_hidden(argc, argv);
  }
  if (word.starts_with('-')) {
    return refuse("unknown option " + word + "; a verb comes first: " + list());
  }
  if (!is_verb(word)) {
    const auto meant = fantail::input::suggestion(word, names());
    return refuse("unknown verb \"" + word + '"' + (meant ? "; did you mean " + *meant + "?" : "; allowed: " + list()));
  }
  return become(word, argv + 1);
}

}  // namespace

int main(int argc, char** argv) {
  fantail::tool::guard_standard_streams();
  try {
    return static_cast<int>(start(argc, argv));
  } catch (const std::system_error&) {  // standard output that cannot be written
    return static_cast<int>(printed());
  } catch (...) {  // memory has run out, or /proc is not there
    return static_cast<int>(ExitCode::internal_error);
  }
}
