// SPDX-License-Identifier: MIT
#include <array>
#include <string_view>

#include <poll.h>
#include <unistd.h>

#include "fantail/standard_streams.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

// Nobody types a longer one; what keeps coming without an end of line is not typed.
constexpr std::size_t longest_line = 1000;

}  // namespace

std::optional<std::string> LineInput::next() {
  read_what_is_there();
  const std::size_t end = text_.find('\n');
  if (end == std::string::npos) {
    return std::nullopt;
  }
  std::string line{text::trimmed(std::string_view{text_}.substr(0, end))};
  text_.erase(0, end + 1);
  return line;
}

void LineInput::read_what_is_there() {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (ended_ || ::poll(&input, 1, 0) != 1) {
    return;
  }
  std::array<char, 256> buffer{};
  const auto size = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  if (size <= 0) {
    ended_ = true;
    return;
  }
  text_.append(buffer.data(), static_cast<std::size_t>(size));
  if (text_.size() > longest_line && text_.find('\n') == std::string::npos) {
    text_.clear();
  }
}

}  // namespace fantail::tool
