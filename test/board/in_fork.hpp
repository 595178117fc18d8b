// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <type_traits>

#include <sys/wait.h>
#include <unistd.h>

namespace fantail::board {

/// What `find_out` answers in a process of its own, which has everything as it is now; here nothing changes. Empty when
/// that process came to no end: it was killed, or it took longer than `at_most_s`.
template <typename Found, typename FindOut>
std::optional<Found> in_fork(unsigned at_most_s, const FindOut& find_out) {
  static_assert(std::is_trivially_copyable_v<Found>);
  int ends[2]{};
  if (::pipe(ends) != 0) {
    return std::nullopt;
  }
  const pid_t child = ::fork();
  if (child == 0) {
    (void)std::signal(SIGALRM, SIG_DFL);
    ::alarm(at_most_s);
    const Found found = find_out();
    const char* next = reinterpret_cast<const char*>(&found);
    for (std::size_t left = sizeof found; left > 0;) {
      const ssize_t written = ::write(ends[1], next, left);
      if (written <= 0) {
        ::_exit(1);
      }
      next += written;
      left -= static_cast<std::size_t>(written);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  Found found{};
  std::size_t had = 0;
  while (had < sizeof found) {
    const ssize_t got = ::read(ends[0], reinterpret_cast<char*>(&found) + had, sizeof found - had);
    if (got <= 0) {
      break;
    }
    had += static_cast<std::size_t>(got);
  }
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) {
    std::fprintf(stderr, "a process that had to find out was ended by signal %d\n", WTERMSIG(status));
  }
  return had == sizeof found ? std::optional{found} : std::nullopt;
}

}  // namespace fantail::board
