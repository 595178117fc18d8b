// SPDX-License-Identifier: MIT
#include "fantail/terminal.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <sys/ioctl.h>
#include <unistd.h>

#include "fantail/standard_streams.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

constexpr std::size_t usual_columns = 80;
constexpr std::size_t usual_rows = 24;
// A longer line is hard to read, a shorter one holds no option with its meaning.
constexpr std::size_t most_columns = 120;
constexpr std::size_t least_columns = 20;

// In the order of Color, and then none.
constexpr std::array<std::string_view, 5> color_codes{"\033[32m", "\033[31m", "\033[33m", "\033[36m", "\033[0m"};

ColorWish color_wish = ColorWish::automatic;

winsize size_of(int stream) {
  winsize size{};
  ::ioctl(stream, TIOCGWINSZ, &size);  // where it fails, all stays zero: not known
  return size;
}

bool is_dumb(const char* term) { return term == nullptr || *term == '\0' || std::string_view{term} == "dumb"; }

bool has_color() {
  static const bool is_terminal = ::isatty(STDOUT_FILENO) == 1;
  return may_have_color(color_wish, is_terminal, std::getenv("NO_COLOR"), std::getenv("TERM"));
}

}  // namespace

bool may_have_color(ColorWish wish, bool is_terminal, const char* no_color, const char* term) {
  if (wish != ColorWish::automatic) {
    return wish == ColorWish::always;
  }
  return is_terminal && (no_color == nullptr || *no_color == '\0') && !is_dumb(term);
}

std::size_t readable_columns(std::size_t told) {
  return told == 0 ? usual_columns : std::clamp(told, least_columns, most_columns);
}

std::size_t columns_of(int stream) {
  if (::isatty(stream) != 1) {
    return text::any_width;
  }
  const std::size_t told = size_of(stream).ws_col;
  const char* const stated = std::getenv("COLUMNS");  // for a serial line, which does not know
  return readable_columns(told != 0 || stated == nullptr ? told : text::whole_number(stated).value_or(0));
}

bool output_is_screen() { return ::isatty(STDOUT_FILENO) == 1 && !is_dumb(std::getenv("TERM")); }

std::size_t output_columns() { return columns_of(STDOUT_FILENO); }

std::size_t output_rows() {
  const std::size_t told = size_of(STDOUT_FILENO).ws_row;
  return told == 0 ? usual_rows : told;
}

void set_color(std::string_view wish) {
  color_wish = wish == "always" ? ColorWish::always : (wish == "never" ? ColorWish::never : ColorWish::automatic);
}

std::string painted(Color color, std::string_view text) {
  if (text.empty() || !has_color()) {
    return std::string{text};
  }
  return fmt::format("{}{}{}", color_codes[static_cast<std::size_t>(color)], text, color_codes.back());
}

std::string without_controls(std::string_view text, bool with_colors) {
  std::string result;
  while (!text.empty()) {
    const bool is_color =
        with_colors && std::ranges::any_of(color_codes, [&](const auto code) { return text.starts_with(code); });
    const std::size_t kept = is_color ? text.find('m') + 1 : text[0] == '\n' ? 1 : text::printable_character(text);
    result += kept == 0 ? std::string_view{"?"} : text.substr(0, kept);
    text.remove_prefix(std::max<std::size_t>(kept, 1));
  }
  return result;
}

void show_text(std::string_view all) {
  const std::string text = without_controls(all, has_color());
  const std::size_t columns = output_columns();
  say_for_now("");  // it may stand on the same terminal
  fmt::print("{}", columns == text::any_width ? text : text::wrapped(text, columns));
}

}  // namespace fantail::tool
