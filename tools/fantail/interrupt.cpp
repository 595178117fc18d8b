// SPDX-License-Identifier: MIT
#include "fantail/interrupt.hpp"

#include <csignal>

namespace fantail::tool {
namespace {

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

void catch_interrupts() {
  const auto mark = [](int) { interrupted = 1; };
  std::signal(SIGINT, mark);
  std::signal(SIGTERM, mark);
}

void give_up_if_interrupted() {
  if (interrupted != 0) {
    throw Interrupted{};
  }
}

}  // namespace fantail::tool
