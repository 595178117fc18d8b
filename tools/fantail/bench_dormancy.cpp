// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "avionics/board_text.hpp"
#include "bench/gate.hpp"
#include "core/flight_plan_fields.hpp"
#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/plan_check.hpp"
#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "input/plan_file.hpp"
#include "json/value.hpp"
#include "link/plan_transfer.hpp"
#include "protocol/plan_block.hpp"
#include "replies/sentence.hpp"
#include "text/error.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

/// The fields of [dormancy] that a bench may set.
constexpr std::array<std::string_view, 4> keys{"until", "height_m", "burn_time_s", "burn_clock_factor"};

struct DormancyOptions {
  BenchOptions bench;
  std::array<std::string, keys.size()> values;  ///< as in a plan file; empty: stays as it is
};

const core::PlanField& field_of(std::string_view key) {
  return *std::ranges::find_if(core::flight_plan_fields(), [key](const core::PlanField& field) {
    return field.section == "dormancy" && field.key == key;
  });
}

std::vector<input::Override> changes(const DormancyOptions& options) {
  std::vector<input::Override> all;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!options.values[i].empty()) {
      all.push_back({"dormancy", std::string{keys[i]}, options.values[i]});
    }
  }
  return all;
}

std::string in_hex(std::uint32_t crc) { return fmt::format("{:08x}", crc); }

// The error of a plan file names the change as a --set, which this verb does not have.
core::FlightPlan changed(const core::FlightPlan& plan, std::span<const input::Override> wanted) {
  try {
    return input::changed_plan(plan, wanted);
  } catch (const text::Error& error) {
    const std::string why = error.what();
    const std::size_t end = why.starts_with("--set ") ? why.find(": ") + 2 : 0;
    throw text::Error{error.kind(), "nothing was sent: " + why.substr(end)};
  }
}

/// What was in force before, and what is now.
struct Gates {
  link::PlanInForce before{};
  core::FlightPlan plan{};
  std::uint32_t block_crc = 0;
  bool sent = false;
};

// A plan in the flash that the avionics cannot use is not replaced by the built-in one in passing.
void expect_own_plan(const link::PlanInForce& read) {
  if (read.source != protocol::PlanSource::built_in && read.source != protocol::PlanSource::stored) {
    throw RequirementNotMet{fmt::format("the plan in force is {}; send a whole plan first with fantail bench plan",
                                        avionics::text(read.source))};
  }
}

Gates read_and_set(const DormancyOptions& options, link::Place& place, link::AvionicsLink& link) {
  const std::vector<input::Override> wanted = changes(options);
  Gates gates{.before = link::read_plan_in_force(place, link)};
  gates.plan = changed(gates.before.plan, wanted);
  const std::vector<std::byte> block = block_of(gates.plan);
  gates.block_crc = protocol::plan_block_crc(block);
  if (gates.block_crc == gates.before.block_crc) {
    return gates;
  }
  expect_own_plan(gates.before);
  const protocol::PlanReply reply = send_block(place, link, block, "the changed plan");
  if (reply.state != protocol::TransferState::stored) {
    throw RequirementNotMet{"the avionics refuses the changed plan: " + replies::sentence(reply) +
                            "; its old plan stays in force"};
  }
  gates.sent = true;
  return gates;
}

std::string sentence(const Gates& gates, bool was_asked) {
  const std::string until = bench::gate(gates.plan);
  return gates.sent  ? fmt::format("The changed plan is in force: canards stay at trim until {}.", until)
         : was_asked ? fmt::format(
                           "Nothing was sent: the plan in force has these values. Canards stay at trim until "
                           "{}.",
                           until)
                     : fmt::format("Canards stay at trim until {}.", until);
}

void print_json(const Gates& gates, bool was_asked) {
  const auto dormancy = [](const core::FlightPlan& plan) { return plan_json(plan)["dormancy"]; };
  json::Value all{{"dormancy", dormancy(gates.plan)},
                  {"block_crc", in_hex(gates.block_crc)},
                  {"sent", gates.sent},
                  {"dormancy_before", dormancy(gates.before.plan)},
                  {"block_crc_before", in_hex(gates.before.block_crc)},
                  {"origin_before", replies::name(gates.before.source)}};
  result::put_answer(all, was_asked ? result::Answer::yes : result::Answer::none, sentence(gates, was_asked),
                     made_with({}));
  fmt::print("{}", all.pretty());
}

void print_text(const DormancyOptions& options, const Gates& gates, bool was_asked) {
  const json::Value before = plan_json(gates.before.plan)["dormancy"];
  const json::Value now = plan_json(gates.plan)["dormancy"];
  show("{}\n", sentence(gates, was_asked));
  for (const std::string_view key : keys) {
    const std::string was = before[key].dump();
    const std::string is = now[key].dump();
    show("  {:<19}{}{}\n", key, is, was == is ? "" : fmt::format(" (was {})", was));
  }
  const std::string crc = in_hex(gates.block_crc);
  const std::string old_crc = in_hex(gates.before.block_crc);
  show("  {:<19}{}{}\n", "block_crc", crc, crc == old_crc ? "" : fmt::format(" (was {})", old_crc));
  if (gates.sent) {
    show(
        "Still to do: put the values into your plan file, because bench plan sends that file as it stands. Run the "
        "self-test again: fantail bench arm --can {}. Make a new bench sheet: an older one names the old plan.\n",
        text::shell_word(options.bench.interface));
  } else {
    show("  {:<19}{}\n", "plan", avionics::text(gates.before.source));
  }
}

void dormancy(const DormancyOptions& options) {
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options.bench, place, link);
  const Gates gates = read_and_set(options, place, link);
  const bool was_asked = !changes(options).empty();
  if (options.bench.json) {
    print_json(gates, was_asked);
  } else {
    print_text(options, gates, was_asked);
  }
}

// "height_m" is --height-m.
std::string option_name(std::string_view key) {
  std::string name = "--" + std::string{key};
  std::ranges::replace(name, '_', '-');
  return name;
}

void add_field(const Verb& verb, std::string_view key, std::string& value) {
  const core::PlanField& field = field_of(key);
  std::string meaning{field.meaning};
  meaning.front() = static_cast<char>(meaning.front() - 'a' + 'A');
  Option option = verb.option(option_name(key), value, meaning);
  if (field.kind == core::FieldKind::choice) {
    option.one_of({field.choices.begin(), field.choices.end()});
  } else {
    const input::Limits limits = input::allowed_in_plan(field);
    option.range(limits.minimum, limits.maximum).value_name(field.unit.empty() ? "NUMBER" : std::string{field.unit});
  }
}

}  // namespace

void add_bench_dormancy(const Verb& bench) {
  auto verb = bench.verb("dormancy", "Show until when the plan in force keeps the canards at trim, or change it");
  auto options = std::make_shared<DormancyOptions>();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    add_field(verb, keys[i], options->values[i]);
  }
  add_bench_options(verb, options->bench, "Print one JSON object");
  verb.examples(
      "Examples:\n"
      "  fantail bench dormancy --can can0                                 show the gate; changes nothing\n"
      "  fantail bench dormancy --can can0 --until height --height-m 1700  the range asks for 1700 m\n"
      "  fantail bench dormancy --can vcan0 --until guide --json           for a script: a rehearsal without a gate");
  verb.action([options] { dormancy(*options); });
}

}  // namespace fantail::tool
