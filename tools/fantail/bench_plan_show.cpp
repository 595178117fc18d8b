// SPDX-License-Identifier: MIT
#include <string>

#include <fmt/core.h>

#include "avionics/board_text.hpp"
#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/plan_check.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "input/plan_file.hpp"
#include "json/value.hpp"
#include "link/plan_transfer.hpp"
#include "replies/sentence.hpp"

namespace fantail::tool {
void show_plan_in_force(const BenchOptions& options) {
  CanPlace place{options.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options, place, link);
  const link::PlanInForce read = link::read_plan_in_force(place, link);
  if (!input::table_says_all(read.plan)) {
    throw RequirementNotMet{
        "the plan in force has a value that a plan file cannot contain, so it cannot be printed as one"};
  }
  const std::string block_crc = fmt::format("{:08x}", read.block_crc);
  if (options.json) {
    json::Value all{{"origin", replies::name(read.source)}, {"block_crc", block_crc}, {"plan", plan_json(read.plan)}};
    result::put_answer(all, result::Answer::none, fmt::format("The plan in force is {}.", avionics::text(read.source)),
                       made_with({}));
    fmt::print("{}", all.pretty());
    return;
  }
  show_text(input::plan_table(read.plan));
  // Beside the file, so that what is printed is the file and nothing else.
  say(fmt::format("fantail: {}: the plan in force is {}; block_crc {}\n", options.interface,
                  avionics::text(read.source), block_crc));
}

}  // namespace fantail::tool
