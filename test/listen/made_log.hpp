// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/flight_plan_members.hpp"
#include "figures.hpp"
#include "json/value.hpp"
#include "listen/answer.hpp"
#include "listen/fly_log.hpp"

// Logs that somebody might have made, and what is said of them.
namespace fantail::listen::made {

inline constexpr double g = 9.80665;

inline Signal signal(double end_s, double interval_s, const std::function<double(double)>& value) {
  Signal made{.words = "a"};
  for (int i = 0; i * interval_s <= end_s + 1e-9; ++i) {
    made.time_s.push_back(i * interval_s);
    made.value.push_back(value(i * interval_s + 1e-9));
  }
  return made;
}

inline ImuLog log_of(Signal axial, double interval_s = 0.01) {
  ImuLog log{.name = "made.csv", .rows = axial.time_s.size(), .axial = std::move(axial), .interval_s = interval_s};
  return log;
}

inline Question question() { return {.plan_name = "default", .plan = core::default_plan()}; }

// 5 s on the pad, 5 g for 2 s, free fall.
inline double constant_push(double t) { return t < 5.0 ? g : t < 7.0 ? 5.0 * g : 0.0; }

/// Has one of them this word, and these numbers one behind the other?
inline bool has(const std::vector<std::string>& sentences, const std::string& word, const Numbers& numbers = {}) {
  return std::ranges::any_of(sentences, [&](const std::string& one) {
    return fantail::says(one, word) && (numbers.empty() || tells(one, numbers));
  });
}

inline std::string text_of(const Heard& heard) { return result::text(answer(heard, {})); }
inline std::string page_of(const Heard& heard) { return result::html(answer(heard, {})); }
inline json::Value data_of(const Heard& heard) { return json::parse(result::json(answer(heard, {}))); }

inline bool says(const Heard& heard, const std::string& word, const Numbers& numbers = {}) {
  return has(heard.notes, word, numbers);
}
inline bool doubts(const Heard& heard, const std::string& word, const Numbers& numbers = {}) {
  return has(heard.doubts, word, numbers);
}
/// Of the note with this word.
inline Numbers note_figures(const Heard& heard, const std::string& word) {
  const auto has_it = [&](const std::string& note) { return note.find(word) != std::string::npos; };
  const auto found = std::ranges::find_if(heard.notes, has_it);
  return found == heard.notes.end() ? Numbers{} : figures(*found);
}

}  // namespace fantail::listen::made
