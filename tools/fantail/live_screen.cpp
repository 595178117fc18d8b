// SPDX-License-Identifier: MIT
#include "fantail/live_screen.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <unistd.h>

#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "text/layout.hpp"

namespace fantail::tool {

std::string live_frame(const std::string& text, std::size_t columns, std::size_t rows) {
  std::vector<std::string> lines;
  const std::string fitting = text::wrapped(text, columns);
  for (std::size_t begin = 0; begin < fitting.size();) {
    const std::size_t end = std::min(fitting.find('\n', begin), fitting.size());
    lines.push_back(fitting.substr(begin, end - begin));
    begin = end + 1;
  }
  if (lines.size() > rows) {
    const std::size_t hidden = lines.size() - rows + 1;
    lines.resize(rows - 1);
    lines.push_back(fmt::format("({} more lines: the terminal is too low)", hidden));
  }
  // Without a cursor meanwhile, and without lines that the terminal breaks: a word that is too wide would move those
  // below.
  std::string frame = "\033[?2026h\033[?25l\033[?7l\033[H";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    frame += (i == 0 ? "" : "\r\n") + lines[i] + "\033[K";
  }
  return frame + "\033[J\033[?7h\033[?25h\033[?2026l";
}

namespace {

constexpr std::string_view enter = "\033[?1049h";
constexpr std::string_view leave = "\033[?1049l";

void write_at_once(std::string_view text) {
  if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) {
    return;  // in a signal's handler there is nobody to tell
  }
}

void handle(int signal, void (*handler)(int));

// Ctrl-Z or Ctrl-\: the shell gets its own screen back, and the program the alternate one when it goes on.
void leave_meanwhile(int signal) {
  const int error = errno;
  write_at_once(leave);
  handle(signal, SIG_DFL);
  std::raise(signal);
  handle(signal, leave_meanwhile);
  write_at_once(enter);
  errno = error;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = SA_NODEFER | SA_RESTART;  // it raises the signal that it handles
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

LiveScreen::LiveScreen() {
  fmt::print("{}", enter);
  handle(SIGTSTP, leave_meanwhile);
  handle(SIGQUIT, leave_meanwhile);
}

LiveScreen::~LiveScreen() {
  handle(SIGTSTP, SIG_DFL);
  handle(SIGQUIT, SIG_DFL);
  if (!show_live(std::string{leave} + text::wrapped(last_, output_columns()))) {
    return;  // the end of the program says what standard output did not take
  }
}

bool LiveScreen::draw(const std::string& text) {
  last_ = text;
  return show_live(live_frame(text, output_columns(), output_rows()));
}

}  // namespace fantail::tool
