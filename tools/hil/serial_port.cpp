// SPDX-License-Identifier: MIT
#include "hil/serial_port.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace fantail::hil {

SerialPort::SerialPort(std::string device) : device_{std::move(device)} {
  // Without O_NONBLOCK the opening of a modem would wait for a carrier.
  port_ = Descriptor{::open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
  if (port_.number() < 0) {
    refuse(errno == ENOENT ? "there is no such device; is the board plugged in?" : std::strerror(errno));
  }
  // Both, since root is not bound by the first, and not everybody asks for the second.
  if (::flock(port_.number(), LOCK_EX | LOCK_NB) != 0 ||
      (::isatty(port_.number()) == 1 && ::ioctl(port_.number(), TIOCEXCL) != 0)) {
    refuse(errno == EWOULDBLOCK ? "another program has it" : std::strerror(errno));
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
    refuse("the flight computer takes nothing any more; was it unplugged?");
  }
}

std::size_t SerialPort::read(std::span<std::byte> out, std::chrono::milliseconds at_most) {
  const auto count = port_.read(out, at_most);
  if (!count) {
    refuse("it is gone; was it unplugged?");
  }
  return *count;
}

}  // namespace fantail::hil
