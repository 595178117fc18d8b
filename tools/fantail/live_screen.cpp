// SPDX-License-Identifier: MIT
#include "fantail/live_screen.hpp"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "text/wrapped.hpp"

namespace fantail::tool {

std::string live_frame(const std::string& text, std::size_t columns, std::size_t rows) {
  std::vector<std::string> lines;
  const std::string fitting = text::wrapped(text, columns);
  for (std::size_t begin = 0; begin < fitting.size();) {
    const std::size_t end = std::min(fitting.find('\n', begin), fitting.size());
    lines.push_back(fitting.substr(begin, end - begin));
    begin = end + 1;
  }
  if (lines.size() > rows) {
    const std::size_t hidden = lines.size() - rows + 1;
    lines.resize(rows - 1);
    lines.push_back(fmt::format("({} more lines: the terminal is too low)", hidden));
  }
  // Without a cursor meanwhile, and without lines that the terminal breaks: a word that is too wide would move those
  // below.
  std::string frame = "\033[?2026h\033[?25l\033[?7l\033[H";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    frame += (i == 0 ? "" : "\r\n") + lines[i] + "\033[K";
  }
  return frame + "\033[J\033[?7h\033[?25h\033[?2026l";
}

LiveScreen::LiveScreen() { fmt::print("\033[?1049h"); }

LiveScreen::~LiveScreen() {
  if (!show_live("\033[?1049l" + text::wrapped(last_, output_columns()))) {
    return;  // the end of the program says what standard output did not take
  }
}

bool LiveScreen::draw(const std::string& text) {
  last_ = text;
  return show_live(live_frame(text, output_columns(), output_rows()));
}

}  // namespace fantail::tool
