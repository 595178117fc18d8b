// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include <fmt/core.h>

#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/progress.hpp"
#include "fantail/standard_streams.hpp"
#include "json/value.hpp"
#include "link/session.hpp"

namespace fantail::tool {
namespace {

struct HoldOptions {
  BenchOptions bench;
  int canard = 1;
  double angle_deg = 0.0;
  std::optional<double> seconds;
};

constexpr hal::Microseconds report_period{1'000'000};

std::optional<double> degrees(const std::optional<core::Angle>& angle) {
  return angle ? std::optional{static_cast<double>(angle->degrees())} : std::nullopt;
}

std::string text(const std::optional<double>& angle_deg, const char* unknown) {
  return angle_deg ? fmt::format("{:+.2f} deg", *angle_deg) : unknown;
}

std::string line(const HoldOptions& options, const link::AvionicsLink& link) {
  const auto index = static_cast<std::size_t>(options.canard - 1);
  const auto command = degrees(link.reported<protocol::CommandReport>("canard commands").angle[index]);
  const auto& encoders = link.newest<protocol::EncoderReport>();
  const auto encoder = encoders ? degrees(encoders->message.angle[index]) : std::nullopt;
  const auto& status = link.newest<protocol::StatusReport>();
  const bool limited = status && status->message.limited[index];
  if (options.bench.json) {
    return json::Value{{"canard", options.canard},
                       {"asked_deg", options.angle_deg},
                       {"command_deg", json::printed(command, 2)},
                       {"encoder_deg", json::printed(encoder, 2)},
                       {"limited", limited}}
               .dump() +
           "\n";
  }
  return fmt::format("canard {}: asked {:+.2f} deg, command {}{}, encoder {}\n", options.canard, options.angle_deg,
                     text(command, "none (not driven)"), limited ? " (limited)" : "", text(encoder, "no reading"));
}

void hold(const HoldOptions& options) {
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options.bench, place, link);
  link::Session session{place, link, static_cast<std::uint16_t>(std::random_device{}())};
  protocol::PerCanard asked{};
  asked[static_cast<std::size_t>(options.canard - 1)] =
      core::Angle::from_degrees(static_cast<float>(options.angle_deg));
  session.request(asked);
  const hal::Microseconds end = options.seconds
                                    ? place.now() + hal::Microseconds{static_cast<std::int64_t>(1e6 * *options.seconds)}
                                    : hal::Microseconds::max();
  try {
    while (place.now() < end) {
      session.wait(std::min(report_period, end - place.now()));
      if (!show_live(line(options, link))) {
        break;
      }
    }
  } catch (const Interrupted&) {  // NOLINT(bugprone-empty-catch): the way to end it
  }
  say(session.close()
          ? "the canards are centred\n"
          : "the avionics did not confirm that the canards are centred; it centres them by itself 0.1 s after "
            "the last heartbeat\n");
}

}  // namespace

void add_bench_hold(const Verb& bench) {
  auto verb = bench.verb("hold", "Hold one canard at an angle until Ctrl-C and show its encoder; then all are centred");
  auto options = std::make_shared<HoldOptions>();
  verb.option("CANARD", options->canard, "Which canard, 1 to 4").range(1, 4).required();
  verb.option("DEG", options->angle_deg, "Shaft angle, clamped to the limit").range(-20.47, 20.47).required();
  add_bench_options(verb, options->bench, "Print one JSON object a second, one per line");
  add_end_option(verb, options->seconds);
  verb.examples(
      "Examples:\n"
      "  fantail bench hold 2 5 --can can0               canard 2 at 5 deg, to measure it with a gauge; Ctrl-C ends\n"
      "  fantail bench hold 2 -5 --can can0 --for 10     the other side, for ten seconds\n"
      "  fantail bench hold 1 0 --can vcan0 --json       an object a second, for a script");
  verb.action([options] { hold(*options); });
}

}  // namespace fantail::tool
