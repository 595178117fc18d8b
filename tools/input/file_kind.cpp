// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "input/file_checks.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

struct Kind {
  Shipped kind;
  std::string noun;
  std::vector<std::string> keys;  ///< sections, and what stands ahead of them
};

std::vector<Kind> kinds() {
  std::vector<std::string> of_scenario = sections_of(scenario_fields());
  for (const Field<sim::Scenario>& field : scenario_fields()) {
    if (field.section.empty()) {
      of_scenario.emplace_back(field.key);
    }
  }
  of_scenario.emplace_back("faults");
  return {{Shipped::scenario, "scenario", std::move(of_scenario)},
          {Shipped::vehicle, "vehicle", sections_of(vehicle_fields())},
          {Shipped::plan, "flight plan", plan_sections()}};
}

}  // namespace

void refuse_other_kind(const Document& document, Shipped wanted) {
  const std::vector<std::string> there = document.root().keys();
  const std::vector<Kind> all = kinds();
  // The first key of the file that such a file may have.
  const auto key_of = [&there](const Kind& kind) {
    return std::ranges::find_if(
        there, [&kind](const std::string& key) { return std::ranges::find(kind.keys, key) != kind.keys.end(); });
  };
  const Kind& asked = *std::ranges::find(all, wanted, &Kind::kind);
  if (key_of(asked) != there.end()) {
    return;
  }
  for (const Kind& kind : all) {
    if (const auto key = key_of(kind); key != there.end()) {
      const TomlNode node = document.root()[*key];
      throw text::Error{text::ErrorKind::bad_configuration,
                        document.where("", *key, node) + ": " + (node.is_table() ? "[" + *key + "]" : *key) +
                            " belongs to a " + kind.noun + "; allowed here: a " + asked.noun};
    }
  }
}

}  // namespace fantail::input
