// SPDX-License-Identifier: MIT
#include "telemetry/memory_log.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <lcm/lcm.h>

#include "telemetry/event_log.hpp"

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
  if (!write_event(stream_->log, packet)) {
    throw std::bad_alloc{};
  }
}

std::string MemoryLog::take() {
  stream_->close();
  return {stream_->text, stream_->size};
}

}  // namespace fantail::telemetry
