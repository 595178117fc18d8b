// SPDX-License-Identifier: MIT
#include "gateway/gateway.hpp"

#include <algorithm>

namespace fantail::gateway {
namespace {

using std::chrono::milliseconds;

// Several times as old as a report becomes before the next one; then it is not known any more.
constexpr milliseconds status_age{100};
constexpr milliseconds health_age{500};
constexpr milliseconds limit_age{5'000};
// A little less than the period of 10 ms: nothing comes at even times.
constexpr milliseconds canards_pause{9};
// Of a heartbeat: a busy PC may have left the one before it in its queue for as long.
constexpr milliseconds lateness{10'000};
// Frames, 12 ms of them: of what came while a busy PC held this process up, every change of the phase is to be seen.
constexpr int portion = 32;
constexpr int most_portions = 30;

std::optional<double> radians(core::Angle angle) { return static_cast<double>(angle.radians()); }

// What it has come to since the first look.
std::int64_t total(std::optional<link::WrappingCounter<256>>& counter, std::uint8_t value) {
  if (!counter) {
    counter.emplace(value);
  }
  counter->read(value);
  return counter->total();
}

}  // namespace

bool AvionicsClock::hear(std::uint32_t uptime_ms, hal::Microseconds now) {
  // A clock goes back only by a new start. Of one that has been on for more than half a round, going back looks like
  // going far on: then it is a new start if it has been on for no longer than since the last heartbeat.
  const hal::Microseconds most = now - last_heard_ + lateness;
  const auto ahead_of_time = [&](std::int64_t time_ms) { return std::chrono::milliseconds{time_ms} > most; };
  const bool new_start = uptime_ && (uptime_->is_back(uptime_ms) ||
                                     (ahead_of_time(uptime_->step_to(uptime_ms)) && !ahead_of_time(uptime_ms)));
  last_heard_ = now;
  if (!uptime_ || new_start) {
    uptime_.emplace(uptime_ms);
    ahead_ = uptime() - now;
    told_ = {};
  } else {
    uptime_->read(uptime_ms);
    const hal::Microseconds heard = uptime() - now;
    // A frame can come late but not early. The slow way back follows two clocks that do not go alike.
    ahead_ = heard > ahead_ ? heard : ahead_ + (heard - ahead_) / 8;
  }
  return new_start;
}

std::optional<hal::Microseconds> AvionicsClock::at(hal::Microseconds now) {
  if (!uptime_) {
    return std::nullopt;
  }
  told_ = std::max(told_, now + ahead_);
  return told_;
}

// Null: the same as at the last look.
template <typename Message>
const Message* Gateway::news(std::uint64_t& taken) const {
  const auto& newest = link_.newest<Message>();
  if (!newest || newest->count == taken) {
    return nullptr;
  }
  taken = newest->count;
  return &newest->message;
}

void Gateway::listen(hal::Microseconds now) {
  bool more = true;
  for (int portions = 0; more && portions < most_portions; ++portions) {
    more = link_.listen(now, portion);
    pass_on(now);
  }
}

void Gateway::pass_on(hal::Microseconds now) {
  follow_clock(now);
  const auto time = clock_.at(now);
  if (!time || !sender_) {
    link_.forget_ticks();
    return;
  }
  if (const auto* status = news<protocol::StatusReport>(states_)) {
    changes_.look(*time, status->phase, status->reason, *sender_);
  }
  send_state(now, *time);
  send_canards(now, *time);
  send_health(*time);
}

void Gateway::follow_clock(hal::Microseconds now) {
  const auto* heartbeat = news<protocol::HeartbeatReport>(heartbeats_);
  if (heartbeat == nullptr) {
    return;
  }
  const bool restarted = clock_.hear(heartbeat->uptime_ms, now);
  if (restarted || !sender_) {
    sender_.emplace(sink_);
  }
  if (restarted) {
    restarts_ += 1;
    changes_.begin_with_first_look();
    canards_sent_.reset();
  }
}

void Gateway::send_state(hal::Microseconds now, core::Microseconds time) {
  const auto* motion = news<protocol::MotionReport>(motions_);
  const auto status = link_.recent<protocol::StatusReport>(now, status_age);
  if (motion == nullptr || !status) {
    return;
  }
  sender_->send(time, telemetry::State{.phase = status->phase,
                                       .reason = status->reason,
                                       .command_status = status->command_status,
                                       .timing_fault = status->timing_fault,
                                       .saturated = status->saturated,
                                       .roll_angle_rad = radians(motion->roll_angle),
                                       .roll_rate_rad_s = motion->roll_rate_rad_s,
                                       .command_rad = radians(status->roll_command),
                                       .height_m = motion->height_m,
                                       .speed_m_s = motion->speed_m_s});
}

void Gateway::send_canards(hal::Microseconds now, core::Microseconds time) {
  std::optional<link::Tick> newest;
  while (const auto tick = link_.take_tick()) {
    newest = tick;
  }
  if (!newest || (canards_sent_ && time - *canards_sent_ < canards_pause)) {
    return;
  }
  canards_sent_ = time;
  telemetry::Canards canards{.command_rad = newest->command_rad, .encoder_rad = newest->encoder_rad};
  canards.limited = newest->limited;
  const auto limits = link_.recent<protocol::LimitReport>(now, limit_age);
  const auto health = link_.recent<protocol::HealthReport>(now, health_age);
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    canards.limit_rad[i] = limits ? radians(limits->limit[i]) : std::nullopt;
    canards.verdicts[i] = health ? std::optional{health->verdicts[i]} : std::nullopt;
  }
  sender_->send(time, canards);
}

void Gateway::send_health(core::Microseconds time) {
  const auto* report = news<protocol::HealthReport>(healths_);
  if (report == nullptr) {
    return;
  }
  changes_.look(time, report->verdicts, *sender_);
  const link::LinkFigures& heard = link_.figures();
  const auto& status = link_.newest<protocol::StatusReport>();
  sender_->send(
      time, telemetry::Health{.gyro = report->gyro,
                              .accelerometer = report->accelerometer,
                              .verdicts = report->verdicts,
                              .timing_fault = status && status->message.timing_fault,
                              .longest_tick_s = 1e-6 * report->longest_tick_us,
                              .late_ticks = {},
                              .bus = telemetry::Health::Bus{.state = static_cast<hal::CanState>(report->bus_state),
                                                            .unsent = total(unsent_, report->unsent),
                                                            .overrun = total(overrun_, report->overrun),
                                                            .errors = total(errors_, report->bus_errors)},
                              .gateway = telemetry::Health::Gateway{.state = bus_.state(),
                                                                    .frames = static_cast<std::int64_t>(heard.frames),
                                                                    .lost = static_cast<std::int64_t>(heard.lost),
                                                                    .damaged = static_cast<std::int64_t>(heard.damaged),
                                                                    .foreign = static_cast<std::int64_t>(heard.foreign),
                                                                    .overrun = bus_.counters().overrun}});
}

}  // namespace fantail::gateway
