// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "telemetry/messages.hpp"
#include "telemetry/sender.hpp"
#include "telemetry/url.hpp"

namespace fantail::telemetry {

/// Where packets leave the program. May wait: it is called by the publisher's own thread.
class Outlet {
 public:
  virtual ~Outlet() = default;
  /// False: this one is lost.
  virtual bool put(const Packet& packet) = 0;
  /// After the last one. False: some of what was put did not arrive after all (a full disk).
  virtual bool close() = 0;
  /// As many a second as receivers can be expected to take; empty: any number.
  [[nodiscard]] virtual std::optional<int> most_per_second() const = 0;
};

/// The network, or a log file for lcm-logplayer whose clock is that of the avionics. An old file of that name is
/// overwritten. Throws TelemetryError.
[[nodiscard]] std::unique_ptr<Outlet> open_outlet(const Url& url);

/// An LCM log in memory, for what is to be written as a whole or not at all. Its clock is that of the avionics.
class MemoryLog final : public Sink {
 public:
  MemoryLog();
  ~MemoryLog() override;
  MemoryLog(const MemoryLog&) = delete;
  MemoryLog& operator=(const MemoryLog&) = delete;

  void send(const Packet& packet) override;

  /// All that was sent, as the content of a file; to be called once, at the end.
  [[nodiscard]] std::string take();

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace fantail::telemetry
