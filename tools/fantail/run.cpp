// SPDX-License-Identifier: MIT
#include "fantail/run.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "fantail/exit_code.hpp"
#include "fantail/interrupt.hpp"
#include "fantail/requirement.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/verb_table.hpp"
#include "report/output_folder.hpp"
#include "sim/input_error.hpp"

namespace fantail::tool {
namespace {

ExitCode complain(const std::string& message, ExitCode code) {
  if (!message.empty()) {  // what there is to say may have been printed
    say("fantail: " + message + "\n");
  }
  return code;
}

ExitCode complain_about_output() { return complain("standard output could not be written", ExitCode::input_output); }

ExitCode code_of(sim::InputFault fault) {
  switch (fault) {
    case sim::InputFault::no_such_input: return ExitCode::no_such_input;
    case sim::InputFault::bad_data: return ExitCode::bad_data;
    case sim::InputFault::bad_configuration: break;
  }
  return ExitCode::bad_configuration;
}

ExitCode run_words(const VerbEntry& entry, void (*fill)(const Verb& verb), const std::vector<std::string>& words,
                   IsInputOutput is_input_output) {
  try {
    read_command_line(std::string{entry.name}, std::string{entry.meaning}, fill, words);
  } catch (const UsageError& error) {
    return complain(std::string{error.what()} + " (see --help)", ExitCode::usage);
  } catch (const sim::InputError& error) {
    return complain(error.what(), code_of(error.fault()));
  } catch (const report::OutputError& error) {
    return complain(error.what(), ExitCode::input_output);
  } catch (const Interrupted& error) {
    return complain(error.what(), ExitCode::interrupted);
  } catch (const RequirementNotMet& error) {
    return output_was_taken() ? complain(error.what(), ExitCode::requirement_not_met) : complain_about_output();
  } catch (const std::system_error& error) {
    return output_was_taken() ? complain(error.what(), ExitCode::input_output) : complain_about_output();
  } catch (const std::exception& error) {
    return complain(error.what(), is_input_output(error) ? ExitCode::input_output : ExitCode::internal_error);
  }
  // Output that a pipe or a full disk did not take must not look like success.
  return output_was_taken() ? ExitCode::done : complain_about_output();
}

}  // namespace

int run(const char* name, void (*fill)(const Verb& verb), int argc, char** argv, IsInputOutput is_input_output) {
  guard_standard_streams();
  catch_interrupts();
  try {
    const VerbEntry& entry = *std::ranges::find(verb_table, name, &VerbEntry::name);
    return static_cast<int>(run_words(entry, fill, {argv + 1, argv + argc}, is_input_output));
  } catch (...) {  // not even a message can be made: memory has run out
    return static_cast<int>(ExitCode::internal_error);
  }
}

}  // namespace fantail::tool
