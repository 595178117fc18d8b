// SPDX-License-Identifier: MIT
#include "fantail/lcm_output.hpp"

#include <fmt/format.h>

namespace fantail::tool {

CLI::Option* add_lcm_option(CLI::App& verb, std::string& url, const std::string& meaning) {
  return verb.add_option("--lcm", url, meaning + ": udpm://239.255.76.67:7667 (LCM's default), or a log, file:///PATH")
      ->check(CLI::Validator{telemetry::objection_to_url, ""})
      ->type_name("URL");
}

LcmOutput::LcmOutput(const std::string& url) : url_{url} {
  if (!url.empty()) {
    publisher_ = std::make_unique<telemetry::Publisher>(telemetry::open_outlet(telemetry::Url{url}));
    reporter_ = std::make_unique<telemetry::TickReporter>(*publisher_);
  }
}

std::string LcmOutput::finish() {
  if (!publisher_) {
    return {};
  }
  const telemetry::PublisherFigures figures = publisher_->finish();
  if (figures.failed > 0 || !figures.complete) {
    throw telemetry::TelemetryError{fmt::format("{}: {} of {} messages could not be {}; the flight itself is whole",
                                                url_, figures.failed, figures.failed + figures.published,
                                                figures.complete ? "sent" : "written, and perhaps more")};
  }
  const std::string dropped =
      figures.dropped > 0 ? fmt::format(", {} dropped because the queue was full", figures.dropped) : "";
  return fmt::format("{} messages to {}{}", figures.published, url_, dropped);
}

}  // namespace fantail::tool
