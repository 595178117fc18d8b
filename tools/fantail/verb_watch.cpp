// SPDX-License-Identifier: MIT
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "fantail/lcm_output.hpp"
#include "fantail/live_screen.hpp"
#include "fantail/page_output.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "hal/linux/clock.hpp"
#include "telemetry/panel.hpp"
#include "telemetry/receiver.hpp"
#include "text/error.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

struct WatchOptions {
  std::string url;
  std::optional<double> seconds;
  bool json = false;
  PageOptions page;
};

// A person reads a few times a second, a log once.
constexpr hal::Microseconds screen_period{200'000};
constexpr hal::Microseconds line_period{1'000'000};

/// Listens until `end`. False: there will be no more, or Ctrl-C.
bool listen_until(hal::Microseconds end, const hal::Clock& clock, telemetry::Subscription& subscription,
                  const telemetry::Subscription::Take& take) {
  using std::chrono::milliseconds;
  for (hal::Microseconds now = clock.now(); now < end; now = clock.now()) {
    subscription.wait(std::chrono::ceil<milliseconds>(end - now));
    if (!subscription.listen(take) || take_interrupt()) {
      return false;
    }
  }
  return true;
}

void watch(const WatchOptions& options) {
  telemetry::Subscription subscription{telemetry::Url{options.url}};
  telemetry::Receiver receiver;
  telemetry::Panel panel{options.url, receiver};
  const hal::on_linux::Clock clock;
  PageOutput page{options.page,
                  {.name = options.url},
                  "fantail watch --lcm " + text::shell_word(options.url) + " " + options.page.words()};
  const auto take = [&](std::string_view channel, std::span<const std::byte> bytes) {
    receiver.take(channel, bytes, clock.now());
    page.take(channel, bytes);
  };
  std::optional<LiveScreen> screen;
  if (!options.json && output_is_screen()) {
    screen.emplace();
  }
  const hal::Microseconds period = screen ? screen_period : line_period;
  const hal::Microseconds end =
      options.seconds ? hal::Microseconds{static_cast<std::int64_t>(1e6 * *options.seconds)} : hal::Microseconds::max();
  bool more = true;
  for (hal::Microseconds next = std::min(period, end); more; next = std::min(next + period, end)) {
    more = listen_until(next, clock, subscription, take) && next < end;
    panel.look(clock.now());
    if (!(screen ? screen->draw(painted_phase(panel.table(output_columns())))
                 : show_live(options.json ? panel.json() : panel.lines()))) {
      return;
    }
  }
  screen.reset();
  if (const std::string shown = page.finish(); !shown.empty()) {
    say("page: " + shown + "\n");
  }
  if (const std::uint64_t bytes = subscription.foreign_bytes(); bytes > 0) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: {} bytes are not part of a complete event: the log was cut off or is damaged; "
                                  "its complete events were shown",
                                  options.url, bytes)};
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<WatchOptions>();
  add_lcm_option(verb, options->url, "Where the messages come from").required();
  add_end_option(verb, options->seconds, "--for,--seconds");
  verb.flag("--json", options->json, "Print one JSON object a second, one per line");
  add_page_options(verb, options->page);
  verb.examples(
      "Examples:\n"
      "  fantail watch --lcm udpm://239.255.76.67:7667            a live panel; Ctrl-C ends\n"
      "  fantail watch --lcm udpm:// | tee flight.txt             lines, from LCM's default address\n"
      "  fantail watch --lcm udpm:// --page                       also on a page in a browser\n"
      "  fantail watch --lcm file:///tmp/flight.lcmlog --json     a log at its own pace, for a script");
  verb.action([options] {
    try {
      watch(*options);
    } catch (const Interrupted&) {
      return;  // while a pipe gave nothing: Ctrl-C is how this ends
    }
  });
}

const VerbCode code{"watch", fill};

}  // namespace
}  // namespace fantail::tool
