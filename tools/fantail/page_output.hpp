// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "fantail/command_line.hpp"
#include "live/live_page.hpp"
#include "telemetry/publisher.hpp"
#include "telemetry/tick_reporter.hpp"

namespace fantail::tool {

struct PageOptions {
  bool page = false;
  std::string at;  ///< checked; empty: live::Address{}

  [[nodiscard]] bool wanted() const { return page || !at.empty(); }
  /// As it was typed: "--page-at HOST:PORT".
  [[nodiscard]] std::string words() const;
};

/// --page and --page-at. `what` is shown: "the flight live".
void add_page_options(const Verb& verb, PageOptions& options, const std::string& what = "the flight live");
[[nodiscard]] live::Address address_of(const PageOptions& options);
/// On standard error.
void say_where(const live::Broadcast& page);
/// For a run that starts with the program: prints so, and waits until a browser has opened the page, at most 10 s.
/// Throws Interrupted.
void wait_for_viewer(const live::Broadcast& page);
/// One sentence.
[[nodiscard]] std::string viewers_text(const live::ServerFigures& figures);

/// A verb's page for browsers. Without the option it does nothing.
class PageOutput {
 public:
  /// Prints the address of the page on standard error. Throws std::runtime_error if it cannot be served there.
  /// `command` made it, as a person would type it.
  PageOutput(const PageOptions& options, live::Source source, const std::string& command);

  [[nodiscard]] bool is_on() const { return page_ != nullptr; }
  void wait_for_viewer() const;
  /// Every tick goes to the page, through a thread of its own.
  void report(const core::TickRecord& record, const telemetry::Surroundings& surroundings);
  /// For messages that are there already; through a thread of its own, too. Null without the option.
  [[nodiscard]] telemetry::Sink* sink();
  /// For messages that were received. Not together with the two above.
  void take(std::string_view channel, std::span<const std::byte> bytes);

  /// The end is shown; one sentence on the viewers, empty without the option.
  std::string finish();

 private:
  telemetry::Publisher& publisher();

  std::unique_ptr<live::LivePage> page_;
  std::unique_ptr<telemetry::Publisher> publisher_;
  std::unique_ptr<telemetry::TickReporter> reporter_;
};

}  // namespace fantail::tool
