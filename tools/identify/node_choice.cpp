// SPDX-License-Identifier: MIT
#include "identify/node_choice.hpp"

#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "identify/window.hpp"
#include "sim/input/messages.hpp"
#include "sim/input_error.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using sim::InputError;
using sim::InputFault;

constexpr std::size_t most_intervals = 100;

std::vector<std::string_view> parts(std::string_view text) {
  std::vector<std::string_view> list;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
    list.push_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  list.push_back(text);
  return list;
}

std::optional<std::size_t> count_behind(std::string_view word, std::string_view text, std::size_t least) {
  std::size_t count = 0;
  if (!text.starts_with(word)) {
    return {};
  }
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + word.size(), end, count);
  const bool good = error == std::errc{} && rest == end && count >= least && count <= most_intervals;
  return good ? std::optional{count} : std::nullopt;
}

NodeTimes thrust_and_coast(const logs::RollLog& log, const Record& record, const std::string& text, std::size_t thrust,
                           std::size_t coast) {
  const auto burnout = burnout_s(log);
  if (!burnout) {
    throw InputError{
        InputFault::bad_data,
        fmt::format("{}: --nodes {}: neither a summary nor the specific force says when the motor burnt out", log.name,
                    text)};
  }
  const double middle_s = *burnout - record.window_begin_s;
  const double end_s = record.time_s.back();
  if (middle_s <= 0.0 || middle_s >= end_s) {
    throw InputError{
        InputFault::bad_data,
        fmt::format("{}: --nodes {}: the motor burnt out at {} s, which is outside the window {} of {} s to "
                    "{} s",
                    log.name, text, sim::input::about(*burnout), record.window,
                    sim::input::about(record.window_begin_s), sim::input::about(record.window_begin_s + end_s))};
  }
  NodeTimes times;
  for (std::size_t k = 0; k < thrust; ++k) {
    times.push_back(middle_s * static_cast<double>(k) / static_cast<double>(thrust));
  }
  for (std::size_t k = 0; k <= coast; ++k) {
    times.push_back(middle_s + (end_s - middle_s) * static_cast<double>(k) / static_cast<double>(coast));
  }
  return times;
}

std::optional<NodeTimes> seconds(const std::string& text) {
  NodeTimes times;
  for (const std::string_view part : parts(text)) {
    const auto time = text::number(part);
    if (!time || (!times.empty() && *time <= times.back())) {
      return {};
    }
    times.push_back(*time);
  }
  return times;
}

}  // namespace

NodeChoice find_nodes(const logs::RollLog& log, const Record& record, const std::string& text) {
  if (text == "auto") {
    return AutomaticNodes{};
  }
  if (const auto intervals = count_behind("even:", text, 0)) {
    return EvenNodes{*intervals};
  }
  if (const auto two = parts(text); two.size() == 2) {
    const auto thrust = count_behind("thrust:", two[0], 1);
    const auto coast = count_behind("coast:", two[1], 1);
    if (thrust && coast) {
      return thrust_and_coast(log, record, text, *thrust, *coast);
    }
  }
  if (auto times = seconds(text)) {
    return *times;
  }
  throw InputError{
      InputFault::bad_configuration,
      fmt::format("--nodes {}: allowed: increasing seconds as in 0,5; even:N; thrust:N,coast:M; auto; with "
                  "at most {} intervals",
                  text, most_intervals)};
}

}  // namespace fantail::identify
