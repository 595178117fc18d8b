// SPDX-License-Identifier: MIT
#include "linux/adapter.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "linux/shell.hpp"

namespace fantail::test {
namespace {

constexpr int slcan_discipline = 17;  // N_SLCAN; glibc has no name for it

[[noreturn]] void give_up(const char* what) { throw std::system_error{errno, std::generic_category(), what}; }

}  // namespace

Adapter::Adapter() : line_{posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)} {
  if (line_ < 0 || grantpt(line_) != 0 || unlockpt(line_) != 0) {
    give_up("pseudo-terminal");
  }
  terminal_ = open(ptsname(line_), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios mode{};
  if (terminal_ < 0 || tcgetattr(terminal_, &mode) != 0) {
    give_up("its other end");
  }
  cfmakeraw(&mode);
  tcsetattr(terminal_, TCSANOW, &mode);
  if (ioctl(terminal_, TIOCSETD, &slcan_discipline) != 0) {
    give_up("the slcan driver");
  }
  std::array<char, IFNAMSIZ> name{};
  if (ioctl(terminal_, SIOCGIFNAME, name.data()) != 0) {
    give_up("the interface's name");
  }
  interface_ = name.data();
  must("ip link set " + interface_ + " up");
  thread_ = std::thread{[this] { work(); }};
}

Adapter::~Adapter() {
  reads_ = true;
  close(terminal_);  // takes the interface away, and waits until it has sent what it had
  ends_ = true;
  thread_.join();
  close(line_);
}

void Adapter::say(const std::vector<std::string>& lines) {
  for (const std::string& each : lines) {
    const std::string ended = each + "\r";
    if (write(line_, ended.data(), ended.size()) != static_cast<ssize_t>(ended.size())) {
      give_up("the adapter's line");
    }
  }
}

std::vector<std::string> Adapter::taken() {
  const std::lock_guard lock{mutex_};
  return taken_;
}

void Adapter::work() {
  std::string begun;
  while (!ends_) {
    pollfd line{.fd = line_, .events = POLLIN, .revents = 0};
    if (!reads_ || poll(&line, 1, 10) <= 0 || (line.revents & POLLIN) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
      continue;
    }
    std::array<char, 512> part{};
    const ssize_t count = read(line_, part.data(), part.size());
    for (ssize_t i = 0; i < count; ++i) {
      const char letter = part[static_cast<std::size_t>(i)];
      if (letter != '\r') {
        begun += letter;
        continue;
      }
      if (begun.starts_with('t')) {
        const std::lock_guard lock{mutex_};
        taken_.push_back(begun);
      }
      begun.clear();
    }
  }
}

}  // namespace fantail::test
