// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "fantail/command_line.hpp"
#include "telemetry/publisher.hpp"
#include "telemetry/tick_reporter.hpp"

namespace fantail::tool {

/// --lcm, checked: where messages go or come from.
Option add_lcm_option(const Verb& verb, std::string& url, const std::string& meaning);

/// One sentence about what was published. Throws telemetry::TelemetryError when the network or the disk did not accept
/// a part.
[[nodiscard]] std::string report_of(const telemetry::PublisherFigures& figures, const std::string& url);

/// The ticks of a flight as LCM messages. Without a URL it does nothing.
class LcmOutput {
 public:
  /// Throws telemetry::TelemetryError when there is no way to the network or the file.
  explicit LcmOutput(const std::string& url);

  void report(const core::TickRecord& record, const telemetry::Surroundings& surroundings) {
    if (reporter_) {
      reporter_->report(record, surroundings);
    }
  }
  [[nodiscard]] bool is_on() const { return publisher_ != nullptr; }

  /// Waits until everything is sent, and returns a report; empty without a URL.
  std::string finish();

 private:
  std::string url_;
  std::unique_ptr<telemetry::Publisher> publisher_;
  std::unique_ptr<telemetry::TickReporter> reporter_;
};

}  // namespace fantail::tool
