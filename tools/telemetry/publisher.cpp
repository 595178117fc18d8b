// SPDX-License-Identifier: MIT
#include "telemetry/publisher.hpp"

#include <chrono>
#include <limits>
#include <utility>

namespace fantail::telemetry {
namespace {

constexpr std::chrono::milliseconds rest{2};

}  // namespace

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
