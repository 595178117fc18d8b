// SPDX-License-Identifier: MIT
#include "hal/linux/can_bus.hpp"

#include <algorithm>
#include <utility>

#include "hal/linux/can_interface.hpp"

namespace fantail::hal::on_linux {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_looks{100};
// The kernel does not say when its own queue has room again.
constexpr std::chrono::milliseconds between_flushes{1};
// A bus that is nothing but errors must not hold up a call.
constexpr int most_errors_per_call = 64;

}  // namespace

CanBus::CanBus(std::string interface, std::span<const CanFilter> filters) : socket_{std::move(interface), filters} {}

bool CanBus::send(const CanFrame& frame) {
  flush();
  if (!fits_can(frame) || !reachable() || state_ == CanState::bus_off || waiting_ == queue_size) {
    ++counters_.unsent;
    return false;
  }
  queue_[(first_ + waiting_) % queue_size] = frame;
  ++waiting_;
  flush();
  return state_ != CanState::down;
}

void CanBus::flush() {
  while (waiting_ > 0) {
    switch (socket_.write(queue_[first_])) {
      case WriteResult::done: ++counters_.sent; break;
      case WriteResult::refused: ++counters_.unsent; break;
      case WriteResult::full: return;
      case WriteResult::down: go_down(false); return;
      case WriteResult::vanished: go_down(true); return;
    }
    first_ = (first_ + 1) % queue_size;
    --waiting_;
  }
}

std::optional<CanFrame> CanBus::receive() {
  flush();
  for (int i = 0; i < most_errors_per_call && reachable(); ++i) {
    const Arrival arrival = socket_.read();
    counters_.overrun += arrival.lost;
    switch (arrival.kind) {
      case ArrivalKind::frame: ++counters_.received; return arrival.frame;
      case ArrivalKind::error: note(arrival.error); break;
      case ArrivalKind::nothing: return {};
      case ArrivalKind::down: go_down(false); break;
      case ArrivalKind::vanished: go_down(true); break;
    }
  }
  return {};
}

void CanBus::note(const ErrorFrame& error) {
  ++counters_.errors;
  counters_.overrun += error.controller_overrun ? 1U : 0U;
  state_ = error.state.value_or(state_);
  if (state_ == CanState::bus_off) {
    empty_queue();
  }
}

void CanBus::go_down(bool vanished) {
  state_ = CanState::down;
  vanished_ = vanished_ || vanished;
  empty_queue();
}

void CanBus::empty_queue() {
  counters_.unsent += static_cast<std::uint32_t>(waiting_);
  waiting_ = 0;
}

bool CanBus::reachable() {
  if (state_ != CanState::down) {
    return true;
  }
  const auto now = steady_clock::now();
  if (looked_ && now - *looked_ < between_looks) {
    return false;
  }
  looked_ = now;
  const auto found = find_interface(socket_.interface());
  if (!found || !found->up) {
    return false;
  }
  // The same name with another number is another interface, which the socket does not hear.
  if ((vanished_ || found->index != socket_.interface_index()) && !socket_.reopen()) {
    return false;
  }
  vanished_ = false;
  state_ = CanState::error_active;
  return true;
}

bool CanBus::wait(std::chrono::microseconds longest) {
  const auto end = steady_clock::now() + longest;
  for (;;) {
    flush();
    const bool heard = reachable();
    const auto left = std::chrono::ceil<std::chrono::microseconds>(end - steady_clock::now());
    auto pause = std::max(left, std::chrono::microseconds{0});
    if (waiting_ > 0) {
      pause = std::min<std::chrono::microseconds>(pause, between_flushes);
    }
    if (!heard) {
      pause = std::min<std::chrono::microseconds>(pause, between_looks);
    }
    // A socket without its interface would be readable for ever.
    const Wake wake = heard ? socket_.sleep(pause) : sleep_deaf(pause);
    if (wake == Wake::arrived) {
      return true;
    }
    if (wake == Wake::signal || steady_clock::now() >= end) {
      return false;
    }
  }
}

}  // namespace fantail::hal::on_linux
