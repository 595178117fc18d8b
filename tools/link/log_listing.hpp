// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "link/log_download.hpp"

namespace fantail::link {

/// A flight in the avionics' record, of which only the beginning has been read.
struct ListedFlight {
  LogStretch stretch{};  ///< up to the next one, or to the end of the record
  std::string vehicle{};
  std::uint32_t power_up = 0;
};

/// Looks where flights begin. Each begins on a fresh sector with its header, so the first bytes of every sector are
/// asked for: 3 MB take some 20 s. A flight whose first header is damaged is taken for a part of the one before it.
/// `progress` is told the bytes looked through.
[[nodiscard]] std::vector<ListedFlight> list_flights(LogReader& reader, std::uint32_t used_bytes,
                                                     const std::function<void(std::uint32_t)>& progress);

}  // namespace fantail::link
