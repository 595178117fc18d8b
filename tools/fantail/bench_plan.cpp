// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "json/value.hpp"
#include "link/plan_transfer.hpp"
#include "link/session.hpp"
#include "protocol/plan_block.hpp"
#include "replies/sentence.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::tool {
namespace {

struct PlanOptions {
  BenchOptions bench;
  std::string plan;
};

// A block as `plan compile` wrote it goes out as it is, so that what was checked is what is loaded; the avionics
// judges it. A plan file is compiled here.
std::vector<std::byte> named_block(const std::string& name) {
  if (std::filesystem::path{name}.extension() == ".ftpl") {
    const std::string text = text::read_input(name, text::InputKind::document);
    if (text.size() < 16 || text.size() > protocol::largest_plan_block) {
      throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {} bytes; a plan block has 16 to {}", name,
                                                               text.size(), protocol::largest_plan_block)};
    }
    std::vector<std::byte> block(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
      block[i] = static_cast<std::byte>(text[i]);
    }
    return block;
  }
  return block_of(input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, name))));
}

void send(const PlanOptions& options) {
  const std::vector<std::byte> block = named_block(options.plan);
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options.bench, place, link);
  const protocol::PlanReply reply = send_block(place, link, block, options.plan);
  const bool stored = reply.state == protocol::TransferState::stored;
  if (options.bench.json) {
    json::Value json{{"plan", options.plan},
                     {"bytes", block.size()},
                     {"stored", stored},
                     {"refused_because", stored ? json::Value{} : json::Value(replies::sentence(reply))}};
    result::put_answer(json, stored ? result::Answer::yes : result::Answer::no,
                       stored ? "The plan is stored and in force." : replies::sentence(reply),
                       made_with({options.plan}));
    fmt::print("{}\n", json.dump());
  } else if (stored) {
    show("{}: {} bytes sent, checked, stored and read back; it is in force\n", options.plan, block.size());
  }
  if (!stored) {
    throw RequirementNotMet{"the avionics refuses " + options.plan + ": " + replies::sentence(reply) +
                            "; its old plan stays in force"};
  }
}

}  // namespace

void add_bench_plan(const Verb& bench) {
  auto verb =
      bench.verb("plan", "Send a flight plan to the rocket, which checks and stores it; or show the one in force");
  auto options = std::make_shared<PlanOptions>();
  verb.option("PLAN", options->plan,
              "A shipped name, a plan file, or a block made by fantail plan compile (.ftpl). The word show prints the "
              "plan in force as a plan file")
      .offers([](std::string_view begun) {
        manual::Offer offer = shipped(input::Shipped::plan)(begun);
        offer.words.emplace_back("show");
        return offer;
      })
      .required();
  add_bench_options(verb, options->bench, "Print one JSON object");
  verb.examples(
      "Examples:\n"
      "  fantail bench plan tasha3_launch2 --can can0   a shipped plan\n"
      "  fantail bench plan my_plan.toml --can can0     your own; it is checked here first\n"
      "  fantail bench plan p.ftpl --can can0 --json    a compiled block, for a script\n"
      "  fantail bench plan show --can can0 > now.toml  the plan in force, as a plan file");
  verb.action([options] { options->plan == "show" ? show_plan_in_force(options->bench) : send(*options); });
}

}  // namespace fantail::tool
