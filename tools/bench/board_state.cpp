// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "avionics/board_text.hpp"
#include "bench/watch.hpp"
#include "hal/board.hpp"
#include "replies/sentence.hpp"

namespace fantail::bench {
namespace {

constexpr unsigned most_overruns = 0xFF;  // the report counts no further

bool plan_forbids_arming(protocol::PlanSource plan) {
  return plan != protocol::PlanSource::built_in && plan != protocol::PlanSource::stored;
}

}  // namespace

std::vector<std::string> fault_names(std::uint32_t faults) {
  std::vector<std::string> names;
  for (unsigned bit = 0; bit < 32; ++bit) {
    if ((faults >> bit & 1U) != 0) {
      names.push_back(bit < hal::board_faults ? std::string{name(static_cast<hal::BoardFault>(bit))}
                                              : fmt::format("bit_{}", bit));
    }
  }
  return names;
}

std::string board_text(const protocol::BoardReport& report) {
  const std::string faults = report.faults == 0
                                 ? "no fault"
                                 : fmt::format("{} (prevents arming)", fmt::join(fault_names(report.faults), ", "));
  const std::string battery =
      report.battery_mv ? fmt::format("{:.2f} V", 1e-3 * *report.battery_mv) : std::string{"not measured"};
  return fmt::format("{}; {}, battery {}, {}{} control ticks missed", faults,
                     avionics::text(static_cast<hal::ResetCause>(report.reset_cause)), battery, report.overruns,
                     report.overruns == most_overruns ? " or more" : "");
}

std::vector<std::string> bars_to_arming(const protocol::BoardReport& report) {
  std::vector<std::string> bars = fault_names(report.faults);
  if (report.flash_failed) {
    bars.emplace_back("flash_failed");
  }
  if (plan_forbids_arming(report.plan)) {
    bars.push_back(fmt::format("plan {}", replies::name(report.plan)));
  }
  return bars;
}

void add_board(json::Value& to, const std::optional<protocol::BoardReport>& report, const char* plan_key) {
  using Json = json::Value;
  to["board_faults"] = report ? Json(fault_names(report->faults)) : Json{};
  to["reset_cause"] = report ? Json(hal::name(static_cast<hal::ResetCause>(report->reset_cause))) : Json{};
  to["battery_v"] = report && report->battery_mv ? json::printed(1e-3 * *report->battery_mv, 2) : Json{};
  to["ticks_missed"] = report ? Json(report->overruns) : Json{};  // 255: or more
  to[plan_key] = report ? Json(replies::name(report->plan)) : Json{};
  to["flash_failed"] = report ? Json(report->flash_failed) : Json{};
}

}  // namespace fantail::bench
