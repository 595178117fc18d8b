// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace fantail::tool {

/// Whether standard output may have colours; --color of every verb.
enum class ColorWish { automatic, always, never };

enum class Color { green, red, yellow, cyan };

/// What is asked for on the command line counts more than the surroundings (https://no-color.org). The two texts are
/// those of the environment, null where it has none.
[[nodiscard]] bool may_have_color(ColorWish wish, bool is_terminal, const char* no_color, const char* term);

/// How wide text may be in a terminal that says it has so many columns, and 0 when it does not know.
[[nodiscard]] std::size_t readable_columns(std::size_t told);

/// As the terminal says, else COLUMNS. text::any_width when the stream is no terminal: there everything stays as it is.
[[nodiscard]] std::size_t columns_of(int stream);

/// Whether pictures can be drawn over one another on standard output.
[[nodiscard]] bool output_is_screen();
[[nodiscard]] std::size_t output_columns();
/// Rows of that terminal.
[[nodiscard]] std::size_t output_rows();

/// "auto", "always", "never": that of the command line.
void set_color(std::string_view wish);

/// The text in a colour where standard output may have colours, else as it is. For words that say the same without.
[[nodiscard]] std::string painted(Color color, std::string_view text);
/// Lines as they may go to a terminal: a control character becomes a question mark, if it is of no colour that
/// painted() gave.
[[nodiscard]] std::string without_controls(std::string_view text, bool with_colors = false);

/// Prints what a person reads to standard output, whole lines: wrapped where that is a terminal. What a program reads
/// is not for it.
void show_text(std::string_view text);

template <typename... Values>
void show(fmt::format_string<Values...> text, Values&&... values) {
  show_text(fmt::format(text, std::forward<Values>(values)...));
}

// Colours repeat what words say; nothing is said by a colour alone.

/// "PASS", "FAIL" and "Outside the model", where a line begins with them.
[[nodiscard]] std::string painted_decision(std::string text);

/// The word behind "phase" where a line begins with that: green while the rocket is safe, yellow while it is armed,
/// cyan in flight.
[[nodiscard]] std::string painted_phase(std::string text);

}  // namespace fantail::tool
