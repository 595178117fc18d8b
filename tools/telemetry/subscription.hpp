// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>

#include "hal/clock.hpp"
#include "telemetry/receiver.hpp"
#include "telemetry/url.hpp"

namespace fantail::telemetry {

/// Hears our channels on an LCM network, or in a log at the log's own pace.
class Subscription {
 public:
  /// Throws TelemetryError.
  explicit Subscription(const Url& url);
  ~Subscription();
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

  /// Until something has come, at most so long; a signal ends it early.
  void wait(std::chrono::milliseconds at_most) const;

  /// Hands over all that has come, as of `now`. False: the log has ended.
  bool listen(Receiver& receiver, hal::Microseconds now);

 private:
  struct Lcm;
  std::unique_ptr<Lcm> lcm_;
};

}  // namespace fantail::telemetry
