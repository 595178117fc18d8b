// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fantail::board {

inline constexpr int workers = 2;

/// All results of two processes that each do their part, in the order in which they come; there may be fewer than
/// `wanted` when one of them fails, which says why on stderr. Every ten seconds stderr tells how far they are.
template <typename Result>
std::vector<Result> by_two_workers(
    std::size_t wanted, const char* of_what,
    const std::function<void(int worker, const std::function<void(const Result&)>& tell)>& work) {
  static_assert(std::is_trivially_copyable_v<Result> && sizeof(Result) <= 4096);  // one write is one piece of a pipe
  using Clock = std::chrono::steady_clock;
  int ends[2]{};
  if (::pipe(ends) != 0) {
    throw std::runtime_error{"no pipe to the workers"};
  }
  std::vector<pid_t> children;
  for (int worker = 0; worker < workers; ++worker) {
    children.push_back(::fork());
    if (children.back() == 0) {
      ::close(ends[0]);
      try {
        work(worker, [&](const Result& result) { (void)!::write(ends[1], &result, sizeof result); });
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        ::_exit(1);
      }
      ::_exit(0);
    }
  }
  ::close(ends[1]);
  constexpr int progress_ms = 10'000;
  std::vector<Result> results;
  const auto began = Clock::now();
  double told_s = 0.0;
  for (;;) {
    pollfd waiting{.fd = ends[0], .events = POLLIN, .revents = 0};
    if (::poll(&waiting, 1, progress_ms) > 0) {
      Result result;
      if (::read(ends[0], &result, sizeof result) != sizeof result) {
        break;
      }
      results.push_back(result);
    }
    const double passed_s = std::chrono::duration<double>{Clock::now() - began}.count();
    if (passed_s > told_s + 1e-3 * progress_ms) {
      told_s = passed_s;
      const double rate = static_cast<double>(results.size()) / passed_s;
      std::fprintf(stderr, "%zu of %zu %s, %.1f a second, %.0f s left\n", results.size(), wanted, of_what, rate,
                   static_cast<double>(wanted - results.size()) / std::max(rate, 1e-3));
    }
  }
  ::close(ends[0]);
  for (const pid_t child : children) {
    ::waitpid(child, nullptr, 0);
  }
  return results;
}

}  // namespace fantail::board
