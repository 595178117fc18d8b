// SPDX-License-Identifier: MIT
#include "fantail/scenario_options.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "fantail/offers.hpp"
#include "fantail/standard_streams.hpp"
#include "input/document.hpp"
#include "input/fault_file.hpp"
#include "input/scenario_file.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

// As text, because CLI11 would wrap -1 around and cut off what is too large. Empty: not a seed.
std::optional<std::uint64_t> parse_seed(const std::string& text) { return text::whole_number(text); }

std::string objection_to_seed(const std::string& text) {
  return parse_seed(text) ? "" : '"' + text + "\" is not a seed; allowed: a whole number, 0 to 18446744073709551615";
}

// Of what a change may contain: neither a folder nor what a shell or another operating system takes for its own.
constexpr std::size_t longest_name = 100;  // a file system takes 255 bytes, and a person reads less

bool is_unsafe(char c) {
  const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  return !is_plain && std::string_view{"._-+="}.find(c) == std::string_view::npos;
}

/// FNV-1a: two changes of the same scenario hardly ever have the same.
std::uint32_t hash(std::string_view text) {
  std::uint32_t value = 2166136261U;
  for (const char c : text) {
    value = (value ^ static_cast<unsigned char>(c)) * 16777619U;
  }
  return value;
}

}  // namespace

void add_scenario_options(const Verb& verb, ScenarioOptions& options, const std::string& or_else) {
  options.verb = verb;
  auto scenario =
      verb.option("SCENARIO", options.scenario,
                  std::string{
                      "A shipped name (tasha3_launch1, tasha3_launch2, tunnel_steps, tunnel_..., bench_...) or a path "
                      "to a scenario file"} +
                      or_else)
          .offers(shipped(input::Shipped::scenario))
          .belongs_to_command();
  if (options.scenario.empty()) {
    scenario.required();
  } else {
    scenario.show_default();
  }
  verb.option("--seed", options.seed, "Seed of all random streams, instead of the scenario's")
      .check(objection_to_seed)
      .value_name("NUMBER")
      .belongs_to_command();
  verb.option("--set", options.changes, "section.key=value: change one value of plan, vehicle or scenario")
      .offers(changes)
      .one_word_each_time()
      .belongs_to_command();
}

std::vector<std::string> changes_of(const ScenarioOptions& options) {
  std::vector<std::string> changes = options.changes;
  if (!options.seed.empty()) {
    changes.push_back("seed=" + options.seed);
  }
  for (std::string& change : options.verb->asked().changes) {
    changes.push_back(std::move(change));
  }
  return changes;
}

std::string command_of(const ScenarioOptions& options) { return options.verb->asked().command; }

std::string short_name(const std::string& name) {
  return name.size() <= longest_name ? name : name.substr(0, longest_name) + fmt::format("+{:08x}", hash(name));
}

std::string variant_name(std::string_view scenario, std::span<const std::string> changes) {
  std::string name{scenario};
  for (const std::string& change : changes) {
    name += '+' + change;
  }
  std::string safe = name;
  std::ranges::replace_if(safe.begin() + static_cast<std::ptrdiff_t>(scenario.size()), safe.end(), is_unsafe, '_');
  if (safe == name && safe.size() <= longest_name) {
    return name;
  }
  return safe.substr(0, std::max(longest_name, scenario.size())) + fmt::format("+{:08x}", hash(name));
}

std::filesystem::path results_folder(const std::string& out, std::string_view verb, std::string_view scenario,
                                     std::span<const std::string> changes) {
  return out.empty() ? std::filesystem::path{"out"} / verb / variant_name(scenario, changes)
                     : std::filesystem::path{out};
}

std::vector<std::filesystem::path> files_of(const ScenarioOptions& options) {
  const input::ScenarioFiles files = input::ScenarioFiles::load(options.scenario);
  return {files.scenario().file(), files.plan().file(), files.vehicle().file(), input::motor_file(files.vehicle())};
}

sim::Scenario load(const ScenarioOptions& options) {
  sim::Scenario scenario = input::load_scenario(options.scenario, input::parse_overrides(options.changes));
  for (const auto* warnings : {&scenario.vehicle.warnings, &scenario.warnings}) {
    for (const std::string& warning : *warnings) {
      say("fantail: warning: " + warning + "\n");
    }
  }
  scenario.changed_values = options.changes.size() + (options.seed.empty() ? 0 : 1);
  scenario.seed = parse_seed(options.seed).value_or(scenario.seed);
  return scenario;
}

sim::Scenario load_in_six_dof(ScenarioOptions options) {
  const sim::Scenario as_written = input::load_scenario(options.scenario, {});
  if (as_written.surroundings == sim::Surroundings::flight && as_written.vehicle.airframe) {
    options.changes.push_back("flight.motion=six_dof");
  }
  return load(options);
}

void refuse_faults(const sim::Scenario& scenario, std::initializer_list<sim::Device> devices, std::string_view where) {
  for (const sim::Fault& fault : scenario.faults) {
    if (std::ranges::find(devices, fault.device) != devices.end()) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        fmt::format("{}: faults.device = \"{}\" cannot be run {}; allowed: the other devices",
                                    scenario.name, input::name(fault.device), where)};
    }
  }
}

}  // namespace fantail::tool
