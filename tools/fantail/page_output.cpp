// SPDX-License-Identifier: MIT
#include "fantail/page_output.hpp"

#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "fantail/progress.hpp"
#include "fantail/standard_streams.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {

void add_page_options(const Verb& verb, PageOptions& options, const std::string& what) {
  verb.flag("--page", options.page,
            "Show " + what +
                " on a page in a browser at http://127.0.0.1:8080/, reachable from this computer only. Nothing on the "
                "page can move or arm anything");
  verb.option("--page-at", options.at,
              "The same at another address; 0.0.0.0 can be reached from the network, port 0 means any free port")
      .check(live::objection_to_address)
      .value_name("HOST:PORT");
}

live::Address address_of(const PageOptions& options) {
  return options.at.empty() ? live::Address{} : live::address_of(options.at);
}

void say_where(const live::Broadcast& page) {
  if (std::getenv("FANTAIL_WITH_VCAN") != nullptr) {  // NOLINT(concurrency-mt-unsafe): nobody changes it
    say("page: with-vcan has its own network, so a browser outside of it cannot open this page\n");
  }
  say(fmt::format("page: {}{}\n", page.address().url(),
                  page.address().is_of_this_computer_alone()
                      ? ""
                      : ", can be reached from other computers; nothing on it can move or arm anything"));
}

void wait_for_viewer(const live::Broadcast& page) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds longest{10};
  say(fmt::format("page: starts when a browser opens the page, or after {} s\n", longest.count()));
  for (const auto end = Clock::now() + longest; page.figures().viewers == 0 && Clock::now() < end;) {
    give_up_if_interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  }
}

std::string viewers_text(const live::ServerFigures& figures) {
  return fmt::format("at most {} at the same time, {}, {} dropped because a viewer was slow",
                     text::counted(figures.most_viewers, "viewer"), text::counted(figures.frames_sent, "frame"),
                     figures.frames_dropped);
}

std::string PageOptions::words() const { return at.empty() ? "--page" : "--page-at " + text::shell_word(at); }

PageOutput::PageOutput(const PageOptions& options, live::Source source, const std::string& command) {
  if (!options.wanted()) {
    return;
  }
  const live::PanelWords words{.source = source.name, .command = command, .version = FANTAIL_VERSION};
  page_ = std::make_unique<live::LivePage>(address_of(options), std::move(source), words);
  say_where(page_->broadcast());
}

void PageOutput::wait_for_viewer() const {
  if (page_) {
    tool::wait_for_viewer(page_->broadcast());
  }
}

telemetry::Publisher& PageOutput::publisher() {
  if (!publisher_) {
    publisher_ = std::make_unique<telemetry::Publisher>(std::make_unique<live::PageOutlet>(*page_));
  }
  return *publisher_;
}

void PageOutput::report(const core::TickRecord& record, const telemetry::Surroundings& surroundings) {
  if (!page_) {
    return;
  }
  if (!reporter_) {
    constexpr std::int64_t every_tick = 1;
    reporter_ = std::make_unique<telemetry::TickReporter>(publisher(), every_tick);
  }
  reporter_->report(record, surroundings);
}

telemetry::Sink* PageOutput::sink() { return page_ ? &publisher() : nullptr; }

void PageOutput::take(std::string_view channel, std::span<const std::byte> bytes) {
  if (page_) {
    page_->take(channel, bytes);
  }
}

std::string PageOutput::finish() {
  if (!page_) {
    return {};
  }
  std::uint64_t lost = 0;
  if (publisher_) {
    lost = publisher_->finish().dropped;
  } else {
    page_->finish();
  }
  return viewers_text(page_->broadcast().figures()) +
         (lost > 0 ? fmt::format("; {} never reached the page", text::counted(lost, "message")) : "");
}

}  // namespace fantail::tool
