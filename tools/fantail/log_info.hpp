// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fantail/command_line.hpp"
#include "flight_log/flight_figures.hpp"
#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"
#include "result/answer.hpp"

namespace fantail::tool {

/// Of the flights in a file the one that a person chose, counted from 1; without a choice the only one. It is moved out
/// of the file, the rest stays. Throws UsageError that says how many there are.
[[nodiscard]] flight_log::Flight take_flight(flight_log::LogFile& file, const std::optional<std::size_t>& choice);

/// Adds --flight N, of which take_flight() says how many there are.
void add_flight_choice(const Verb& verb, std::optional<std::size_t>& choice, const std::string& without = "");

/// What a log, or a folder with one, is called where its results are named: "flown" for flown.ftl, the folder for
/// flight.ftl and flight.csv.
[[nodiscard]] std::string name_of_log(const std::filesystem::path& path);

// What fantail log can do, each in its own file.

void add_log_export(const Verb& log);
void add_log_info(const Verb& log);

/// What fantail log info says of one flight.
struct FlightInfo {
  const flight_log::Flight& flight;
  flight_log::Regeneration replay;
  std::optional<flight_log::LoopTimes> loop;
  std::optional<flight_log::HealthFigures> health;
  core::Microseconds zero{};  ///< what times count from
  std::string_view zero_text{};
  std::string plan;  ///< its name

  [[nodiscard]] double seconds(core::Microseconds time) const {
    return static_cast<double>((time - zero).count()) / 1e6;  // the double nearest to the microseconds
  }
};

/// The flight outlives what is returned.
[[nodiscard]] FlightInfo flight_info(const flight_log::Flight& flight);

[[nodiscard]] std::string log_info_text(const FlightInfo& info);
/// Is it intact?
[[nodiscard]] std::string log_info_json(const flight_log::LogFile& file, const std::vector<FlightInfo>& flights,
                                        const result::Made& made);

}  // namespace fantail::tool
