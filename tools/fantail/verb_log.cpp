// SPDX-License-Identifier: MIT
#include "fantail/log_verbs.hpp"
#include "fantail/verbs.hpp"

namespace fantail::tool {

void add_log(CLI::App& program) {
  auto* verb = program.add_subcommand("log", "What is in a flight log, and other formats of it");
  verb->require_subcommand(1);
  verb->footer(
      "Examples:\n"
      "  fantail log info out/tasha3_launch2    who flew what, is it intact, does a replay give the same\n"
      "  fantail log info flash.ftl --flight 2  one of several flights that a board's flash held\n"
      "  fantail log info flown.ftl --json      every figure and every event, for a script");
  add_log_info(*verb);
  add_log_export(*verb);
}

}  // namespace fantail::tool
