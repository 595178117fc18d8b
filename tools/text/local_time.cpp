// SPDX-License-Identifier: MIT
#include "text/local_time.hpp"

#include <fmt/chrono.h>

namespace fantail::text {

std::string local_minute(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%d %H:%M UTC%z}", fmt::localtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace fantail::text
