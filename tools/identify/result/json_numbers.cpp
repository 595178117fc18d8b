// SPDX-License-Identifier: MIT
#include "identify/result/json_numbers.hpp"

#include <charconv>
#include <optional>
#include <string>

#include <fmt/core.h>

namespace fantail::identify::result {

using Json = json::Value;

double rounded(double value) {
  double result = value;
  const std::string text = fmt::format("{:.8g}", value);
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result == 0.0 ? 0.0 : result;
}

Json list(const std::vector<double>& values, double scale) {
  Json out = Json::array();
  for (const double value : values) {
    out.push_back(rounded(scale * value));
  }
  return out;
}

Json pair(const Interval& interval, double scale) {
  const auto end = [&](const std::optional<double>& value) { return value ? rounded(scale * *value) : Json{}; };
  return Json::array({end(interval.low), end(interval.high)});
}

}  // namespace fantail::identify::result
