// SPDX-License-Identifier: MIT
#include "fantail/bench_options.hpp"
#include "fantail/verbs.hpp"

namespace fantail::tool {

void add_bench_options(CLI::App& verb, BenchOptions& options, const std::string& json_meaning) {
  verb.add_option("--can", options.interface, "CAN interface, for example vcan0 or can0")->required()->type_name("IF");
  verb.add_flag("--json", options.json, json_meaning);
}

void add_bench(CLI::App& program) {
  auto* bench = program.add_subcommand("bench", "Check and command a rocket over CAN");
  bench->require_subcommand(1);
  bench->footer(
      "Examples:\n"
      "  fantail bench watch --can can0                         what the rocket says, live\n"
      "  fantail bench limits --can can0 --vehicle my_rocket    every canard to its limits; a sheet to sign\n"
      "  fantail bench arm --can can0                           self-test, switch, command");
  add_bench_watch(*bench);
  add_bench_limits(*bench);
  add_bench_step(*bench);
  add_bench_sine(*bench);
  add_bench_arm(*bench);
  add_bench_plan(*bench);
  add_bench_log(*bench);
}

}  // namespace fantail::tool
