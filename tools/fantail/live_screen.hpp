// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace fantail::tool {

/// One picture of a live table, as a single write that draws over the one before: from the upper left, each line to its
/// end, and nothing is cleared that is not drawn again, so nothing flickers. Terminals that know how show it at once.
/// Lines that the terminal has no room for are left out, and it says how many.
[[nodiscard]] std::string live_frame(const std::string& text, std::size_t columns, std::size_t rows);

/// The alternate screen of a terminal, as editors have it: what stood there before comes back, and with it the last
/// picture.
class LiveScreen {
 public:
  LiveScreen();
  ~LiveScreen();
  LiveScreen(const LiveScreen&) = delete;
  LiveScreen& operator=(const LiveScreen&) = delete;

  /// False: there is no use in going on.
  [[nodiscard]] bool draw(const std::string& text);

 private:
  std::string last_;
};

}  // namespace fantail::tool
