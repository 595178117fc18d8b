// SPDX-License-Identifier: MIT
#include "fantail/standard_streams.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace fantail::tool {

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
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

bool output_was_taken() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
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
