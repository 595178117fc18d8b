// SPDX-License-Identifier: MIT
#include "telemetry/publisher.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include <lcm/lcm.h>

namespace fantail::telemetry {
namespace {

// Appends a packet to an LCM log, with the avionics' clock. False: it was not written.
bool write_event(lcm_eventlog_t& log, const Packet& packet) {
  std::string channel{name(packet.channel)};
  auto bytes = packet.bytes;
  lcm_eventlog_event_t event{.eventnum = 0,
                             .timestamp = packet.time.count(),
                             .channellen = static_cast<std::int32_t>(channel.size()),
                             .datalen = static_cast<std::int32_t>(packet.size),
                             .channel = channel.data(),
                             .data = bytes.data()};
  return lcm_eventlog_write_event(&log, &event) == 0;
}

class NetworkOutlet final : public Outlet {
 public:
  explicit NetworkOutlet(const Url& url) {
    require_route(url);
    lcm_.reset(lcm_create(url.text().c_str()));
    if (!lcm_) {
      throw TelemetryError{url.text() + ": LCM could not be started; see its own message above"};
    }
  }
  bool put(const Packet& packet) override {
    const std::string channel{name(packet.channel)};
    return lcm_publish(lcm_.get(), channel.c_str(), packet.bytes.data(), static_cast<unsigned>(packet.size)) >= 0;
  }
  bool close() override { return true; }
  // A receiver's buffer holds a few hundred packets, and a simulated flight is over in a moment. Ten times as fast as
  // real time is what lcm-logger has been seen to keep up with, on a busy machine with one processor.
  [[nodiscard]] std::optional<int> most_per_second() const override { return 2'000; }

 private:
  struct Destroy {
    void operator()(lcm_t* lcm) const { lcm_destroy(lcm); }
  };
  std::unique_ptr<lcm_t, Destroy> lcm_;
};

// Not LCM's own file outlet: that one does not notice a full disk, and its clock is that of the computer, on which a
// simulated flight is over in a moment.
class FileOutlet final : public Outlet {
 public:
  explicit FileOutlet(const std::string& path) {
    spare_other_files(path);
    log_.reset(lcm_eventlog_create(path.c_str(), "w"));
    if (!log_) {
      throw TelemetryError{path + ": " + std::strerror(errno)};
    }
  }
  bool put(const Packet& packet) override { return write_event(*log_, packet); }
  bool close() override { return std::fflush(log_->f) == 0 && std::ferror(log_->f) == 0; }
  [[nodiscard]] std::optional<int> most_per_second() const override { return std::nullopt; }

 private:
  /// An event begins with this word, in network order. An empty file may be replaced, too.
  static void spare_other_files(const std::string& path) {
    constexpr std::array<unsigned char, 4> sync{0xED, 0xA1, 0xDA, 0x01};
    std::array<unsigned char, 4> first{};
    std::ifstream file{path, std::ios::binary};
    if (!std::filesystem::is_regular_file(path) || file.peek() == std::ifstream::traits_type::eof()) {
      return;
    }
    file.read(reinterpret_cast<char*>(first.data()), first.size());  // NOLINT: bytes as bytes
    if (first != sync) {
      throw TelemetryError{path + ": exists and is not an LCM log; allowed: a new name, or an LCM log to be replaced"};
    }
  }

  struct Destroy {
    void operator()(lcm_eventlog_t* log) const { lcm_eventlog_destroy(log); }
  };
  std::unique_ptr<lcm_eventlog_t, Destroy> log_;
};

constexpr std::chrono::milliseconds rest{2};

}  // namespace

std::unique_ptr<Outlet> open_outlet(const Url& url) {
  if (url.is_file()) {
    return std::make_unique<FileOutlet>(url.path());
  }
  return std::make_unique<NetworkOutlet>(url);
}

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

Publisher::Publisher(std::unique_ptr<Outlet> outlet, std::size_t most_waiting)
    : outlet_{std::move(outlet)}, queue_{most_waiting}, thread_{[this] { work(); }} {}

Publisher::~Publisher() {
  give_up_ = true;
  finish();
}

void Publisher::send(const Packet& packet) { dropped_ += queue_.push(packet) ? 0 : 1; }

PublisherFigures Publisher::finish() {
  finish_ = true;
  if (thread_.joinable()) {
    thread_.join();
    complete_ = outlet_->close();
  }
  return figures();
}

PublisherFigures Publisher::figures() const {
  return {.published = published_, .dropped = dropped_, .failed = failed_, .complete = complete_};
}

void Publisher::work() {
  const auto most_per_second = outlet_->most_per_second();
  const std::size_t most = most_per_second ? static_cast<std::size_t>(*most_per_second * rest.count() / 1000)
                                           : std::numeric_limits<std::size_t>::max();
  while (!give_up_) {
    const bool last_round = finish_;  // before the look into the queue: nothing is sent after finish()
    publish_batch(most);
    if (last_round && queue_.front() == nullptr) {
      return;
    }
    std::this_thread::sleep_for(rest);
  }
}

void Publisher::publish_batch(std::size_t most) {
  for (std::size_t i = 0; i < most && !give_up_; ++i) {
    const Packet* packet = queue_.front();
    if (packet == nullptr) {
      return;
    }
    (outlet_->put(*packet) ? published_ : failed_) += 1;
    queue_.pop();
  }
}

}  // namespace fantail::telemetry
