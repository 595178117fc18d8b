// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flight_log/flight_figures.hpp"
#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"
#include "result/answer.hpp"

namespace fantail::tool {

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
