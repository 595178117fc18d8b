// SPDX-License-Identifier: MIT
#include "telemetry/memory_log.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <lcm/lcm.h>

namespace fantail::telemetry {

struct MemoryLog::Stream {
  char* text = nullptr;
  std::size_t size = 0;
  lcm_eventlog_t log{};

  void close() {
    if (log.f != nullptr && std::fclose(log.f) != 0) {
      log.f = nullptr;
      throw std::bad_alloc{};  // the only way in which memory does not take what is written
    }
    log.f = nullptr;
  }
};

MemoryLog::MemoryLog() : stream_{std::make_unique<Stream>()} {
  stream_->log.f = open_memstream(&stream_->text, &stream_->size);
  if (stream_->log.f == nullptr) {
    throw std::bad_alloc{};
  }
}

MemoryLog::~MemoryLog() {
  if (stream_->log.f != nullptr) {
    (void)std::fclose(stream_->log.f);
  }
  std::free(stream_->text);  // NOLINT: open_memstream's
}

void MemoryLog::send(const Packet& packet) {
  std::string channel{name(packet.channel)};
  auto bytes = packet.bytes;
  lcm_eventlog_event_t event{.eventnum = 0,
                             .timestamp = packet.time.count(),
                             .channellen = static_cast<std::int32_t>(channel.size()),
                             .datalen = static_cast<std::int32_t>(packet.size),
                             .channel = channel.data(),
                             .data = bytes.data()};
  if (lcm_eventlog_write_event(&stream_->log, &event) != 0) {
    throw std::bad_alloc{};
  }
}

std::string MemoryLog::take() {
  stream_->close();
  return {stream_->text, stream_->size};
}

}  // namespace fantail::telemetry
