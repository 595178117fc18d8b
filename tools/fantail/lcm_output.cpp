// SPDX-License-Identifier: MIT
#include "fantail/lcm_output.hpp"

#include <fmt/core.h>

#include "text/number.hpp"

namespace fantail::tool {

Option add_lcm_option(const Verb& verb, std::string& url, const std::string& meaning) {
  return verb.option("--lcm", url, meaning + ": udpm://239.255.76.67:7667 (LCM's default), or a log, file:///PATH")
      .check(telemetry::objection_to_url)
      .value_name("URL");
}

LcmOutput::LcmOutput(const std::string& url) : url_{url} {
  if (!url.empty()) {
    publisher_ = std::make_unique<telemetry::Publisher>(telemetry::open_outlet(telemetry::Url{url}));
    reporter_ = std::make_unique<telemetry::TickReporter>(*publisher_);
  }
}

std::string report_of(const telemetry::PublisherFigures& figures, const std::string& url) {
  if (!figures.complete) {
    throw telemetry::TelemetryError{url + ": not all messages could be written: is the disk full?"};
  }
  if (figures.failed > 0) {
    throw telemetry::TelemetryError{fmt::format(
        "{}: {} of {} messages could not be sent: is the network down? Everything except the LCM messages is complete",
        url, figures.failed, figures.failed + figures.published)};
  }
  const std::string dropped =
      figures.dropped > 0 ? fmt::format(", {} dropped because the queue was full", figures.dropped) : "";
  return fmt::format("{} to {}{}", text::counted(figures.published, "message"), url, dropped);
}

std::string LcmOutput::finish() { return publisher_ ? report_of(publisher_->finish(), url_) : ""; }

}  // namespace fantail::tool
