// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "detection/campaign.hpp"

namespace fantail::detection {

/// One event of a campaign again, tick by tick.
struct ShownEvent {
  std::string text;          ///< what happens in it and what each rule makes of it
  std::string figures_html;  ///< what the accelerometers read, and speed and way that each rule believed in
};
[[nodiscard]] ShownEvent show_event(const Campaign& campaign, Kind kind, std::uint64_t event);

/// A page of its own.
[[nodiscard]] std::string event_html(const Campaign& campaign, Kind kind, std::uint64_t event, const ShownEvent& shown);

}  // namespace fantail::detection
