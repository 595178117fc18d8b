// SPDX-License-Identifier: MIT
#include "bench/board_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "avionics/board_text.hpp"
#include "hal/board.hpp"

namespace fantail::bench {
namespace {

constexpr unsigned bits = 32;
constexpr unsigned most_overruns = 0xFF;  // the report counts no further

hal::ResetCause cause_of(const protocol::BoardReport& report) {
  return static_cast<hal::ResetCause>(report.reset_cause);
}

}  // namespace

std::vector<std::string> fault_names(std::uint32_t faults) {
  std::vector<std::string> names;
  for (unsigned bit = 0; bit < bits; ++bit) {
    if ((faults >> bit & 1U) != 0) {
      names.push_back(bit < hal::board_faults ? std::string{name(static_cast<hal::BoardFault>(bit))}
                                              : fmt::format("bit_{}", bit));
    }
  }
  return names;
}

std::string_view reset_cause_name(const protocol::BoardReport& report) { return hal::name(cause_of(report)); }

std::string_view name(protocol::PlanSource plan) {
  switch (plan) {
    case protocol::PlanSource::built_in: return "built_in";
    case protocol::PlanSource::stored: return "stored";
    case protocol::PlanSource::stored_is_broken: return "stored_is_broken";
    case protocol::PlanSource::stored_is_newer: return "stored_is_newer";
    case protocol::PlanSource::flash_unreadable: return "flash_unreadable";
  }
  return "unknown";
}

std::string board_lines(const protocol::BoardReport& report) {
  const std::string faults =
      report.faults == 0 ? "no fault"
                         : fmt::format("{}; with that it is not armed", fmt::join(fault_names(report.faults), ", "));
  const std::string battery =
      report.battery_mv ? fmt::format("{:.2f} V", 1e-3 * *report.battery_mv) : std::string{"not measured"};
  std::string text =
      fmt::format("board: {}; {}, battery {}, {}{} control ticks missed\n", faults, avionics::text(cause_of(report)),
                  battery, report.overruns, report.overruns == most_overruns ? " or more" : "");
  text += fmt::format("plan: {}\n", avionics::text(report.plan));
  if (report.flash_failed) {
    text += "flash: it does not answer, or does not keep what is written; with that it is not armed\n";
  }
  return text;
}

}  // namespace fantail::bench
