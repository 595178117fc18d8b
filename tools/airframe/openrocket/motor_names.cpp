// SPDX-License-Identifier: MIT
// Which motor of a design a file of thrust is about.
#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <string_view>

#include "airframe/openrocket/read.hpp"

namespace fantail::airframe::openrocket {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

/// "I150" of "1115-i150WH-14A": a letter that no letter precedes, and its digits. All of it where there is none.
std::string class_and_thrust(std::string_view name) {
  for (std::size_t i = 0; i + 1 < name.size(); ++i) {
    if (is_letter(name[i]) && is_digit(name[i + 1]) && (i == 0 || !is_letter(name[i - 1]))) {
      const auto* const end = std::find_if_not(name.begin() + static_cast<std::ptrdiff_t>(i) + 1, name.end(), is_digit);
      return upper(name[i]) + std::string{name.begin() + i + 1, end};
    }
  }
  std::string all{name};
  std::ranges::transform(all, all.begin(), upper);
  return all;
}

}  // namespace

std::vector<NamedMotor> MotorPlace::called(const std::string& name) const {
  std::vector<NamedMotor> found;
  std::ranges::copy_if(motors, std::back_inserter(found), [&](const NamedMotor& motor) {
    return class_and_thrust(motor.designation) == class_and_thrust(name);
  });
  return found;
}

}  // namespace fantail::airframe::openrocket
