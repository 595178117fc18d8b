// SPDX-License-Identifier: MIT
#include "fantail/number_option.hpp"

#include <string>

#include <fmt/format.h>

#include "logs/number.hpp"
#include "sim/shown.hpp"

namespace fantail::tool {

CLI::Validator within(double low, double high) {
  return CLI::Validator{[low, high](const std::string& text) {
                          const auto value = logs::number(text);
                          return value && *value >= low && *value <= high
                                     ? std::string{}
                                     : fmt::format("\"{}\": allowed: {} to {}", text, sim::shown(low),
                                                   sim::shown(high));
                        },
                        ""};
}

}  // namespace fantail::tool
