// SPDX-License-Identifier: MIT
#include "fantail/progress.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

#include "fantail/standard_streams.hpp"

namespace fantail::tool {
namespace {

constexpr std::chrono::seconds in_a_pipe{10};

}  // namespace

Progress::Progress(std::string what, const Measure& measure)
    : what_{std::move(what)},
      measure_{measure},
      terminal_{::isatty(STDERR_FILENO) == 1},
      next_{start_ + (terminal_ ? std::chrono::milliseconds{500} : in_a_pipe)} {}

Progress::~Progress() {
  if (shown_) {
    say("\r\033[K");
  }
}

void Progress::show(double done) {
  const auto now = Clock::now();
  if (now < next_) {
    return;
  }
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double rate = done / elapsed_s;
  std::string line = fmt::format("{}: {:.0f} {}, {:.0f}{}", what_, done, measure_.unit, rate, measure_.rate);
  if (measure_.total && rate > 0.0) {
    line += fmt::format(", {:.0f} s to go", std::max(0.0, *measure_.total - done) / rate);
  }
  if (!terminal_) {
    say(line + "\n");
    next_ = now + in_a_pipe;
    return;
  }
  say("\r\033[K" + line);
  shown_ = true;
  next_ = now + std::chrono::milliseconds{100};
}

}  // namespace fantail::tool
