// SPDX-License-Identifier: MIT
#include "fantail/progress.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "fantail/standard_streams.hpp"

namespace fantail::tool {

Progress::Progress(std::string what, std::optional<double> total_s)
    : what_{std::move(what)}, total_s_{total_s}, terminal_{::isatty(STDERR_FILENO) == 1} {}

Progress::~Progress() {
  if (shown_) {
    say("\r\033[K");
  }
}

void Progress::show(double done_s) {
  const auto now = Clock::now();
  if (!terminal_ || now < next_) {
    return;
  }
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double rate = done_s / elapsed_s;
  std::string line = fmt::format("{}: {:.0f} s, {:.0f} x real time", what_, done_s, rate);
  if (total_s_ && rate > 0.0) {
    line += fmt::format(", {:.0f} s to go", std::max(0.0, *total_s_ - done_s) / rate);
  }
  say("\r\033[K" + line);
  shown_ = true;
  next_ = now + std::chrono::milliseconds{100};
}

}  // namespace fantail::tool
