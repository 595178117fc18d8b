// SPDX-License-Identifier: MIT
// Usage: write_logged_flight FOLDER. The benchmark's flight as its own log, as ULog and as an LCM log, for the peers.
#include <array>
#include <cstdio>
#include <exception>
#include <string>

#include "benchmark/logged_flight.hpp"
#include "flight_log/to_report.hpp"
#include "log_export/formats.hpp"
#include "text/output_folder.hpp"

int main(int count, char** arguments) {
  using namespace fantail;
  if (count != 2) {
    std::fputs("usage: write_logged_flight FOLDER\n", stderr);
    return 64;
  }
  try {
    const benchmark::LoggedFlight& logged = benchmark::logged_flight();
    const flight::Flight report = flight_log::to_report(logged.flight, logged.regeneration);
    const log_export::ReplayedFlight source{logged.flight, logged.regeneration, report};
    std::string own(logged.bytes.size(), '\0');
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i] = static_cast<char>(logged.bytes[i]);
    }
    text::OutputFolder{arguments[1]}.write(
        std::array<text::NamedFile, 3>{{{"flight.ftl", own},
                                        {"flight.ulg", log_export::ulog(source, log_export::every_field(source))},
                                        {"flight.lcmlog", log_export::lcm(source)}}});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_logged_flight: %s\n", error.what());
    return 70;
  }
}
