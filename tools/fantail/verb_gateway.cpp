// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "fantail/can_place.hpp"
#include "fantail/lcm_output.hpp"
#include "fantail/offers.hpp"
#include "fantail/page_output.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "gateway/gateway.hpp"
#include "link/place.hpp"
#include "link/session.hpp"
#include "replies/sentence.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

struct GatewayOptions {
  std::string interface;
  std::string url;
  PageOptions page;
  std::optional<double> seconds;
};

constexpr hal::Microseconds longest_wait{100'000};
constexpr hal::Microseconds longest_silence{2'000'000};
constexpr hal::Microseconds between_words{1'000'000};

/// Says on standard error what a person should know while it happens.
class StatusPrinter {
 public:
  StatusPrinter(std::string interface, const gateway::Gateway& gateway, const telemetry::Publisher* publisher,
                hal::Microseconds now)
      : interface_{std::move(interface)}, gateway_{gateway}, publisher_{publisher}, silence_{longest_silence, now} {}

  void look(hal::Microseconds now) {
    if (gateway_.bus_state() != state_) {
      state_ = gateway_.bus_state();
      tell(fmt::format("bus: {}", replies::name(state_)));
    }
    const bool spoken = gateway_.heard().frames != frames_;
    if (spoken) {
      frames_ = gateway_.heard().frames;
      silence_.restart();
    }
    const bool silent = !spoken && silence_.expired(now);
    if (silent != silent_) {
      silent_ = silent;
      tell(silent ? "the avionics is silent" : "the avionics reports again");
    }
    if (gateway_.restarts() != restarts_) {
      restarts_ = gateway_.restarts();
      tell("the avionics has been switched on again");
    }
    if (now < next_count_) {
      return;
    }
    next_count_ = now + between_words;
    const std::uint64_t lost = gateway_.heard().lost + gateway_.overrun();
    if (lost > lost_) {
      tell(text::counted(lost - lost_, "frame") + " lost");
      lost_ = lost;
    }
    const std::uint64_t failed = publisher_ != nullptr ? publisher_->figures().failed : 0;
    if (failed > 0 && !failure_told_) {
      failure_told_ = true;
      tell("LCM does not accept the messages: is the network down?");
    }
  }

 private:
  void tell(const std::string& what) const { say(fmt::format("{}: {}\n", interface_, what)); }

  std::string interface_;
  const gateway::Gateway& gateway_;
  const telemetry::Publisher* publisher_;  ///< null: no LCM
  link::Timeout silence_;
  std::uint64_t frames_ = 0;
  hal::CanState state_ = hal::CanState::error_active;
  hal::Microseconds next_count_{};
  std::uint64_t lost_ = 0;
  int restarts_ = 0;
  bool silent_ = false;
  bool failure_told_ = false;
};

/// To the network, to the page, or to both.
class Outlets final : public telemetry::Sink {
 public:
  Outlets(telemetry::Sink* lcm, telemetry::Sink* page) : sinks_{lcm, page} {}
  void send(const telemetry::Packet& packet) override {
    for (telemetry::Sink* sink : sinks_) {
      if (sink != nullptr) {
        sink->send(packet);
      }
    }
  }

 private:
  std::array<telemetry::Sink*, 2> sinks_;
};

void run(const GatewayOptions& options) {
  if (options.url.empty() && !options.page.wanted()) {
    throw UsageError{"there is no destination: --lcm URL, --page or both are needed"};
  }
  CanPlace place{options.interface};
  std::unique_ptr<telemetry::Publisher> publisher;
  if (!options.url.empty()) {
    publisher = std::make_unique<telemetry::Publisher>(telemetry::open_outlet(telemetry::Url{options.url}));
  }
  PageOutput page{options.page,
                  {.name = options.interface},
                  "fantail gateway --can " + text::shell_word(options.interface) + " " + options.page.words()};
  Outlets outlets{publisher.get(), page.sink()};
  gateway::Gateway gateway{place.bus(), outlets};
  StatusPrinter printer{options.interface, gateway, publisher.get(), place.now()};
  show("{} to {}; Ctrl-C ends\n", options.interface, options.url.empty() ? "the page" : options.url);
  std::fflush(stdout);
  const hal::Microseconds end = options.seconds
                                    ? place.now() + hal::Microseconds{static_cast<std::int64_t>(1e6 * *options.seconds)}
                                    : hal::Microseconds::max();
  try {
    while (place.now() < end) {
      place.wait(std::min(longest_wait, end - place.now()));
      gateway.listen(place.now());
      gateway.expect_one_rocket();
      printer.look(place.now());
    }
  } catch (const Interrupted&) {  // NOLINT(bugprone-empty-catch): the way to end it
  }
  const link::LinkFigures& heard = gateway.heard();
  show("frames: {} from the avionics, {} lost, {} damaged, {} foreign, {} overrun\n", heard.frames, heard.lost,
       heard.damaged, heard.foreign, gateway.overrun());
  if (const std::string shown = page.finish(); !shown.empty()) {
    show("page: {}\n", shown);
  }
  if (publisher) {
    show("{}\n", report_of(publisher->finish(), options.url));
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<GatewayOptions>();
  add_can_option(verb, options->interface);
  add_lcm_option(verb, options->url, "Where the messages go");
  add_page_options(verb, options->page);
  add_end_option(verb, options->seconds, "--for,--seconds");
  verb.examples(
      "Examples:\n"
      "  fantail gateway --can can0 --lcm 'udpm://239.255.76.67:7667?ttl=1'    for everyone on this network\n"
      "  fantail gateway --can can0 --lcm udpm://                              for this computer alone\n"
      "  fantail gateway --can can0 --page                                     on a page, for a browser\n"
      "  fantail gateway --can vcan0 --lcm file:///tmp/pad.lcmlog --for 60     a minute, into a log");
  verb.action([options] { run(*options); });
}

const VerbCode code{"gateway", fill};

}  // namespace
}  // namespace fantail::tool
