// SPDX-License-Identifier: MIT
#include "avionics/board_watch.hpp"

#include <algorithm>
#include <string_view>

#include "avionics/board_text.hpp"

namespace fantail::avionics {

using protocol::PlanSource;

namespace {

constexpr std::string_view not_armed = "it will not be armed";

void write_faults(hal::BoardFaults faults, hal::Console& console) {
  std::string_view before = "board: ";
  for (std::size_t i = 0; i < hal::board_faults; ++i) {
    const auto fault = static_cast<hal::BoardFault>(i);
    if (faults.has(fault)) {
      console.write(before);
      console.write(name(fault));
      before = ", ";
    }
  }
}

}  // namespace

// Meets ARM-4, TIM-1.
void BoardWatch::look(const hal::BoardStatus& status, std::uint32_t missed_ticks, std::uint32_t overrun_limit) {
  status_ = status;
  status_.overruns = std::max(status.overruns, missed_ticks);
  if (status_.overruns > overrun_limit) {
    status_.faults.add(hal::BoardFault::loop_overrun);
  }
}

protocol::BoardReport BoardWatch::report(const FlashFacts& flash) const {
  constexpr std::uint32_t most_overruns = 0xFF;
  const std::uint32_t missed =
      std::min(status_.overruns, most_overruns) + std::min(status_.ticks_left_out, most_overruns);
  return {.faults = status_.faults.bits(),
          .reset_cause = static_cast<std::uint8_t>(status_.reset_cause),
          .plan = flash.plan.value_or(PlanSource::built_in),
          .flash_failed = flash.failed,
          .battery_mv = status_.battery_mv,
          .overruns = static_cast<std::uint8_t>(std::min(missed, most_overruns))};
}

bool BoardWatch::tell(core::Microseconds now, core::Phase phase, const FlashFacts& flash, hal::Console& console) {
  const Told news{.faults = status_.faults, .plan = flash.plan, .flash_failed = flash.failed};
  if (told_at_ && (news == told_ || now - *told_at_ < shortest_pause)) {
    return false;
  }
  const std::string_view so = phase == core::Phase::safe ? not_armed : "operation continues";
  if (!told_at_) {
    console.write(text(status_.reset_cause));
    console.write("\n");
  }
  if (!told_at_ || news.faults != told_.faults) {
    write_faults(news.faults, console);
    console.write(news.faults.none() ? "board: no fault" : "; ");
    console.write(news.faults.none() ? "" : so);
    console.write("\n");
  }
  if (news.plan && news.plan != told_.plan) {
    console.write("plan: ");
    console.write(text(*news.plan));
    console.write("\n");
  }
  if (news.flash_failed && !told_.flash_failed) {
    console.write("flash: does not answer, or does not keep written data; ");
    console.write(so);
    console.write("\n");
  }
  told_ = news;
  told_at_ = now;
  return true;
}

hal::Signal signal_of(core::Phase phase, core::PhaseReason reason, bool self_test_running, bool fit) {
  switch (phase) {
    case core::Phase::safe: break;
    case core::Phase::armed: return waits_for_rest(reason) ? hal::Signal::armed_not_ready : hal::Signal::armed;
    case core::Phase::launched:
    case core::Phase::dormant:
    case core::Phase::controlling: return hal::Signal::flying;
    case core::Phase::finished: return hal::Signal::finished;
  }
  if (self_test_running) {
    return hal::Signal::self_test;
  }
  return fit ? hal::Signal::safe : hal::Signal::faulty;
}

}  // namespace fantail::avionics
