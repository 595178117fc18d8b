// SPDX-License-Identifier: MIT
#include "live/live_page.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace fantail::live {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

LivePage::LivePage(const Address& address, Source source, const PanelWords& words)
    : feed_{std::move(source)},
      server_{address, panel(words), [this] { return feed_.greeting(now()); }},
      thread_{[this] { work(); }} {}

hal::Microseconds LivePage::now() const { return std::chrono::duration_cast<hal::Microseconds>(Clock::now() - begin_); }

LivePage::~LivePage() {
  end_ = true;
  thread_.join();
}

void LivePage::take(std::string_view channel, std::span<const std::byte> bytes) { feed_.take(channel, bytes, now()); }

void LivePage::finish() {
  feed_.end();
  server_.show(feed_.frame(now()));
  // Viewers take a frame within milliseconds; the connection goes with the program.
  std::this_thread::sleep_for(std::chrono::milliseconds{100});
}

void LivePage::work() {
  for (auto next = Clock::now(); !end_; next = std::max(next, Clock::now())) {
    server_.show(feed_.frame(now()));
    next += std::chrono::duration_cast<Clock::duration>(PlotHistory::stretch);
    std::this_thread::sleep_until(next);
  }
}

}  // namespace fantail::live
