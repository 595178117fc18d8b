// SPDX-License-Identifier: MIT
#include "fantail/bench_options.hpp"
#include "fantail/run.hpp"
#include "hal/linux/can_error.hpp"
#include "link/session.hpp"

namespace fantail::tool {

void add_bench_options(const Verb& verb, BenchOptions& options, const std::string& json_meaning) {
  verb.option("--can", options.interface, "CAN interface, for example vcan0 or can0").required().value_name("IF");
  verb.flag("--json", options.json, json_meaning);
}

namespace {

void fill(const Verb& bench) {
  bench.needs_verb();
  bench.examples(
      "Examples:\n"
      "  fantail bench watch --can can0                            what the rocket reports, live\n"
      "  fantail bench limits --can can0 --vehicle my_rocket.toml  every canard to its limits; a sheet to sign\n"
      "  fantail bench arm --can can0                              self-test, switch, command");
  add_bench_watch(bench);
  add_bench_limits(bench);
  add_bench_step(bench);
  add_bench_sine(bench);
  add_bench_arm(bench);
  add_bench_plan(bench);
  add_bench_log(bench);
}

}  // namespace
}  // namespace fantail::tool

int main(int argc, char** argv) {
  using namespace fantail;
  return tool::run("bench", tool::fill, argc, argv);
}
