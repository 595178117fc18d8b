// SPDX-License-Identifier: MIT
#include <csignal>
#include <initializer_list>
#include <string>

#include "fantail/progress.hpp"
#include "fantail/standard_streams.hpp"
#include "text/input_file.hpp"

namespace fantail::tool {
namespace {

volatile std::sig_atomic_t interrupted = 0;
void (*also_give_up)() = [] {};

}  // namespace

void catch_interrupts() {
  const auto mark = [](int) { interrupted = 1; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // nohup and the background jobs of a shell ignore some from the start, and mean it.
    if (std::signal(signal, mark) == SIG_IGN) {
      std::signal(signal, SIG_IGN);
    }
  }
  text::check_while_reading(give_up_if_interrupted, [](const std::string& sentence) { say(sentence + "\n"); });
}

void ask_for_interrupts(void (*give_up)()) { also_give_up = give_up; }

bool take_interrupt() {
  also_give_up();
  const bool was_interrupted = interrupted != 0;
  interrupted = 0;
  return was_interrupted;
}

void give_up_if_interrupted() {
  also_give_up();
  if (interrupted != 0) {
    throw Interrupted{};
  }
}

}  // namespace fantail::tool
