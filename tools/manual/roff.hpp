// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "manual/command.hpp"

namespace fantail::manual {

struct Example {
  std::string command;
  std::string meaning;  ///< may be empty
};

/// What the help of a command has below its options, taken apart.
struct Notes {
  std::vector<std::string> sentences{};
  std::vector<std::string> exits{};  ///< "Exit code 0: go; 1: no go."
  std::vector<Example> examples{};
};

/// Lines that begin with two spaces are commands, with their meaning behind two spaces or more, or on the next line
/// far to the right; those with a few spaces more go on with a command. Other lines are sentences.
[[nodiscard]] Notes notes_of(std::string_view text);

// Pieces of a manual page, as man(7) has them. Texts are UTF-8; what stands between `backticks` is bold.

/// The text as it is, whatever is in it.
[[nodiscard]] std::string roff(std::string_view text);
[[nodiscard]] std::string bold(std::string_view text);
[[nodiscard]] std::string italic(std::string_view text);
/// With its backticks made bold.
[[nodiscard]] std::string sentence(std::string_view text);

/// What a page is called and when it was made.
struct Title {
  std::string name;  ///< "fantail-fly"
  int section;       ///< of the manual
  std::string date;  ///< 2026-11-22
  std::string version;
};

/// `meaning` is the line that whatis(1) shows.
[[nodiscard]] std::string beginning(const Title& title, std::string_view meaning);
[[nodiscard]] std::string heading(std::string_view text);
[[nodiscard]] std::string subheading(std::string_view text);

// These take roff, as the functions above give it.
[[nodiscard]] std::string paragraph(const std::string& text);
[[nodiscard]] std::string item(const std::string& tag, const std::string& text);

/// Lines as they are, indented.
[[nodiscard]] std::string verbatim(std::string_view lines);

/// Without the breaks between a heading and what follows it.
[[nodiscard]] std::string tidied(std::string_view page);

/// What stands between each "<!-- manual -->" and the "<!-- end of manual -->" that follows it. Throws
/// std::runtime_error when there is none.
[[nodiscard]] std::string passages_for_manual(std::string_view page);

/// Headings, paragraphs, lists, tables and code of our Markdown as roff. A row of a table is an item: its first cell is
/// the tag, its last cell the text, and those between stand behind the tag. Of a link only the words are left.
[[nodiscard]] std::string roff_of_markdown(std::string_view text);

/// The manual page of a command, its own commands included, up to SEE ALSO.
[[nodiscard]] std::string command_page(const Command& command, const Title& title, std::span<const ExitCode> codes);

/// "fantail(1)"
[[nodiscard]] std::string see_also(std::initializer_list<const char*> pages);

}  // namespace fantail::manual
