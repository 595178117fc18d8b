// SPDX-License-Identifier: MIT
#pragma once

#include <sched.h>
#include <sys/types.h>

namespace fantail::hil {

/// While it exists, the thread that made it, and every process that this thread starts, share one processor. Two
/// processes that take turns, as world and emulator do, are much quicker that way: on two, each turn wakes a processor
/// that has gone to sleep.
class OneProcessor {
 public:
  OneProcessor();
  ~OneProcessor();
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  pid_t thread_;
  cpu_set_t before_{};
  bool bound_ = false;
};

}  // namespace fantail::hil
