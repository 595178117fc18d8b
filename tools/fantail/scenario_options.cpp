// SPDX-License-Identifier: MIT
#include "fantail/scenario_options.hpp"

#include <charconv>
#include <cstdint>
#include <optional>

#include "fantail/standard_streams.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"

namespace fantail::tool {
namespace {

// CLI11 would wrap -1 around and cut off what is too large. Empty: not a seed.
std::optional<std::uint64_t> parse_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, seed);
  return error == std::errc{} && stopped == end ? std::optional{seed} : std::nullopt;
}

std::string objection_to_seed(const std::string& text) {
  return parse_seed(text) ? "" : '"' + text + "\" is not a seed; allowed: a whole number, 0 to 18446744073709551615";
}

}  // namespace

void add_scenario_options(const Verb& verb, ScenarioOptions& options) {
  auto scenario =
      verb.option("SCENARIO", options.scenario,
                  "A shipped name (tasha3_launch1, tasha3_launch2, tunnel_steps, tunnel_..., bench_...) or a path "
                  "to a scenario file");
  if (options.scenario.empty()) {
    scenario.required();
  } else {
    scenario.show_default();
  }
  verb.option("--seed", options.seed, "Seed of all random streams, instead of the scenario's")
      .check(objection_to_seed)
      .value_name("NUMBER");
  verb.option("--set", options.changes, "section.key=value: change one value of plan, vehicle or scenario")
      .one_word_each_time();
}

sim::Scenario load(const ScenarioOptions& options) {
  std::vector<input::Override> changes;
  changes.reserve(options.changes.size());
  for (const std::string& text : options.changes) {
    changes.push_back(input::parse_override(text));
  }
  sim::Scenario scenario = input::load_scenario(options.scenario, changes);
  for (const auto* warnings : {&scenario.vehicle.warnings, &scenario.warnings}) {
    for (const std::string& warning : *warnings) {
      say("fantail: warning: " + warning + "\n");
    }
  }
  scenario.seed = parse_seed(options.seed).value_or(scenario.seed);
  return scenario;
}

}  // namespace fantail::tool
