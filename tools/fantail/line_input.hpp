// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace fantail::tool {

/// Lines from standard input, taken without ever waiting for them, so that a bus can be served meanwhile.
class LineInput {
 public:
  /// Without its end and without spaces around it; empty when no whole line is there yet.
  [[nodiscard]] std::optional<std::string> next();

  /// No more will come.
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  void read_what_is_there();

  std::string text_;
  bool ended_ = false;
};

}  // namespace fantail::tool
