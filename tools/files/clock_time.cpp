// SPDX-License-Identifier: MIT
#include "files/clock_time.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "text/number.hpp"

namespace fantail::files {
namespace {

/// A whole number in front, up to this sign, which is taken off, too.
std::optional<unsigned> part(std::string_view& text, char end) {
  const std::size_t at = text.find(end);
  if (at == std::string_view::npos || at == 0 || at > 4) {
    return std::nullopt;
  }
  const auto number = text::whole_number(text.substr(0, at));
  text.remove_prefix(at + 1);
  return number ? std::optional{static_cast<unsigned>(*number)} : std::nullopt;
}

std::optional<double> time_of_day_s(std::string_view text) {
  const auto hours = part(text, ':');
  if (!hours || *hours > 23) {
    return std::nullopt;
  }
  const auto minutes = part(text, ':');
  if (!minutes || *minutes > 59) {
    return std::nullopt;
  }
  std::string rest{text};
  std::ranges::replace(rest, ',', '.');
  const auto seconds = text::number(rest);
  if (!seconds || !(*seconds >= 0.0 && *seconds < 61.0)) {
    return std::nullopt;
  }
  return 3600.0 * *hours + 60.0 * *minutes + *seconds;
}

}  // namespace

std::optional<double> clock_time_s(std::string_view text) {
  text = text::trimmed(text);
  if (text.ends_with('Z')) {
    text.remove_suffix(1);
  }
  const std::size_t middle = text.find_first_of(" T");
  if (middle == std::string_view::npos) {
    return time_of_day_s(text);
  }
  std::string_view date = text.substr(0, middle);
  std::string with_end{date};
  const char sign = date.find('/') != std::string_view::npos ? '/' : '-';
  with_end += sign;
  std::string_view rest = with_end;
  const auto year = part(rest, sign);
  if (!year || *year < 1970) {
    return std::nullopt;
  }
  const auto month = part(rest, sign);
  if (!month) {
    return std::nullopt;
  }
  const auto day = part(rest, sign);
  const auto time_s = time_of_day_s(text::trimmed(text.substr(middle + 1)));
  if (!day || !time_s) {
    return std::nullopt;
  }
  const std::chrono::year_month_day on{std::chrono::year{static_cast<int>(*year)}, std::chrono::month{*month},
                                       std::chrono::day{*day}};
  if (!on.ok()) {
    return std::nullopt;
  }
  return 86'400.0 * static_cast<double>(std::chrono::sys_days{on}.time_since_epoch().count()) + *time_s;
}

}  // namespace fantail::files
