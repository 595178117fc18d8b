// SPDX-License-Identifier: MIT
#include <exception>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>

#include "bench/session.hpp"
#include "fantail/exit_code.hpp"
#include "fantail/interrupt.hpp"
#include "fantail/requirement.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/usage.hpp"
#include "fantail/verbs.hpp"
#include "hal/linux/can_bus.hpp"
#include "hil/wire.hpp"
#include "report/output_folder.hpp"
#include "sim/input_error.hpp"
#include "telemetry/url.hpp"

namespace {

using fantail::tool::ExitCode;
using fantail::tool::output_was_taken;
using fantail::tool::usage_complaint;

ExitCode complain(const std::string& message, ExitCode code) {
  if (!message.empty()) {  // what there is to say may have been printed
    fantail::tool::say("fantail: " + message + "\n");
  }
  return code;
}

ExitCode complain(const std::exception& error, ExitCode code) { return complain(error.what(), code); }

ExitCode complain_about_output() { return complain("standard output could not be written", ExitCode::input_output); }

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
      "  fantail predict tasha3_launch1       what a tunnel would have said of it: no go, and why\n"
      "  fantail bench limits --can can0      four real canards to their limits, and a sheet to sign\n"
      "\n"
      "Exit codes: 0 done, 1 a requirement was not met, 64 usage, 65 bad data, 66 no such input,\n"
      "  70 internal error, 74 input/output, 78 bad configuration, 130 interrupted");
  fantail::tool::add_fly(program);
  fantail::tool::add_identify(program);
  fantail::tool::add_paper(program);
  fantail::tool::add_plan(program);
  fantail::tool::add_log(program);
  fantail::tool::add_replay(program);
  fantail::tool::add_node(program);
  fantail::tool::add_bench(program);
  fantail::tool::add_compare(program);
  fantail::tool::add_tunnel(program);
  fantail::tool::add_predict(program);
  fantail::tool::add_gateway(program);
  fantail::tool::add_watch(program);
  fantail::tool::add_report(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      return complain(usage_complaint(program, error) + " (see --help)", ExitCode::usage);
    }
    program.exit(error);  // help or version, asked for
  } catch (const fantail::sim::InputError& error) {
    return complain(error, code_of(error.fault()));
  } catch (const fantail::report::OutputError& error) {
    return complain(error, ExitCode::input_output);
  } catch (const fantail::tool::Interrupted& error) {
    return complain(error, ExitCode::interrupted);
  } catch (const fantail::tool::RequirementNotMet& error) {
    return output_was_taken() ? complain(error, ExitCode::requirement_not_met) : complain_about_output();
  } catch (const fantail::hal::on_linux::CanError& error) {
    return complain(error, ExitCode::input_output);
  } catch (const fantail::hil::TargetError& error) {
    return complain(error, ExitCode::input_output);
  } catch (const fantail::bench::LinkError& error) {
    return complain(error, ExitCode::input_output);
  } catch (const fantail::telemetry::TelemetryError& error) {
    return complain(error, ExitCode::input_output);
  } catch (const std::system_error& error) {
    return output_was_taken() ? complain(error, ExitCode::input_output) : complain_about_output();
  } catch (const std::exception& error) {
    return complain(error, ExitCode::internal_error);
  }
  // Output that a pipe or a full disk did not take must not look like success.
  return output_was_taken() ? ExitCode::done : complain_about_output();
}

}  // namespace

int main(int argc, char** argv) {
  fantail::tool::guard_standard_streams();
  fantail::tool::catch_interrupts();
  try {
    return static_cast<int>(run(argc, argv));
  } catch (...) {  // not even a message can be made: memory has run out
    return static_cast<int>(ExitCode::internal_error);
  }
}
