// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <system_error>

#include <poll.h>

#include "telemetry/datagram_receiver.hpp"
#include "telemetry/lcm_format.hpp"
#include "telemetry/receiver.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::telemetry {

class Subscription::Network : public DatagramReceiver {
  using DatagramReceiver::DatagramReceiver;
};

/// Its events are due as far apart as they were when they were recorded.
class Subscription::Log {
 public:
  explicit Log(const Url& url)
      : file_{url.path()}, speed_{url.speed()}, log_{[this](std::span<char> to) { return file_.read(to); }} {
    next_ = log_.next();
    if (!next_) {
      throw TelemetryError{url.text() + ": contains no complete event; is it an LCM log, and complete?"};
    }
  }

  void wait(std::chrono::milliseconds at_most) const {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(due_ - Clock::now());
    (void)::poll(nullptr, 0, static_cast<int>(std::clamp(left, std::chrono::milliseconds{0}, at_most).count()));
  }

  bool listen(const Take& take) {
    // A log played as fast as it goes always has something; the listener must get round to showing it.
    for (std::size_t i = 0; i < DatagramReceiver::most_waiting && next_ && due_ <= Clock::now(); ++i) {
      if (next_->channel.starts_with(channel_prefix)) {
        take(next_->channel, next_->bytes);
      }
      const std::int64_t before_us = next_->time_us;
      next_ = log_.next();
      if (next_ && speed_ > 0.0) {
        due_ += pause(static_cast<double>(next_->time_us) - static_cast<double>(before_us));
      }
    }
    return next_.has_value();
  }

  [[nodiscard]] std::uint64_t foreign_bytes() const { return log_.foreign_bytes(); }

 private:
  using Clock = std::chrono::steady_clock;

  /// A clock that was set back begins a new piece, and no damage makes a listener wait longer than a day.
  [[nodiscard]] Clock::duration pause(double recorded_us) const {
    constexpr double longest_s = 86'400.0;
    const std::chrono::duration<double> pause_s{std::clamp(1e-6 * recorded_us / speed_, 0.0, longest_s)};
    return std::chrono::duration_cast<Clock::duration>(pause_s);
  }

  text::InputFile file_;
  double speed_;
  LcmLog log_;
  std::optional<LcmLog::Event> next_;
  Clock::time_point due_ = Clock::now();
};

Subscription::Subscription(const Url& url) {
  if (!url.is_file()) {
    require_route(url);
    network_ = std::make_unique<Network>(url);
    return;
  }
  try {
    log_ = std::make_unique<Log>(url);
  } catch (const text::Error& error) {
    if (error.kind() == text::ErrorKind::interrupted) {
      throw;
    }
    throw TelemetryError{error.what()};
  } catch (const std::system_error& error) {
    throw TelemetryError{url.path() + ": " + error.code().message()};
  }
}

Subscription::~Subscription() = default;

void Subscription::wait(std::chrono::milliseconds at_most) const {
  log_ ? log_->wait(at_most) : network_->wait(at_most);
}

bool Subscription::listen(const Take& take) {
  if (log_) {
    return log_->listen(take);
  }
  network_->hand_over(take);
  return true;
}

std::uint64_t Subscription::foreign_bytes() const { return log_ ? log_->foreign_bytes() : 0; }

}  // namespace fantail::telemetry
