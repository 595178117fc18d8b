// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "detection/report.hpp"
#include "page/chart.hpp"

namespace fantail::detection {

/// Of the rules, in their order, in every figure.
inline constexpr std::array<page::Role, 4> roles{page::Role::measured, page::Role::model, page::Role::second_model,
                                                 page::Role::target};

/// One event of a campaign again, tick by tick.
struct ShownEvent {
  std::string verdict{};  ///< in a sentence: who moves canards, or who detects
  bool is_bad = false;    ///< a judged rule moves a canard without a launch, or misses one with both well
  std::vector<std::string> sentences{};  ///< what happens in it and what each rule makes of it
  std::vector<result::Picture>
      pictures{};  ///< what the accelerometers read, and speed and way that each rule believed in
};
[[nodiscard]] ShownEvent show_event(const Campaign& campaign, Kind kind, std::uint64_t event);
[[nodiscard]] result::Document event_answer(const Campaign& campaign, Kind kind, std::uint64_t event,
                                            const result::Made& made);

/// Of the events that are no launch the one that came nearest to moving a canard of the rule; empty: none came near.
[[nodiscard]] std::optional<result::Section> worst_event(const Report& report, std::size_t rule);

}  // namespace fantail::detection
