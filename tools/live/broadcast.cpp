// SPDX-License-Identifier: MIT
#include "live/broadcast.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace fantail::live {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds between_frames{25};

}  // namespace

Broadcast::Broadcast(const Address& address, Page page, std::function<std::string()> frame,
                     const std::function<std::string()>& greeting)
    : frame_{std::move(frame)}, server_{address, std::move(page), greeting}, thread_{[this] { work(); }} {}

Broadcast::~Broadcast() {
  end_ = true;
  thread_.join();
}

void Broadcast::finish() {
  show_next();
  // Viewers take a frame within milliseconds; the connection goes with the program.
  std::this_thread::sleep_for(std::chrono::milliseconds{100});
}

void Broadcast::show_next() {
  const std::scoped_lock lock{mutex_};
  server_.show(frame_());
}

void Broadcast::work() {
  for (auto next = Clock::now(); !end_; next = std::max(next, Clock::now())) {
    show_next();
    next += between_frames;
    std::this_thread::sleep_until(next);
  }
}

}  // namespace fantail::live
