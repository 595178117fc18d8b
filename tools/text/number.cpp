// SPDX-License-Identifier: MIT
#include "text/number.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/core.h>

namespace fantail::text {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) {
    text.remove_suffix(1);
  }
  return text;
}

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  // decimal() knows no plus sign; "+-1" must stay no number.
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);
  }
  const std::optional<double> value = decimal(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<bool> flag(std::string_view text) {
  std::string word{trimmed(text)};
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (word == "true" || word == "yes") {
    return true;
  }
  if (word == "false" || word == "no") {
    return false;
  }
  const std::optional<double> value = number(word);
  return value == 1.0 || value == 0.0 ? std::optional{value == 1.0} : std::nullopt;
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && rest == text.data() + text.size() ? std::optional{value} : std::nullopt;
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) {
    return "not a number";
  }
  constexpr double most = 1e15;  // a double has no decimals beyond it
  std::string text = std::abs(value) < most ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.4g}", value);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) {
    text.erase(0, 1);
  }
  return text;
}

std::string brief(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text;
}

std::string counted(std::uint64_t number, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", number, number == 1 ? std::string{one} : many.empty() ? fmt::format("{}s", one) : many);
}

std::string with_minus(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    const bool number = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    result += text[i] == '-' && begins && number ? std::string_view{"\u2212"} : text.substr(i, 1);
  }
  return result;
}

}  // namespace fantail::text
