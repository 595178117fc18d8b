// SPDX-License-Identifier: MIT
#include "hil/wire.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
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
  // Waits first: who reads has just asked, and nothing has come yet.
  wait_for(number_, POLLIN, at_most);
  const ssize_t count = ::read(number_, out.data(), out.size());
  if (count > 0) {
    return static_cast<std::size_t>(count);
  }
  return count < 0 && would_wait() ? std::optional<std::size_t>{0} : std::nullopt;
}

std::pair<Descriptor, Descriptor> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::system_error{errno, std::generic_category(), "pipe"};
  }
  return {Descriptor{ends[0]}, Descriptor{ends[1]}};
}

SerialPort::SerialPort(std::string device) : device_{std::move(device)} {
  // Without O_NONBLOCK the opening of a modem would wait for a carrier.
  port_ = Descriptor{::open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
  if (port_.number() < 0) {
    refuse(errno == ENOENT ? "there is no such device; is the board plugged in?" : std::strerror(errno));
  }
  // Both, since root is not bound by the first, and not everybody asks for the second.
  if (::flock(port_.number(), LOCK_EX | LOCK_NB) != 0 ||
      (::isatty(port_.number()) == 1 && ::ioctl(port_.number(), TIOCEXCL) != 0)) {
    refuse(errno == EWOULDBLOCK ? "another program is using it" : std::strerror(errno));
  }
  termios settings{};
  if (::tcgetattr(port_.number(), &settings) != 0) {
    refuse("it is not a serial port");
  }
  ::cfmakeraw(&settings);
  settings.c_cflag |= static_cast<tcflag_t>(CLOCAL | CREAD);
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
  settings.c_cc[VMIN] = 1;  // with 0, nothing that has come yet would look like the end
  settings.c_cc[VTIME] = 0;
  if (::cfsetspeed(&settings, B921600) != 0 || ::tcsetattr(port_.number(), TCSANOW, &settings) != 0) {
    refuse(std::strerror(errno));
  }
  ::tcflush(port_.number(), TCIOFLUSH);
}

void SerialPort::refuse(const std::string& why) const { throw TargetError{device_ + ": " + why}; }

void SerialPort::write(std::span<const std::byte> bytes) {
  if (!port_.write(bytes)) {
    refuse("writing to the flight computer failed; was it unplugged?");
  }
}

std::size_t SerialPort::read(std::span<std::byte> out, std::chrono::milliseconds at_most) {
  const auto count = port_.read(out, at_most);
  if (!count) {
    refuse("the connection was lost; was it unplugged?");
  }
  return *count;
}

}  // namespace fantail::hil
