// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/core.h>

#include "bench/axes.hpp"
#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "link/plan_transfer.hpp"

namespace fantail::tool {
namespace {

void axes(const BenchOptions& options) {
  CanPlace place{options.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options, place, link);
  const core::SensorsPlan believed = link::read_plan_in_force(place, link).plan.sensors;
  bench::TurnsSeen seen{};
  try {
    seen = bench::watch_turns(
        place, link, [](const bench::AskedTurn& turn) { say(fmt::format("{}: {}\n", turn.name, turn.instruction)); });
  } catch (const bench::NotTurned& error) {
    throw RequirementNotMet{std::string{error.what()} + "; the axes are not judged"};
  }
  bench::AxesResult result = bench::judge_axes(seen);
  if (const auto found = result.right ? std::nullopt : bench::mounting_of(seen, believed)) {
    result.plan_lines = bench::mounting_lines(*found, believed);
  }
  if (options.json) {
    fmt::print("{}", bench::axes_json(result, made_with({})));
  } else {
    show_text(painted_decision(bench::axes_text(result)));
  }
  if (!result.right) {
    throw RequirementNotMet{""};
  }
}

}  // namespace

void add_bench_axes(const Verb& bench) {
  auto verb = bench.verb(
      "axes", "Turn the rocket as instructed, to check axes, directions and scales of gyro and accelerometers");
  auto options = std::make_shared<BenchOptions>();
  add_bench_options(verb, *options, "Print one JSON object");
  verb.examples(
      "Examples:\n"
      "  fantail bench axes --can can0              four turns by hand; the canards do not move\n"
      "  fantail bench axes --can can0 --json       for a script; instructions go to standard error");
  verb.action([options] { axes(*options); });
}

}  // namespace fantail::tool
