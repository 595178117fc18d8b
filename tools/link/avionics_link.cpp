// SPDX-License-Identifier: MIT
#include "link/avionics_link.hpp"

#include "avionics/can_frame.hpp"
#include "protocol/bus_load.hpp"

namespace fantail::link {
namespace {

// Nobody takes ticks while nothing is recorded.
constexpr std::size_t most_waiting_ticks = 10'000;
constexpr std::size_t most_waiting_log_data = 1'000;
constexpr hal::Microseconds longest_silence{2'000'000};

Each<std::optional<double>> radians(const protocol::PerCanard& angles) {
  Each<std::optional<double>> result{};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (angles[i]) {
      result[i] = static_cast<double>(angles[i]->radians());
    }
  }
  return result;
}

}  // namespace

bool AvionicsLink::listen(hal::Microseconds now, int most_frames) {
  silent_ = silence_ && silence_->expired(now);
  for (int i = 0; i < most_frames; ++i) {
    const auto frame = bus_.receive();
    if (!frame) {
      emptied_ = now;
      return false;
    }
    if (frame->extended || frame->remote) {
      figures_.foreign += 1;
      continue;
    }
    const protocol::BusFrame bus_frame = avionics::bus_frame(*frame);
    figures_.wire_bits += protocol::bits_on_wire(bus_frame);
    const auto decoded = protocol::decode_from_avionics(bus_frame);
    if (!decoded.message) {
      (decoded.rejection == protocol::Rejection::unknown_id ? figures_.foreign : figures_.damaged) += 1;
      continue;
    }
    figures_.frames += 1;
    std::visit([&](const auto& message) { keep(message, now); }, *decoded.message);
    if (const auto* commands = std::get_if<protocol::CommandReport>(&*decoded.message)) {
      take(*commands, *decoded.counter);
    } else if (const auto* encoders = std::get_if<protocol::EncoderReport>(&*decoded.message)) {
      take(*encoders, *decoded.counter);
    } else if (const auto* data = std::get_if<protocol::LogData>(&*decoded.message)) {
      if (log_data_.size() == most_waiting_log_data) {
        log_data_.pop_front();
      }
      log_data_.push_back(*data);
    } else if (const auto* heartbeat = std::get_if<protocol::HeartbeatReport>(&*decoded.message)) {
      take(*heartbeat, now);
    } else if (const auto* board = std::get_if<protocol::BoardReport>(&*decoded.message)) {
      take(*board);
    } else if (std::holds_alternative<protocol::StatusReport>(*decoded.message)) {
      silence_.emplace(longest_silence, now);
      silent_ = false;
    }
  }
  return true;
}

template <typename Message>
void AvionicsLink::keep(const Message& message, hal::Microseconds now) {
  std::get<std::optional<Heard<Message>>>(heard_) =
      Heard<Message>{.message = message, .time = now, .count = count<Message>() + 1};
}

void AvionicsLink::take(const protocol::HeartbeatReport& report, hal::Microseconds now) {
  std::optional<std::int64_t> since_last_ms;
  if (heartbeat_no_older_) {
    since_last_ms = (now - *heartbeat_no_older_).count() / 1'000;
  }
  heartbeat_no_older_ = emptied_;
  if (heartbeats_.hear(report.uptime_ms, since_last_ms) && last_command_) {
    uncounted_ms_ = *heartbeats_.uptime_ms() - last_command_->total();
  }
}

void AvionicsLink::take(const protocol::CommandReport& report, std::uint8_t counter) {
  command_order_.take(counter);
  unwrap(last_command_, counter);
  command_ = report;
}

void AvionicsLink::take(const protocol::EncoderReport& report, std::uint8_t counter) {
  unwrap(last_encoder_, counter);
  // Half a tick, where the other half was lost, is none.
  if (!last_command_ || last_command_->step_to(counter) != 0) {
    return;
  }
  last_encoder_ = last_command_;
  Tick tick{.number = last_encoder_->total(),
            .command_rad = radians(command_.angle),
            .encoder_rad = radians(report.angle),
            .limited = {}};
  if (const auto& status = newest<protocol::StatusReport>()) {
    tick.limited = status->message.limited;
  }
  if (ticks_.size() == most_waiting_ticks) {
    ticks_.pop_front();
  }
  ticks_.push_back(tick);
}

void AvionicsLink::take(const protocol::BoardReport& report) {
  const std::uint32_t faults_before = board_ ? board_->faults : 0;
  const bool flash_failed_before = board_ && board_->flash_failed;
  board_ = report;
  board_->faults |= faults_before;
  board_->flash_failed = board_->flash_failed || flash_failed_before;
}

// Sixteen or more frames lost at once look like none; the bus counts those that it had no room for.
void AvionicsLink::unwrap(std::optional<FrameNumber>& last, std::uint8_t counter) {
  if (!last) {
    last.emplace(counter);
    return;
  }
  // A frame is another one than the last, so the same number is a whole round on.
  const std::int64_t step = last->read_next(counter);
  figures_.lost += static_cast<std::uint64_t>(step - 1);
}

std::optional<std::string> AvionicsLink::two_rockets() const {
  if (heartbeats_.two_rockets() || !command_order_.two_senders()) {
    return heartbeats_.two_rockets();
  }
  return "two rockets, or a device that imitates one, report on this bus: the reports have two series of numbers; "
         "disconnect all but one";
}

std::optional<Tick> AvionicsLink::take_tick() {
  if (ticks_.empty()) {
    return std::nullopt;
  }
  Tick tick = ticks_.front();
  ticks_.pop_front();
  return tick;
}

std::optional<protocol::LogData> AvionicsLink::take_log_data() {
  if (log_data_.empty()) {
    return std::nullopt;
  }
  const protocol::LogData data = log_data_.front();
  log_data_.pop_front();
  return data;
}

bool Recording::add(const Tick& tick) {
  if (!ticks_.empty()) {
    // Unsigned: the difference of two far numbers must not overflow.
    const auto since_first =
        static_cast<std::uint64_t>(tick.number) - static_cast<std::uint64_t>(ticks_.front().number);
    if (tick.number <= ticks_.back().number || since_first >= longest_) {
      ++refused_;
      return false;
    }
  } else if (longest_ == 0) {
    ++refused_;
    return false;
  }
  ticks_.push_back(tick);
  return true;
}

std::size_t Recording::lost_ticks() const {
  if (ticks_.empty()) {
    return 0;
  }
  return static_cast<std::size_t>(ticks_.back().number - ticks_.front().number) + 1 - ticks_.size();
}

}  // namespace fantail::link
