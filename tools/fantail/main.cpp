// SPDX-License-Identifier: MIT
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "fantail/exit_code.hpp"
#include "fantail/interrupt.hpp"
#include "fantail/verbs.hpp"
#include "report/output_folder.hpp"
#include "sim/input_error.hpp"

namespace {

using fantail::tool::ExitCode;

ExitCode complain(const std::exception& error, ExitCode code) {
  fmt::print(stderr, "fantail: {}\n", error.what());
  return code;
}

ExitCode code_of(fantail::sim::InputFault fault) {
  switch (fault) {
    case fantail::sim::InputFault::no_such_input: return ExitCode::no_such_input;
    case fantail::sim::InputFault::bad_data: return ExitCode::bad_data;
    case fantail::sim::InputFault::bad_configuration: break;
  }
  return ExitCode::bad_configuration;
}

ExitCode run(int argc, char** argv) {
  CLI::App program{"Fantail: roll control for sounding rockets, from the wind tunnel to flight", "fantail"};
  program.require_subcommand(1);
  program.set_version_flag("--version", "fantail " FANTAIL_VERSION);
  program.footer(
      "Examples:\n"
      "  fantail fly                          the second launch of Tasha III, with a report\n"
      "  fantail fly tunnel_steps --json      the wind-tunnel runs, for a script\n"
      "  fantail plan show tasha3_launch2     every number a rocket is loaded with\n"
      "\n"
      "Exit codes: 0 done, 1 a requirement was not met, 64 usage, 65 bad data, 66 no such input,\n"
      "  70 internal error, 74 input/output, 78 bad configuration, 130 interrupted");
  fantail::tool::add_fly(program);
  fantail::tool::add_plan(program);
  try {
    program.parse(argc, argv);
    // Output that a pipe or a full disk did not take must not look like success.
    return std::fflush(stdout) == 0
               ? ExitCode::done
               : complain(std::runtime_error{"standard output could not be written"}, ExitCode::input_output);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? ExitCode::done : ExitCode::usage;
  } catch (const fantail::sim::InputError& error) {
    return complain(error, code_of(error.fault()));
  } catch (const fantail::report::OutputError& error) {
    return complain(error, ExitCode::input_output);
  } catch (const fantail::tool::Interrupted& error) {
    return complain(error, ExitCode::interrupted);
  } catch (const std::exception& error) {
    return complain(error, ExitCode::internal_error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  fantail::tool::catch_interrupts();
  return static_cast<int>(run(argc, argv));
}
