// SPDX-License-Identifier: MIT
#include "fantail/progress.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

#include "fantail/standard_streams.hpp"

namespace fantail::tool {
namespace {

constexpr std::chrono::seconds in_a_pipe{10};
constexpr std::chrono::milliseconds on_a_terminal{500};

bool is_on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

// "0.6" below ten: of three chapters in five seconds nothing else would be left.
std::string rounded(double rate) { return rate < 9.5 ? fmt::format("{:.2g}", rate) : fmt::format("{:.0f}", rate); }

// "2.6 of 3.3": rounded, little that goes slowly would look done, with much to go.
int decimals(double total) { return total < 20.0 && total != std::round(total) ? 1 : 0; }

std::string duration(double seconds) {
  return seconds < 119.5 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60.0);
}

}  // namespace

std::string progress_line(std::string_view what, const Progress::Measure& measure, double done, double elapsed_s) {
  // What was expected beforehand may turn out to be too little.
  const double total = measure.total.value_or(0.0);
  const bool is_enough = total >= done && total > 0.0;
  const int places = decimals(total);
  std::string line = fmt::format("{}: {:.{}f}", what, done, places);
  line += is_enough ? fmt::format(" of {:.{}f} {}", total, places, measure.unit) : fmt::format(" {}", measure.unit);
  const double rate = done / elapsed_s;
  if (rate > 0.0) {
    line += ", " + rounded(rate) + std::string{measure.rate};
    line += is_enough ? ", " + duration((total - done) / rate) + " to go" : "";
  }
  return line;
}

std::string chapter_line(std::string_view what, std::string_view name, std::size_t chapter, std::size_t count,
                         double elapsed_s) {
  const std::string part = count > 1 ? fmt::format(" (part {} of {})", chapter, count) : "";
  return fmt::format("{}: {}{}, {}", what, name, part, duration(elapsed_s));
}

Progress::Progress(std::string what, const Measure& measure)
    : what_{std::move(what)},
      measure_{measure},
      terminal_{is_on_terminal()},
      next_{start_ + (terminal_ ? on_a_terminal : in_a_pipe)} {}

Progress::~Progress() {
  if (shown_) {
    say_for_now("");
  }
}

void Progress::show(double done) {
  const auto now = Clock::now();
  if (now < next_) {
    return;
  }
  const std::string line = progress_line(what_, measure_, done, std::chrono::duration<double>(now - start_).count());
  if (!terminal_) {
    say(line + "\n");
    next_ = now + in_a_pipe;
    return;
  }
  say_for_now(line);
  shown_ = true;
  next_ = now + std::chrono::milliseconds{100};
}

Chapters::Chapters(std::string what, std::size_t count, std::string first)
    : what_{std::move(what)},
      count_{count},
      terminal_{is_on_terminal()},
      name_{std::move(first)},
      shows_{[this](const std::stop_token& stop) { show_until(stop); }} {}

void Chapters::next(std::string name) {
  const std::lock_guard lock{mutex_};
  chapter_ += 1;
  name_ = std::move(name);
}

void Chapters::now(std::string name) {
  const std::lock_guard lock{mutex_};
  name_ = std::move(name);
}

void Chapters::end() {
  if (shows_.joinable()) {
    shows_.request_stop();
    shows_.join();
  }
}

void Chapters::show_until(const std::stop_token& stop) {
  const auto stopped = [&stop] { return stop.stop_requested(); };
  std::unique_lock lock{mutex_};
  for (auto next = start_ + (terminal_ ? on_a_terminal : in_a_pipe); !wake_.wait_until(lock, stop, next, stopped);
       next += terminal_ ? on_a_terminal : in_a_pipe) {
    const std::string line =
        chapter_line(what_, name_, chapter_, count_, std::chrono::duration<double>(Clock::now() - start_).count());
    if (terminal_) {
      say_for_now(line);
    } else {
      say(line + "\n");
    }
  }
  if (terminal_) {
    say_for_now("");
  }
}

}  // namespace fantail::tool
