// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "link/log_download.hpp"

namespace fantail::tool {

struct FlightFile {
  std::string name;  ///< in the folder
  link::RecordedFlight flight;
};

/// Writes each flight of a record as flight_001.ftl and so on into the folder, all of them or none. `first` is the
/// number of the first one. No file is ever overwritten with another flight: one that is there already keeps its name,
/// and one whose name is taken gets the next number that is free. A record without any intact frame becomes
/// unreadable_001.bin.
std::vector<FlightFile> write_flights(const std::filesystem::path& folder, std::span<const std::byte> record,
                                      std::size_t first);

}  // namespace fantail::tool
