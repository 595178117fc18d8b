// SPDX-License-Identifier: MIT
#include "fantail/world_in_real_time.hpp"

#include <thread>

#include <fmt/core.h>

#include "fantail/progress.hpp"

namespace fantail::tool {
namespace {

constexpr int ticks_between_looks = 20;

}  // namespace

WorldInRealTime::WorldInRealTime(const sim::Scenario& scenario, const sim::BoardPorts& ports, const PadEar& ear,
                                 const sim::MakeFlightComputer& make, const std::vector<PadCommand>& more)
    : world_{scenario, ports, make}, script_{ear, commands(more)} {}

std::vector<PadCommand> WorldInRealTime::commands(const std::vector<PadCommand>& more) {
  std::vector<PadCommand> all{
      {"switch close", "close the arm switch", [this] { world_.set_arm_switch(true); }},
      {"switch open", "open the arm switch", [this] { world_.set_arm_switch(false); }},
      {"abort press", "ask to abort at the abort input, if the plan has one", [this] { world_.press_abort(true); }},
      {"abort release", "no longer ask to abort", [this] { world_.press_abort(false); }},
      {"ignite", "ignite the motor", [this] { world_.ignite(); }}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void WorldInRealTime::run(const std::optional<double>& seconds, const Observe& observe) {
  const auto begin = Clock::now();
  pace_ = fly::Pace{begin};
  for (auto now = begin;; now = Clock::now()) {
    if (ticks_ % ticks_between_looks == 0 &&
        (!script_.obey() || take_interrupt() || (seconds && now - begin >= std::chrono::duration<double>{*seconds}))) {
      break;
    }
    if (const auto due = pace_.next(now); now < due) {
      std::this_thread::sleep_until(due);
    }
    world_.set_ticks_left_out(pace_.ticks_left_out());
    const auto tick_begin = Clock::now();
    const core::TickRecord& record = world_.tick();
    observe(record, Clock::now() - tick_begin);
    world_.advance();
    ticks_ += 1;
  }
}

std::string WorldInRealTime::summary(const hal::CanCounters& frames) const {
  return fmt::format(
      "ended after {:.1f} s of the rocket's time; {} of {} ticks ended more than a millisecond late; {:.1f} s were "
      "left out. Frames: {} sent, {} received, {} dropped\n",
      1e-3 * static_cast<double>(ticks_), pace_.late(), ticks_, std::chrono::duration<double>{pace_.left_out()}.count(),
      frames.sent, frames.received, frames.unsent);
}

}  // namespace fantail::tool
