// SPDX-License-Identifier: MIT
#include "hil/wire.hpp"

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace fantail::hil {
namespace {

constexpr std::chrono::milliseconds patience_to_write{5'000};

bool would_wait() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

void wait_for(int number, short event, std::chrono::milliseconds at_most) {
  pollfd poll{.fd = number, .events = event, .revents = 0};
  (void)::poll(&poll, 1, static_cast<int>(at_most.count()));
}

}  // namespace

void Descriptor::close() {
  if (number_ >= 0) {
    ::close(number_);
    number_ = -1;
  }
}

bool Descriptor::write(std::span<const std::byte> bytes) const {
  const auto end = std::chrono::steady_clock::now() + patience_to_write;
  while (!bytes.empty()) {
    const ssize_t count = ::write(number_, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (!would_wait() || std::chrono::steady_clock::now() >= end) {
      return false;
    } else {
      wait_for(number_, POLLOUT, std::chrono::milliseconds{100});
    }
  }
  return true;
}

std::optional<std::size_t> Descriptor::read(std::span<std::byte> out, std::chrono::milliseconds at_most) const {
  for (bool waited = false;; waited = true) {
    const ssize_t count = ::read(number_, out.data(), out.size());
    if (count > 0) {
      return static_cast<std::size_t>(count);
    }
    if (count == 0 || !would_wait()) {
      return std::nullopt;
    }
    if (waited) {
      return 0;
    }
    wait_for(number_, POLLIN, at_most);
  }
}

std::pair<Descriptor, Descriptor> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::system_error{errno, std::generic_category(), "pipe"};
  }
  return {Descriptor{ends[0]}, Descriptor{ends[1]}};
}

}  // namespace fantail::hil
