// SPDX-License-Identifier: MIT
#include "bench/watch.hpp"

#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "avionics/board_text.hpp"
#include "core/tick_record.hpp"
#include "json/value.hpp"
#include "replies/sentence.hpp"
#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

using Json = json::Value;

constexpr hal::Microseconds stale{2'000'000};
constexpr double bits_per_microsecond = 1.0;  // 1 Mbit/s

std::optional<double> degrees(const std::optional<core::Angle>& angle) {
  return angle ? std::optional{static_cast<double>(angle->degrees())} : std::nullopt;
}

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:+.2f}", *value) : "-"; }

Json rounded(const std::optional<double>& value) { return json::printed(value, 2); }

// Since its power-up, modulo 256, in the order of protocol::Rejection.
Json by_cause(const protocol::RejectionReport& report) {
  constexpr std::array<const char*, protocol::rejection_count> causes{"unknown_id",    "wrong_length", "wrong_crc",
                                                                      "wrong_counter", "out_of_range", "stale"};
  Json json;
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
  bool silent = false;  ///< the avionics reports that the encoder has no valid reading
  [[nodiscard]] std::string encoder_text() const { return silent ? "silent" : cell(encoder_deg); }
  [[nodiscard]] std::optional<double> difference_deg() const {
    return command_deg && encoder_deg ? std::optional{*encoder_deg - *command_deg} : std::nullopt;
  }
};

link::Each<CanardRow> rows(const link::AvionicsLink& link, hal::Microseconds now) {
  const auto commands = link.recent<protocol::CommandReport>(now, stale);
  const auto encoders = link.recent<protocol::EncoderReport>(now, stale);
  const auto limits = link.recent<protocol::LimitReport>(now, stale);
  const auto health = link.recent<protocol::HealthReport>(now, stale);
  const auto status = link.recent<protocol::StatusReport>(now, stale);
  link::Each<CanardRow> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].command_deg = commands ? degrees(commands->angle[i]) : std::nullopt;
    rows[i].encoder_deg = encoders ? degrees(encoders->angle[i]) : std::nullopt;
    rows[i].silent = encoders && !encoders->angle[i];
    rows[i].limit_deg = limits ? degrees(limits->limit[i]) : std::nullopt;
    rows[i].verdict = health ? core::name(health->verdicts[i]) : "unknown";
    rows[i].limited = status && status->limited[i];
  }
  return rows;
}

std::string sensors_text(const protocol::HealthReport& health) {
  return fmt::format("gyro {}, accelerometer {}", core::name(health.gyro), core::name(health.accelerometer));
}

// Two or three lines, each with its end.
std::string board_lines(const protocol::BoardReport& report) {
  std::string text = fmt::format("board: {}\nplan: {}\n", board_text(report), avionics::text(report.plan));
  if (report.flash_failed) {
    text += "flash: does not answer, or does not keep written data; the rocket cannot be armed\n";
  }
  return text;
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

std::string Watch::bus_text() const {
  const link::LinkFigures& heard = link_.figures();
  const hal::CanCounters counters = bus_.counters();
  return fmt::format("{} {}, load {:.1f} %, {} frames, {} lost, {} damaged, {} foreign, {} overrun, {} bus errors",
                     interface_, replies::name(bus_.state()), load_percent_, heard.frames, heard.lost, heard.damaged,
                     heard.foreign, counters.overrun, counters.errors);
}

// What the ground was last told, and why; empty when there is nothing to tell.
std::string Watch::replies_text() const {
  std::string text;
  const auto session = known<protocol::SessionReply>();
  if (session && session->reason != protocol::SessionReason::none_yet) {
    text += "bench session: " + replies::sentence(session->reason) + "\n";
  }
  const auto arming = known<protocol::ArmReply>();
  if (arming && arming->self_test == protocol::SelfTestState::failed) {
    text += "self-test: " + replies::sentence(arming->failure, arming->canard) + "\n";
  }
  if (arming && arming->refusal != protocol::ArmRefusal::none) {
    text += "arming: " + replies::sentence(arming->refusal) + "\n";
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
  std::string text = bus_text() + "\n";
  if (!status) {
    return text + "the avionics is silent\n";
  }
  text += fmt::format("phase {} ({}), arm switch {}, {}{}{}\n", core::name(status->phase), core::name(status->reason),
                      status->arm_switch_closed ? "closed" : "open", status->at_rest ? "at rest" : "moving",
                      status->session_open ? ", bench session open" : "",
                      status->self_test_running ? ", self-test running" : "");
  if (health) {
    text += fmt::format(
        "avionics' bus: {}, {} frames unsent, {} overrun, {} bus errors, frames refused: {} (each count is modulo "
        "256)\n",
        replies::name(static_cast<hal::CanState>(health->bus_state)), health->unsent, health->overrun,
        health->bus_errors, refused());
  }
  if (const auto board = known<protocol::BoardReport>()) {
    text += board_lines(*board);
  }
  if (health) {
    text += sensors_text(*health) + "\n";
  }
  if (const auto arming = known<protocol::ArmReply>()) {
    text += fmt::format("abort input: {}\n", replies::sentence(arming->abort_input));
  }
  text += "canard  command   encoder  difference   limit  verdict\n";
  const auto canards = rows(link_, now_);
  for (std::size_t i = 0; i < canards.size(); ++i) {
    const CanardRow& row = canards[i];
    text += fmt::format("{:>6} {:>8}  {:>8}    {:>8}  {:>6}  {}{}\n", i + 1, cell(row.command_deg), row.encoder_text(),
                        cell(row.difference_deg()), row.limit_deg ? fmt::format("{:.2f}", *row.limit_deg) : "-",
                        row.verdict, row.limited ? ", limited" : "");
  }
  return text + replies_text();
}

std::string Watch::line() const {
  const auto status = known<protocol::StatusReport>();
  if (!status) {
    return bus_text() + "; the avionics is silent\n";
  }
  std::string text = fmt::format("{} ({});", core::name(status->phase), core::name(status->reason));
  const auto canards = rows(link_, now_);
  for (std::size_t i = 0; i < canards.size(); ++i) {
    text += fmt::format(" canard {} command {} deg, encoder {}, {};", i + 1, cell(canards[i].command_deg),
                        canards[i].encoder_text(), canards[i].verdict);
  }
  if (const auto health = known<protocol::HealthReport>()) {
    text += " " + sensors_text(*health) + ";";
  }
  if (const auto arming = known<protocol::ArmReply>()) {
    text += fmt::format(" abort input: {};", replies::sentence(arming->abort_input));
  }
  const auto board = known<protocol::BoardReport>();
  if (board && board->faults != 0) {
    text += fmt::format(" board: {};", fmt::join(fault_names(board->faults), ", "));
  }
  return text + " " + bus_text() + "\n";
}

std::string Watch::json() const {
  const auto status = known<protocol::StatusReport>();
  const auto health = known<protocol::HealthReport>();
  const auto heartbeat = known<protocol::HeartbeatReport>();
  const auto rejections = known<protocol::RejectionReport>();
  const auto session = known<protocol::SessionReply>();
  const auto arming = known<protocol::ArmReply>();
  const link::LinkFigures& heard = link_.figures();
  const hal::CanCounters counters = bus_.counters();
  Json json;
  json["interface"] = interface_;
  json["bus_state"] = replies::name(bus_.state());
  json["bus_load_percent"] = rounded(load_percent_);
  json["frames"] = heard.frames;
  json["frames_lost"] = heard.lost;
  json["frames_damaged"] = heard.damaged;
  json["frames_foreign"] = heard.foreign;
  json["overrun"] = counters.overrun;
  json["bus_errors"] = counters.errors;
  json["phase"] = status ? Json(core::name(status->phase)) : Json{};
  json["reason"] = status ? Json(core::name(status->reason)) : Json{};
  json["arm_switch_closed"] = status ? Json(status->arm_switch_closed) : Json{};
  json["abort_input"] = arming ? Json(replies::name(arming->abort_input)) : Json{};
  json["at_rest"] = status ? Json(status->at_rest) : Json{};
  json["session_open"] = status ? Json(status->session_open) : Json{};
  json["gyro_bias_deg_s"] = status ? Json(text::degrees(static_cast<double>(status->gyro_bias_rad_s))) : Json{};
  json["self_test_running"] = status ? Json(status->self_test_running) : Json{};
  json["uptime_s"] = heartbeat ? rounded(1e-3 * heartbeat->uptime_ms) : Json{};
  json["uptime_modulo_s"] = 16'777.216;  // it begins again at 0 then
  json["plan_crc"] = heartbeat ? Json(fmt::format("{:08x}", heartbeat->plan_crc)) : Json{};
  json["longest_tick_us"] = health ? Json(health->longest_tick_us) : Json{};
  json["gyro_state"] = health ? Json(core::name(health->gyro)) : Json{};
  json["accelerometer_state"] = health ? Json(core::name(health->accelerometer)) : Json{};
  json["avionics_bus_state"] = health ? Json(replies::name(static_cast<hal::CanState>(health->bus_state))) : Json{};
  json["avionics_counters_modulo"] = 256;  // of the three below and of frames_refused_by_avionics
  json["avionics_unsent"] = health ? Json(health->unsent) : Json{};
  json["avionics_overrun"] = health ? Json(health->overrun) : Json{};
  json["avionics_bus_errors"] = health ? Json(health->bus_errors) : Json{};
  json["frames_refused_by_avionics"] = rejections ? by_cause(*rejections) : Json{};
  json["bench_session"] = session ? Json(replies::sentence(session->reason)) : Json{};
  json["self_test_failure"] = arming && arming->self_test == protocol::SelfTestState::failed
                                  ? Json(replies::sentence(arming->failure, arming->canard))
                                  : Json{};
  json["arm_refusal"] =
      arming && arming->refusal != protocol::ArmRefusal::none ? Json(replies::sentence(arming->refusal)) : Json{};
  add_board(json, known<protocol::BoardReport>(), "plan");
  json["canards"] = Json::array();
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
