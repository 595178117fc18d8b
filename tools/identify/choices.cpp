// SPDX-License-Identifier: MIT
#include "identify/choices.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "input/document.hpp"
#include "input/messages.hpp"
#include "sim/units.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using input::about;
using logs::RollLog;
using model::NodeTimes;
using text::Error;
using text::ErrorKind;

[[noreturn]] void refuse(const RollLog& log, const std::string& option, const std::string& text,
                         const std::string& why) {
  throw Error{ErrorKind::bad_data, fmt::format("{}: {} {}: {}", log.name, option, text, why)};
}

// "step:N" for the word "step:".
std::optional<std::size_t> count_behind(std::string_view word, std::string_view text, std::size_t least) {
  std::size_t count = 0;
  if (!text.starts_with(word)) {
    return {};
  }
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + word.size(), end, count);
  return error == std::errc{} && rest == end && count >= least ? std::optional{count} : std::nullopt;
}

std::vector<std::string> parts(const std::string& text, char between) {
  std::vector<std::string> list{""};
  for (const char c : text) {
    if (c == between) {
      list.emplace_back();
    } else {
      list.back() += c;
    }
  }
  return list;
}

struct SampleRange {
  std::size_t first;
  std::size_t last;  // included
};

SampleRange control(const RollLog& log, const std::string& text) {
  if (log.phase.empty()) {
    refuse(log, "--window", text,
           "no column phase, so the time under control is unknown; give seconds instead, as in --window 0.4:2");
  }
  std::optional<SampleRange> found;
  for (std::size_t i = 0; i < log.phase.size(); ++i) {
    if (log.phase[i] == core::Phase::controlling) {
      found = SampleRange{found ? found->first : i, i};
    }
  }
  if (!found) {
    refuse(log, "--window", text, "the phase is never \"controlling\"");
  }
  return *found;
}

Window between(const RollLog& log, SampleRange range, const std::string& text) {
  return {log.time_s[range.first], log.time_s[range.last], text};
}

double known_burnout_s(const RollLog& log, const std::string& option, const std::string& text) {
  const auto burnout = burnout_s(log);
  if (!burnout) {
    refuse(log, option, text, "burn-out is unknown: neither a summary nor the specific force shows it");
  }
  return *burnout;
}

Window thrust_or_coast(const RollLog& log, const std::string& text) {
  Window window = between(log, control(log, text), text);
  const double end_s = known_burnout_s(log, "--window", text);
  if (end_s <= *window.from_s || end_s >= *window.to_s) {
    refuse(log, "--window", text,
           fmt::format("the motor burnt out at {} s, which is not inside control, {} s to {} s", about(end_s),
                       about(*window.from_s), about(*window.to_s)));
  }
  (text == "thrust" ? window.to_s : window.from_s) = end_s;
  return window;
}

Window step(const RollLog& log, const std::string& text, std::size_t number) {
  const SampleRange all = control(log, text);
  if (log.reference_rad.empty()) {
    refuse(log, "--window", text, "no column reference_deg");
  }
  std::vector<std::size_t> changes;
  for (std::size_t i = all.first + 1; i <= all.last; ++i) {
    if (std::abs(log.reference_rad[i] - log.reference_rad[i - 1]) > 1e-6) {
      changes.push_back(i);
    }
  }
  if (number > changes.size()) {
    refuse(log, "--window", text,
           fmt::format("there is no such step; changes of the reference under control: {}", changes.size()));
  }
  return between(log, {changes[number - 1], number < changes.size() ? changes[number] - 1 : all.last}, text);
}

// "A:B" with either left out.
std::optional<Window> seconds(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || text.size() == 1) {
    return {};
  }
  const std::string from = text.substr(0, colon);
  const std::string to = text.substr(colon + 1);
  Window window{text::number(from), text::number(to), text};
  if ((!from.empty() && !window.from_s) || (!to.empty() && !window.to_s)) {
    return {};
  }
  return window;
}

NodeTimes thrust_and_coast(const RollLog& log, const model::Record& record, const std::string& text, std::size_t thrust,
                           std::size_t coast) {
  const double burnout = known_burnout_s(log, "--nodes", text);
  const double middle_s = burnout - record.window_begin_s;
  const double end_s = record.time_s.back();
  if (middle_s <= 0.0 || middle_s >= end_s) {
    refuse(log, "--nodes", text,
           fmt::format("the motor burnt out at {} s, which is outside the window {} of {} s to {} s", about(burnout),
                       record.window, about(record.window_begin_s), about(record.window_begin_s + end_s)));
  }
  NodeTimes times;
  for (std::size_t k = 0; k < thrust; ++k) {
    times.push_back(record.window_begin_s + middle_s * static_cast<double>(k) / static_cast<double>(thrust));
  }
  for (std::size_t k = 0; k <= coast; ++k) {
    times.push_back(burnout + (end_s - middle_s) * static_cast<double>(k) / static_cast<double>(coast));
  }
  return times;
}

std::optional<NodeTimes> increasing_times(const std::string& text) {
  NodeTimes times;
  for (const std::string& part : parts(text, ',')) {
    const auto time = text::number(part);
    if (!time || (!times.empty() && *time <= times.back())) {
      return {};
    }
    times.push_back(*time);
  }
  return times;
}

}  // namespace

Window find_window(const RollLog& log, const std::string& text) {
  if (text == "control") {
    return between(log, control(log, text), text);
  }
  if (text == "thrust" || text == "coast") {
    return thrust_or_coast(log, text);
  }
  if (const auto number = count_behind("step:", text, 1)) {
    return step(log, text, *number);
  }
  if (auto window = seconds(text)) {
    return *window;
  }
  std::string message = "--window " + text + ": unknown;";
  const std::array<std::string, 4> words{"control", "thrust", "coast", "step:1"};
  if (const auto meant = input::suggestion(text, words)) {
    message += " did you mean " + *meant + "?";
  }
  throw Error{ErrorKind::bad_configuration, message + " allowed: control, thrust, coast, step:N, A:B in seconds"};
}

std::vector<Window> find_windows(const RollLog& log, const std::vector<std::string>& texts) {
  std::vector<Window> all;
  all.reserve(texts.size());
  for (const std::string& text : texts) {
    all.push_back(find_window(log, text));
  }
  if (all.empty()) {
    const bool controlled = std::ranges::find(log.phase, core::Phase::controlling) != log.phase.end();
    all.push_back(controlled ? find_window(log, "control") : Window{.name = "all"});
  }
  return all;
}

std::optional<double> burnout_s(const RollLog& log) {
  if (log.burnout_s) {
    return log.burnout_s;
  }
  // A thrust that a launch detector would call one, then at least a tenth of a second of drag alone.
  constexpr double thrust_m_s2 = 1.5 * sim::gravity_m_s2;
  constexpr double for_good_s = 0.1;
  bool thrust = false;
  std::optional<double> below_since_s;
  for (std::size_t i = 0; i < log.specific_force_m_s2.size(); ++i) {
    const double force = log.specific_force_m_s2[i];
    if (force >= thrust_m_s2) {
      thrust = true;
    }
    if (!thrust || !(force < 0.0)) {
      below_since_s.reset();
    } else if (!below_since_s) {
      below_since_s = log.time_s[i];
    } else if (log.time_s[i] - *below_since_s >= for_good_s) {
      return below_since_s;
    }
  }
  return {};
}

NodeChoice find_nodes(const RollLog& log, const model::Record& record, const std::string& text) {
  constexpr std::size_t most_intervals = 100;
  const auto few = [](const std::optional<std::size_t>& count) { return count && *count <= most_intervals; };
  if (text == "auto") {
    return AutomaticNodes{};
  }
  if (const auto intervals = count_behind("even:", text, 0); few(intervals)) {
    return EvenNodes{*intervals};
  }
  if (const auto two = parts(text, ','); two.size() == 2) {
    const auto thrust = count_behind("thrust:", two[0], 1);
    const auto coast = count_behind("coast:", two[1], 1);
    if (few(thrust) && few(coast)) {
      return thrust_and_coast(log, record, text, *thrust, *coast);
    }
  }
  if (auto times = increasing_times(text)) {
    return *times;
  }
  throw Error{
      ErrorKind::bad_configuration,
      fmt::format(
          "--nodes {}: allowed: increasing seconds on the log's clock as in 0,5; even:N; thrust:N,coast:M; auto; with "
          "at most {} intervals",
          text, most_intervals)};
}

NodeChoice nodes_in(const model::Record& record, const NodeChoice& on_clock) {
  NodeChoice choice = on_clock;
  if (auto* times = std::get_if<NodeTimes>(&choice)) {
    for (double& time_s : *times) {
      time_s -= record.window_begin_s;
    }
  }
  return choice;
}

std::optional<model::Axis> parse_axis(const std::string& text) {
  constexpr double most_values = 1000.0;
  std::vector<double> numbers;
  for (const std::string& part : parts(text, ':')) {
    const auto value = text::number(part);
    if (!value || *value <= 0.0) {
      return {};
    }
    numbers.push_back(*value);
  }
  if (numbers.size() != 3 || numbers[1] < numbers[0] || (numbers[1] - numbers[0]) / numbers[2] > most_values - 1.0) {
    return {};
  }
  return model::Axis{.first = numbers[0], .last = numbers[1], .step = numbers[2]};
}

}  // namespace fantail::identify
