// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "telemetry/sink.hpp"

namespace fantail::telemetry {

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
