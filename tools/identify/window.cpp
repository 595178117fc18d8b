// SPDX-License-Identifier: MIT
#include "identify/window.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "sim/input/document.hpp"
#include "sim/input/messages.hpp"
#include "sim/input_error.hpp"
#include "sim/units.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using logs::RollLog;
using sim::InputError;
using sim::InputFault;

[[noreturn]] void refuse(const RollLog& log, const std::string& text, const std::string& why) {
  throw InputError{InputFault::bad_data, fmt::format("{}: --window {}: {}", log.name, text, why)};
}

struct Stretch {
  std::size_t first;
  std::size_t last;  // included
};

Stretch control(const RollLog& log, const std::string& text) {
  if (log.phase.empty()) {
    refuse(log, text,
           "there is no column phase that says when control was; give seconds instead, as in --window 0.4:2");
  }
  std::optional<Stretch> found;
  for (std::size_t i = 0; i < log.phase.size(); ++i) {
    if (log.phase[i] == core::Phase::controlling) {
      found = Stretch{found ? found->first : i, i};
    }
  }
  if (!found) {
    refuse(log, text, "the phase is never \"controlling\"");
  }
  return *found;
}

Window between(const RollLog& log, Stretch stretch, const std::string& text) {
  return {log.time_s[stretch.first], log.time_s[stretch.last], text};
}

Window thrust_or_coast(const RollLog& log, const std::string& text) {
  Window window = between(log, control(log, text), text);
  const auto end_s = burnout_s(log);
  if (!end_s) {
    refuse(log, text, "neither a summary nor the specific force says when the motor burnt out");
  }
  if (*end_s <= *window.from_s || *end_s >= *window.to_s) {
    refuse(log, text,
           fmt::format("the motor burnt out at {} s, control was from {} s to {} s", sim::input::about(*end_s),
                       sim::input::about(*window.from_s), sim::input::about(*window.to_s)));
  }
  (text == "thrust" ? window.to_s : window.from_s) = end_s;
  return window;
}

Window step(const RollLog& log, const std::string& text, std::size_t number) {
  const Stretch all = control(log, text);
  if (log.reference_rad.empty()) {
    refuse(log, text, "there is no column reference_deg that steps");
  }
  std::vector<std::size_t> changes;
  for (std::size_t i = all.first + 1; i <= all.last; ++i) {
    if (std::abs(log.reference_rad[i] - log.reference_rad[i - 1]) > 1e-6) {
      changes.push_back(i);
    }
  }
  if (number > changes.size()) {
    refuse(log, text, fmt::format("the reference changes {} times under control", changes.size()));
  }
  return between(log, {changes[number - 1], number < changes.size() ? changes[number] - 1 : all.last}, text);
}

std::optional<std::size_t> step_number(const std::string& text) {
  std::size_t number = 0;
  constexpr std::size_t prefix = 5;
  const char* const end = text.data() + text.size();
  if (!text.starts_with("step:")) {
    return {};
  }
  const auto [rest, error] = std::from_chars(text.data() + prefix, end, number);
  return error == std::errc{} && rest == end && number > 0 ? std::optional{number} : std::nullopt;
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

}  // namespace

Window find_window(const RollLog& log, const std::string& text) {
  if (text == "control") {
    return between(log, control(log, text), text);
  }
  if (text == "thrust" || text == "coast") {
    return thrust_or_coast(log, text);
  }
  if (const auto number = step_number(text)) {
    return step(log, text, *number);
  }
  if (auto window = seconds(text)) {
    return *window;
  }
  std::string message = "--window " + text + ": unknown;";
  const std::array<std::string, 4> words{"control", "thrust", "coast", "step:1"};
  if (const auto meant = sim::input::suggestion(text, words)) {
    message += " did you mean " + *meant + "?";
  }
  throw InputError{InputFault::bad_configuration, message + " allowed: control, thrust, coast, step:N, A:B in seconds"};
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

}  // namespace fantail::identify
