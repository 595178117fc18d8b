// SPDX-License-Identifier: MIT
#include "fantail/live_output.hpp"

#include <cerrno>
#include <cstdio>

namespace fantail::tool {

bool shown(const std::string& text) {
  errno = 0;
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) == 0) {
    return true;
  }
  if (errno == EPIPE && std::freopen("/dev/null", "w", stdout) == nullptr) {
    errno = EIO;  // the end of the program will say that standard output was not taken
  }
  return false;
}

}  // namespace fantail::tool
