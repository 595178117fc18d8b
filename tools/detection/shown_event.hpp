// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "detection/campaign.hpp"
#include "page/chart.hpp"

namespace fantail::detection {

/// Of the rules, in their order, in every figure.
inline constexpr std::array<page::Role, 4> roles{page::Role::measured, page::Role::model, page::Role::second_model,
                                                 page::Role::target};

/// One event of a campaign again, tick by tick.
struct ShownEvent {
  std::string verdict;       ///< in a sentence: who moves canards, or who detects
  bool is_bad = false;       ///< a judged rule moves a canard without a launch, or misses one with both well
  std::string text;          ///< what happens in it and what each rule makes of it
  std::string figures_html;  ///< what the accelerometers read, and speed and way that each rule believed in
};
[[nodiscard]] ShownEvent show_event(const Campaign& campaign, Kind kind, std::uint64_t event);

/// Its text for a page, a line each.
[[nodiscard]] std::string sentences_html(const ShownEvent& shown);

/// A page of its own.
[[nodiscard]] std::string event_html(const Campaign& campaign, Kind kind, std::uint64_t event, const ShownEvent& shown);

}  // namespace fantail::detection
