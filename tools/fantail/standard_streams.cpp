// SPDX-License-Identifier: MIT
#include "fantail/standard_streams.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "fantail/terminal.hpp"
#include "text/layout.hpp"

namespace fantail::tool {
namespace {

std::atomic<bool> line_is_for_now = false;
std::function<void(std::string_view)> listener{};
constexpr const char* take_away = "\r\033[K";

}  // namespace

void guard_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1) {
      open("/dev/null", O_RDONLY);  // takes the lowest free number, which is this one; cannot be written to
    }
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void say(std::string_view text) {
  if (listener) {
    listener(text);
    return;
  }
  const std::string whole = (line_is_for_now.exchange(false) ? take_away : "") +
                            text::wrapped(without_controls(text), columns_of(STDERR_FILENO));
  std::fwrite(whole.data(), 1, whole.size(), stderr);
  std::fflush(stderr);
}

void hear_instead(std::function<void(std::string_view)> who) { listener = std::move(who); }

void say_for_now(std::string_view line) {
  if (listener) {
    return;
  }
  if (line.empty() && !line_is_for_now.exchange(false)) {
    return;
  }
  // A line that the terminal breaks would stay when the next is drawn.
  const std::string whole = take_away + without_controls(line.substr(0, columns_of(STDERR_FILENO) - 1));
  std::fwrite(whole.data(), 1, whole.size(), stderr);
  std::fflush(stderr);
  line_is_for_now = !line.empty();
}

bool output_was_taken() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
}

ExitCode complain_about_output() {
  pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  if (poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0) {
    return ExitCode::pipe_closed;
  }
  say("fantail: standard output could not be written\n");
  return ExitCode::input_output;
}

bool show_live(const std::string& text) {
  errno = 0;
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) == 0) {
    return true;
  }
  if (errno == EPIPE && std::freopen("/dev/null", "w", stdout) == nullptr) {
    errno = EIO;  // the end of the program will say that standard output was not taken
  }
  return false;
}

}  // namespace fantail::tool
