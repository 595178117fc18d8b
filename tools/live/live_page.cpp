// SPDX-License-Identifier: MIT
#include "live/live_page.hpp"

#include <utility>

namespace fantail::live {

LivePage::LivePage(const Address& address, Source source, const PanelWords& words)
    : feed_{std::move(source)},
      broadcast_{address, panel(words), [this] { return feed_.frame(now()); },
                 [this] { return feed_.greeting(now()); }} {}

hal::Microseconds LivePage::now() const {
  return std::chrono::duration_cast<hal::Microseconds>(std::chrono::steady_clock::now() - begin_);
}

void LivePage::take(std::string_view channel, std::span<const std::byte> bytes) { feed_.take(channel, bytes, now()); }

void LivePage::finish() {
  feed_.end();
  broadcast_.finish();
}

}  // namespace fantail::live
