// SPDX-License-Identifier: MIT
#include <cstdint>

#include "fantail/bench_desk.hpp"
#include "fantail/offers.hpp"
#include "fantail/run.hpp"
#include "hal/linux/can_error.hpp"
#include "link/session.hpp"

namespace fantail::tool {

void add_bench_options(const Verb& verb, BenchOptions& options, const std::string& json_meaning) {
  add_can_option(verb, options.interface);
  verb.option("--wait", options.wait_s, "Wait up to this long for the avionics to report and the rocket to be at rest")
      .range(0.0, 3600.0)
      .value_name("SECONDS");
  verb.flag("--json", options.json, json_meaning);
}

void await_rocket(const BenchOptions& options, link::Place& place, link::AvionicsLink& link) {
  if (!options.wait_s) {
    link::await_avionics(place, link);
    return;
  }
  const hal::Microseconds longest{static_cast<std::int64_t>(1e6 * *options.wait_s)};
  link::Timeout timeout{longest, place.now()};
  link::await_avionics(place, link, longest);
  const auto at_rest = [&] {
    const auto& status = link.newest<protocol::StatusReport>();
    return status && status->message.at_rest;
  };
  while (!at_rest() && !timeout.expired(place.now()) && !link.has_fallen_silent()) {
    place.wait(hal::Microseconds{10'000});
    link.listen(place.now());
    link.expect_one_rocket();
  }
}

namespace {

void fill(const Verb& bench) {
  bench.needs_verb();
  bench.examples(
      "Examples:\n"
      "  fantail bench watch --can can0                            the rocket's reports, live\n"
      "  fantail bench limits --can can0 --vehicle my_rocket.toml  every canard to its limits; a sheet to sign\n"
      "  fantail bench arm --can can0                              self-test, switch, command");
  add_bench_watch(bench);
  add_bench_limits(bench);
  add_bench_step(bench);
  add_bench_sine(bench);
  add_bench_hold(bench);
  add_bench_cycle(bench);
  add_bench_zero(bench);
  add_bench_axes(bench);
  add_bench_arm(bench);
  add_bench_plan(bench);
  add_bench_dormancy(bench);
  add_bench_log(bench);
}

const VerbCode code{"bench", fill};

}  // namespace
}  // namespace fantail::tool
