// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "live/feed.hpp"
#include "live/panel.hpp"
#include "live/server.hpp"
#include "telemetry/publisher.hpp"

namespace fantail::live {

/// A page of what is heard of a rocket, for browsers: served, and brought up to date 40 times a second, by threads of
/// its own.
class LivePage {
 public:
  /// Throws std::runtime_error when the address cannot be listened at.
  LivePage(const Address& address, Source source, const PanelWords& words);
  ~LivePage();
  LivePage(const LivePage&) = delete;
  LivePage& operator=(const LivePage&) = delete;

  /// Whatever came on a channel of LCM; for one thread.
  void take(std::string_view channel, std::span<const std::byte> bytes);
  /// What has been taken so far is shown, and that no more comes, also when the program ends behind it.
  void finish();

  [[nodiscard]] const Address& address() const { return server_.address(); }
  [[nodiscard]] ServerFigures figures() const { return server_.figures(); }

 private:
  void work();
  [[nodiscard]] hal::Microseconds now() const;

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Feed feed_;
  Server server_;
  std::atomic<bool> end_ = false;
  std::thread thread_;
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
