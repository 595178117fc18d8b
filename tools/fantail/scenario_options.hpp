// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fantail/command_line.hpp"
#include "sim/scenario.hpp"

namespace fantail::tool {

/// What a person says about the run: shared by every verb that has a scenario.
struct ScenarioOptions {
  std::string scenario;
  std::string seed;
  std::vector<std::string> changes;
  std::optional<Verb> verb{};  ///< whose options they are
};

/// SCENARIO, --seed and --set. A scenario that is already named is the default. `or_else` is what else SCENARIO may be,
/// a sentence.
void add_scenario_options(const Verb& verb, ScenarioOptions& options, const std::string& or_else = "");

/// What the command line changes of the scenario, and what else is asked of it: "controller.canard_limit_deg=9",
/// "seed=7", "swirl=-2". Empty: nothing.
[[nodiscard]] std::vector<std::string> changes_of(const ScenarioOptions& options);
/// The command that makes the same again, without where its results go.
[[nodiscard]] std::string command_of(const ScenarioOptions& options);

/// A name for the results of a changed scenario, so that they never replace those of the unchanged one:
/// "tasha3_launch1+controller.canard_limit_deg=9+seed=7". It can be the name of a file. Where characters had to be
/// replaced for that, or the name to be cut, it ends with a hash of all changes.
[[nodiscard]] std::string variant_name(std::string_view scenario, std::span<const std::string> changes);

/// A name that can be that of a file: where it had to be cut, it ends with a hash of all of it.
[[nodiscard]] std::string short_name(const std::string& name);

/// `out`, where it is given, else that name in a folder of the verb's results: out/predict/NAME.
[[nodiscard]] std::filesystem::path results_folder(const std::string& out, std::string_view verb,
                                                   std::string_view scenario, std::span<const std::string> changes);

/// The scenario, its plan, vehicle and motor, which no result may replace. Throws text::Error.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const ScenarioOptions& options);

/// Throws text::Error.
[[nodiscard]] sim::Scenario load(const ScenarioOptions& options);
/// The same flight in six degrees of freedom, whatever the scenario says, so that what plays a part there alone may be
/// changed, too. A scenario that cannot be flown so stays as it is.
[[nodiscard]] sim::Scenario load_in_six_dof(ScenarioOptions options);

/// Throws text::Error when the scenario has a fault of one of these devices; `where` completes "cannot be run".
void refuse_faults(const sim::Scenario& scenario, std::initializer_list<sim::Device> devices, std::string_view where);

}  // namespace fantail::tool
