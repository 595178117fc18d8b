// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "identify/model/roll_model.hpp"
#include "logs/read_csv.hpp"
#include "sim/roll_inertia_course.hpp"

namespace fantail::tool {

/// Whose inertia and reference area a roll model is identified with, as typed.
struct AirframeOptions {
  std::optional<std::string> vehicle;
  std::optional<double> inertia_kg_m2;
  std::optional<double> area_m2;
};

struct NamedAirframe {
  identify::model::Airframe airframe;
  std::string vehicle;                              ///< its name; empty: the numbers are from the command line
  std::string name;                                 ///< of the vehicle and where it is from; "from the command line"
  std::vector<std::string> warnings;                ///< a sentence each
  sim::RollInertiaCourse flown_inertia{};           ///< on the log's clock; empty: the airframe's throughout
  sim::RollInertiaCourse inertia_since_ignition{};  ///< likewise, of a vehicle that is named
  std::optional<bool> grows_with_mach{};  ///< alpha and beta in this flight, or in its vehicle; empty: unknown
};

/// --vehicle, --inertia and --area.
void add_airframe_options(const Verb& verb, AirframeOptions& options);

/// The numbers that are given, and the rest from the vehicle that is named or else from the summary of the flight in
/// `log`, which `reading` says how to read. Nobody's airframe is assumed. Throws UsageError when a number is not known,
/// text::Error for a bad vehicle, and as logs::flown_airframe() does.
[[nodiscard]] NamedAirframe named_airframe(const AirframeOptions& options, const std::filesystem::path& log,
                                           const logs::Reading& reading);

}  // namespace fantail::tool
