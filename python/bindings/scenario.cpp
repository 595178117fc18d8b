// SPDX-License-Identifier: MIT
#include "python/bindings/scenario.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "python/bindings/bind.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace nb = nanobind;

namespace fantail::python {

Scenario Scenario::load(std::string source, std::vector<std::string> changes, std::string seed) {
  const auto number = text::whole_number(seed);
  if (!seed.empty() && !number) {
    throw text::Error{text::ErrorKind::usage,
                      "--seed: \"" + seed + "\" is not a seed; allowed: a whole number, 0 to 18446744073709551615"};
  }
  Scenario loaded{.source = std::move(source), .changes = std::move(changes), .seed = std::move(seed), .scenario = {}};
  loaded.scenario = input::load_scenario(loaded.source, input::parse_overrides(loaded.changes));
  loaded.scenario.changed_values = loaded.all_changes().size();
  loaded.scenario.seed = number.value_or(loaded.scenario.seed);
  return loaded;
}

std::vector<std::string> Scenario::all_changes() const {
  std::vector<std::string> all = changes;
  if (!seed.empty()) {
    all.push_back("seed=" + seed);
  }
  return all;
}

void bind_scenarios(nb::module_& m) {
  auto bound_scenario = nb::class_<Scenario>(m, "Scenario")
                            .def_static("load", &Scenario::load, nb::arg("source"), nb::arg("changes"), nb::arg("seed"))
                            .def_ro("source", &Scenario::source)
                            .def_ro("changes", &Scenario::changes)
                            .def_ro("seed_text", &Scenario::seed)
                            .def_prop_ro("name", [](const Scenario& s) { return s.scenario.name; })
                            .def_prop_ro("vehicle", [](const Scenario& s) { return s.scenario.vehicle.name; })
                            .def_prop_ro("plan_name", [](const Scenario& s) { return s.scenario.plan_name; })
                            .def_prop_ro("seed", [](const Scenario& s) { return s.scenario.seed; })
                            .def_prop_ro("plan", [](const Scenario& s) { return s.scenario.plan; })
                            .def_prop_ro("warnings", [](const Scenario& s) {
                              std::vector<std::string> all = s.scenario.vehicle.warnings;
                              all.insert(all.end(), s.scenario.warnings.begin(), s.scenario.warnings.end());
                              return all;
                            });
  refuse_to_pickle(bound_scenario, "Scenario", "pass name or path, set and seed, and call Scenario.load() there");
  m.def("set_data_folder", [](const std::string& folder) { input::set_data_folder(folder); }, nb::arg("folder"));
  m.def("data_folder", [] { return input::data_folder().string(); });
  m.def("shipped_scenarios", [] { return input::shipped_names(input::Shipped::scenario); });
}

}  // namespace fantail::python
