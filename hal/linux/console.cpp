// SPDX-License-Identifier: MIT
#include "hal/linux/console.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstddef>

#include <poll.h>
#include <unistd.h>

namespace fantail::hal::on_linux {

void Console::write(std::string_view text) {
  while (!text.empty()) {
    // Not O_NONBLOCK: that would change the stream for every program that shares it.
    pollfd stream{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
    if (poll(&stream, 1, 0) <= 0 || (stream.revents & POLLOUT) == 0) {
      return;
    }
    // A pipe that is ready takes at least this much without waiting.
    const ssize_t written = ::write(STDERR_FILENO, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
    if (written < 0 && errno != EINTR) {
      return;
    }
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

}  // namespace fantail::hal::on_linux
