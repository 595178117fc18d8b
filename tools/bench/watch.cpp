// SPDX-License-Identifier: MIT
#include "bench/watch.hpp"

#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "bench/board_words.hpp"
#include "bench/words.hpp"
#include "core/tick_record.hpp"

namespace fantail::bench {
namespace {

using nlohmann::ordered_json;

constexpr hal::Microseconds stale{2'000'000};
constexpr double bits_per_microsecond = 1.0;  // 1 Mbit/s

std::optional<double> degrees(const std::optional<core::Angle>& angle) {
  return angle ? std::optional{static_cast<double>(angle->degrees())} : std::nullopt;
}

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:+.2f}", *value) : "-"; }

ordered_json rounded(const std::optional<double>& value) {
  return value ? ordered_json::parse(fmt::format("{:.2f}", *value)) : ordered_json{};
}

// Since its power-up, modulo 256, in the order of protocol::Rejection.
ordered_json by_cause(const protocol::RejectionReport& report) {
  constexpr std::array<const char*, protocol::rejection_count> causes{"unknown_id",    "wrong_length", "wrong_crc",
                                                                      "wrong_counter", "out_of_range", "stale"};
  ordered_json json;
  for (std::size_t i = 0; i < causes.size(); ++i) {
    json[causes[i]] = report.count[i];
  }
  return json;
}

struct CanardRow {
  std::optional<double> command_deg;
  std::optional<double> encoder_deg;
  std::optional<double> limit_deg;
  std::string_view verdict = "unknown";
  bool limited = false;
  [[nodiscard]] std::optional<double> difference_deg() const {
    return command_deg && encoder_deg ? std::optional{*encoder_deg - *command_deg} : std::nullopt;
  }
};

Each<CanardRow> rows(const AvionicsLink& link, hal::Microseconds now) {
  const auto commands = link.recent<protocol::CommandReport>(now, stale);
  const auto encoders = link.recent<protocol::EncoderReport>(now, stale);
  const auto limits = link.recent<protocol::LimitReport>(now, stale);
  const auto health = link.recent<protocol::HealthReport>(now, stale);
  const auto status = link.recent<protocol::StatusReport>(now, stale);
  Each<CanardRow> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].command_deg = commands ? degrees(commands->angle[i]) : std::nullopt;
    rows[i].encoder_deg = encoders ? degrees(encoders->angle[i]) : std::nullopt;
    rows[i].limit_deg = limits ? degrees(limits->limit[i]) : std::nullopt;
    rows[i].verdict = health ? core::name(health->verdicts[i]) : "unknown";
    rows[i].limited = status && status->limited[i];
  }
  return rows;
}

}  // namespace

template <typename Message>
std::optional<Message> Watch::known() const {
  return link_.recent<Message>(now_, stale);
}

void Watch::look(hal::Microseconds now) {
  const std::uint64_t bits = link_.figures().wire_bits;
  if (now > last_look_) {
    load_percent_ = 100.0 * static_cast<double>(bits - last_bits_) /
                    (bits_per_microsecond * static_cast<double>((now - last_look_).count()));
  }
  last_bits_ = bits;
  last_look_ = now_ = now;
}

std::string Watch::link_words() const {
  const LinkFigures& heard = link_.figures();
  const hal::CanCounters counters = bus_.counters();
  return fmt::format("{} {}, load {:.1f} %, {} frames, {} lost, {} damaged, {} foreign, {} overrun, {} bus errors",
                     interface_, words(bus_.state()), load_percent_, heard.frames, heard.lost, heard.damaged,
                     heard.foreign, counters.overrun, counters.errors);
}

// What the ground was last told, and why; empty when there is nothing to tell.
std::string Watch::answer_words() const {
  std::string text;
  const auto session = known<protocol::SessionReply>();
  if (session && session->reason != protocol::SessionReason::none_yet) {
    text += "bench session: " + words(session->reason) + "\n";
  }
  const auto arming = known<protocol::ArmReply>();
  if (arming && arming->self_test == protocol::SelfTestState::failed) {
    text += "self-test: " + words(arming->failure, arming->canard) + "\n";
  }
  if (arming && arming->refusal != protocol::ArmRefusal::none) {
    text += "arming: " + words(arming->refusal) + "\n";
  }
  return text;
}

// Of all causes together, as text; they are reported once a second.
std::string Watch::refused() const {
  const auto report = known<protocol::RejectionReport>();
  return report ? fmt::format("{}", std::accumulate(report->count.begin(), report->count.end(), 0)) : "-";
}

std::string Watch::table() const {
  const auto status = known<protocol::StatusReport>();
  const auto health = known<protocol::HealthReport>();
  std::string text = link_words() + "\n";
  if (!status) {
    return text + "the avionics is silent\n";
  }
  text += fmt::format("phase {} ({}), arm switch {}, {}{}{}\n", core::name(status->phase), core::name(status->reason),
                      status->arm_switch_closed ? "closed" : "open", status->at_rest ? "at rest" : "moving",
                      status->session_open ? ", bench session open" : "",
                      status->self_test_running ? ", self-test running" : "");
  if (health) {
    text += fmt::format(
        "avionics' bus: {}, {} frames unsent, {} overrun, {} bus errors, frames refused: {} (counts are modulo 256)\n",
        words(static_cast<hal::CanState>(health->bus_state)), health->unsent, health->overrun, health->bus_errors,
        refused());
  }
  if (const auto board = known<protocol::BoardReport>()) {
    text += board_lines(*board);
  }
  text += "canard  command   encoder  difference   limit  verdict\n";
  const auto canards = rows(link_, now_);
  for (std::size_t i = 0; i < canards.size(); ++i) {
    const CanardRow& row = canards[i];
    text +=
        fmt::format("{:>6} {:>8}  {:>8}    {:>8}  {:>6}  {}{}\n", i + 1, cell(row.command_deg), cell(row.encoder_deg),
                    cell(row.difference_deg()), row.limit_deg ? fmt::format("{:.2f}", *row.limit_deg) : "-",
                    row.verdict, row.limited ? ", limited" : "");
  }
  return text + answer_words();
}

std::string Watch::line() const {
  const auto status = known<protocol::StatusReport>();
  if (!status) {
    return link_words() + "; the avionics is silent\n";
  }
  std::string text = fmt::format("{} ({});", core::name(status->phase), core::name(status->reason));
  const auto canards = rows(link_, now_);
  for (std::size_t i = 0; i < canards.size(); ++i) {
    text += fmt::format(" canard {} {} deg told, {} read, {};", i + 1, cell(canards[i].command_deg),
                        cell(canards[i].encoder_deg), canards[i].verdict);
  }
  const auto board = known<protocol::BoardReport>();
  if (board && board->faults != 0) {
    text += fmt::format(" board: {};", fmt::join(fault_names(board->faults), ", "));
  }
  return text + " " + link_words() + "\n";
}

std::string Watch::json() const {
  const auto status = known<protocol::StatusReport>();
  const auto health = known<protocol::HealthReport>();
  const auto heartbeat = known<protocol::HeartbeatReport>();
  const auto rejections = known<protocol::RejectionReport>();
  const auto session = known<protocol::SessionReply>();
  const auto arming = known<protocol::ArmReply>();
  const LinkFigures& heard = link_.figures();
  const hal::CanCounters counters = bus_.counters();
  ordered_json json;
  // Round brackets: with braces a value would become an array of one.
  json["interface"] = interface_;
  json["bus_state"] = words(bus_.state());
  json["bus_load_percent"] = rounded(load_percent_);
  json["frames"] = heard.frames;
  json["frames_lost"] = heard.lost;
  json["frames_damaged"] = heard.damaged;
  json["frames_foreign"] = heard.foreign;
  json["overrun"] = counters.overrun;
  json["bus_errors"] = counters.errors;
  json["phase"] = status ? ordered_json(core::name(status->phase)) : ordered_json{};
  json["reason"] = status ? ordered_json(core::name(status->reason)) : ordered_json{};
  json["arm_switch_closed"] = status ? ordered_json(status->arm_switch_closed) : ordered_json{};
  json["at_rest"] = status ? ordered_json(status->at_rest) : ordered_json{};
  json["session_open"] = status ? ordered_json(status->session_open) : ordered_json{};
  json["self_test_running"] = status ? ordered_json(status->self_test_running) : ordered_json{};
  json["uptime_s"] = heartbeat ? rounded(1e-3 * heartbeat->uptime_ms) : ordered_json{};
  json["plan_crc"] = heartbeat ? ordered_json(fmt::format("{:08x}", heartbeat->plan_crc)) : ordered_json{};
  json["longest_tick_us"] = health ? ordered_json(health->longest_tick_us) : ordered_json{};
  json["avionics_bus_state"] =
      health ? ordered_json(words(static_cast<hal::CanState>(health->bus_state))) : ordered_json{};
  json["avionics_unsent"] = health ? ordered_json(health->unsent) : ordered_json{};
  json["avionics_overrun"] = health ? ordered_json(health->overrun) : ordered_json{};
  json["avionics_bus_errors"] = health ? ordered_json(health->bus_errors) : ordered_json{};
  json["frames_refused_by_avionics"] = rejections ? by_cause(*rejections) : ordered_json{};
  json["bench_session"] = session ? ordered_json(words(session->reason)) : ordered_json{};
  json["self_test_failure"] = arming && arming->self_test == protocol::SelfTestState::failed
                                  ? ordered_json(words(arming->failure, arming->canard))
                                  : ordered_json{};
  json["arm_refusal"] =
      arming && arming->refusal != protocol::ArmRefusal::none ? ordered_json(words(arming->refusal)) : ordered_json{};
  const auto board = known<protocol::BoardReport>();
  json["board_faults"] = board ? ordered_json(fault_names(board->faults)) : ordered_json{};
  json["reset_cause"] = board ? ordered_json(reset_cause_name(*board)) : ordered_json{};
  json["battery_v"] = board && board->battery_mv ? rounded(1e-3 * *board->battery_mv) : ordered_json{};
  json["ticks_missed"] = board ? ordered_json(board->overruns) : ordered_json{};  // 255: or more
  json["plan"] = board ? ordered_json(name(board->plan)) : ordered_json{};
  json["flash_failed"] = board ? ordered_json(board->flash_failed) : ordered_json{};
  json["canards"] = ordered_json::array();
  for (const CanardRow& row : rows(link_, now_)) {
    json["canards"].push_back({{"command_deg", rounded(row.command_deg)},
                               {"encoder_deg", rounded(row.encoder_deg)},
                               {"difference_deg", rounded(row.difference_deg())},
                               {"limit_deg", rounded(row.limit_deg)},
                               {"verdict", row.verdict},
                               {"limited", row.limited}});
  }
  return json.dump() + "\n";
}

}  // namespace fantail::bench
