// SPDX-License-Identifier: MIT
#include "fantail/run.hpp"

#include <algorithm>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/help.hpp"
#include "fantail/progress.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/verb_table.hpp"
#include "files/convert.hpp"
#include "manual/completion.hpp"
#include "manual/roff.hpp"
#include "text/error.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

ExitCode complain(const std::string& message, ExitCode code) {
  if (!message.empty()) {  // what there is to say may have been printed
    say("fantail: " + message + "\n");
  }
  return code;
}

ExitCode code_of(text::ErrorKind kind) {
  switch (kind) {
    case text::ErrorKind::usage: return ExitCode::usage;
    case text::ErrorKind::no_such_input: return ExitCode::no_such_input;
    case text::ErrorKind::bad_data: return ExitCode::bad_data;
    case text::ErrorKind::requirement_not_met: return ExitCode::requirement_not_met;
    case text::ErrorKind::interrupted: return ExitCode::interrupted;
    case text::ErrorKind::bad_configuration: break;
  }
  return ExitCode::bad_configuration;
}

/// What no person types: `--complete WORD...` is a shell's question, and `--manual DATE` makes the page of the manual.
bool answer_hidden(const VerbEntry& entry, void (*fill)(const Verb& verb), const std::vector<std::string>& words) {
  if (words.size() < 2 || (words[0] != "--complete" && words[0] != "--manual")) {
    return false;
  }
  const std::string name{entry.name};
  const manual::Command command = command_of(name, std::string{entry.meaning}, fill);
  if (words[0] == "--complete") {
    fmt::print("{}", manual::completion(command, std::span{words}.subspan(1)));
  } else {
    const manual::Title title{.name = "fantail-" + name, .section = 1, .date = words[1], .version = FANTAIL_VERSION};
    fmt::print("{}", manual::tidied(manual::command_page(command, title, exit_codes) +
                                    manual::see_also({"fantail(1)", "fantail.toml(5)", "flight.ftl(5)"})));
  }
  return true;
}

ExitCode run_words(const VerbEntry& entry, void (*fill)(const Verb& verb), const std::vector<std::string>& words) {
  try {
    if (!answer_hidden(entry, fill, words)) {
      read_command_line(std::string{entry.name}, std::string{entry.meaning}, fill, words);
    }
  } catch (const text::Error& error) {
    const ExitCode code = code_of(error.kind());
    // A "no" is worth nothing to somebody who could not read it.
    return code != ExitCode::requirement_not_met || output_was_taken() ? complain(error.what(), code)
                                                                       : complain_about_output();
  } catch (const files::NotInstalled& error) {
    return complain(error.what(), ExitCode::not_installed);
  } catch (const std::runtime_error& error) {
    return output_was_taken() ? complain(error.what(), ExitCode::input_output) : complain_about_output();
  } catch (const std::bad_alloc&) {
    return complain("not enough memory; end other programs, or give less data at once", ExitCode::internal_error);
  } catch (const std::exception& error) {
    return complain(error.what(), ExitCode::internal_error);
  }
  // Output that a pipe or a full disk did not take must not look like success.
  return output_was_taken() ? ExitCode::done : complain_about_output();
}

}  // namespace

int run(const VerbCode& verb, int argc, char** argv) {
  guard_standard_streams();
  catch_interrupts();
  try {
    const VerbEntry& entry = *std::ranges::find(verb_table, verb.name, &VerbEntry::name);
    const std::vector<std::string> words{argv + 1, argv + argc};
    return static_cast<int>(run_words(entry, verb.fill, words));
  } catch (...) {  // not even a message can be made: memory has run out
    return static_cast<int>(ExitCode::internal_error);
  }
}

}  // namespace fantail::tool
