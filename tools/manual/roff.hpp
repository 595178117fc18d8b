// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

// Pieces of a manual page, as man(7) has them. Texts are UTF-8; what stands between `backticks` is bold.
namespace fantail::manual {

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

}  // namespace fantail::manual
