// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "live/broadcast.hpp"
#include "live/feed.hpp"
#include "live/panel.hpp"
#include "telemetry/publisher.hpp"

namespace fantail::live {

/// A page for browsers with the messages of a rocket.
class LivePage {
 public:
  /// Throws std::runtime_error when the address cannot be listened at.
  LivePage(const Address& address, Source source, const PanelWords& words);

  /// Whatever came on a channel of LCM; for one thread.
  void take(std::string_view channel, std::span<const std::byte> bytes);
  /// What has been taken so far is shown, and that no more comes, also when the program ends behind it.
  void finish();

  [[nodiscard]] const Broadcast& broadcast() const { return broadcast_; }

 private:
  [[nodiscard]] hal::Microseconds now() const;

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Feed feed_;
  Broadcast broadcast_;
};

/// The page as the place where a publisher's packets go.
class PageOutlet final : public telemetry::Outlet {
 public:
  explicit PageOutlet(LivePage& page) : page_{page} {}
  bool put(const telemetry::Packet& packet) override {
    page_.take(telemetry::name(packet.channel), packet.content());
    return true;
  }
  bool close() override {
    page_.finish();
    return true;
  }
  [[nodiscard]] std::optional<int> most_per_second() const override { return std::nullopt; }

 private:
  LivePage& page_;
};

}  // namespace fantail::live
