// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "system/process.hpp"

namespace fantail::test {

/// A terminal of so many columns and 24 rows.
class Screen {
 public:
  explicit Screen(unsigned short columns) : reader_{posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)} {
    const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    if (reader_ < 0 || grantpt(reader_) != 0 || unlockpt(reader_) != 0 || ioctl(reader_, TIOCSWINSZ, &size) != 0) {
      throw std::runtime_error{"no terminal"};
    }
    name_ = ptsname(reader_);
  }
  ~Screen() { close(reader_); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// The fantail program with this terminal as standard output; what is drawn on it is in `out`. `seen` is told after
  /// each piece what has been drawn, and which process draws.
  [[nodiscard]] Outcome fantail(const std::vector<std::string>& words, Surroundings surroundings,
                                const std::function<void(int, const std::string&)>& seen = {}) {
    std::string drawn;
    surroundings.prepare = [before = surroundings.prepare, show = redirect(STDOUT_FILENO, name_)] {
      before();
      show();
    };
    // Once the program has left, reading is an error.
    surroundings.meanwhile = [this, &drawn, &seen](int process) {
      std::array<char, 65536> buffer{};
      for (ssize_t count = 0; (count = read(reader_, buffer.data(), buffer.size())) > 0;) {
        drawn.append(buffer.data(), static_cast<std::size_t>(count));
        if (seen) {
          seen(process, drawn);
        }
      }
    };
    Outcome outcome = test::fantail(words, surroundings);
    outcome.out = drawn;
    return outcome;
  }

 private:
  int reader_;
  std::string name_;
};

}  // namespace fantail::test
