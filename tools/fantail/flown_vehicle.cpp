// SPDX-License-Identifier: MIT
#include "fantail/flown_vehicle.hpp"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "logs/flight_file.hpp"

namespace fantail::tool {
namespace {

/// What was changed of the vehicle for this flight; changes of plan and scenario are others'.
void apply_changes(const flight::FlownAirframe& flown, input::Document& document) {
  const std::vector<std::string> sections = input::sections_of(input::vehicle_fields());
  for (const std::string& change : flown.changes) {
    if (const std::string section = change.substr(0, change.find('.'));
        std::ranges::find(sections, section) != sections.end()) {
      document.apply(input::parse_override(change));
    }
  }
}

input::Document load_vehicle(const std::string& name_or_path) {
  return input::Document::load(input::find_input(input::Shipped::vehicle, name_or_path));
}

}  // namespace

FlownVehicle flown_vehicle(const std::filesystem::path& log, const std::optional<std::string>& named) {
  if (named) {
    return {.document = load_vehicle(*named)};
  }
  const auto flown = logs::flown_airframe(log, {});
  if (!flown) {
    return {.why_unknown = "no summary.json beside the log names its rocket: use --vehicle NAME|FILE"};
  }
  // A path is one from the folder of a scenario that nobody names here: in this folder it may be another rocket's.
  if (const auto shipped = input::shipped_names(input::Shipped::vehicle);
      std::ranges::find(shipped, flown->vehicle_file) == shipped.end()) {
    return {.why_unknown = fmt::format("{} was flown with the vehicle \"{}\" of its scenario: give the path of that "
                                       "file from here with --vehicle",
                                       log.string(), flown->vehicle_file)};
  }
  input::Document document = load_vehicle(flown->vehicle_file);
  apply_changes(*flown, document);
  return {.document = std::move(document)};
}

}  // namespace fantail::tool
