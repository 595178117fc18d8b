// SPDX-License-Identifier: MIT
#include "manual/roff.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>

#include <fmt/core.h>

namespace fantail::manual {
namespace {

/// The code point that begins here, and how many bytes it takes. The text is UTF-8.
std::uint32_t code_point(std::string_view text, std::size_t& bytes) {
  const auto first = static_cast<unsigned char>(text.front());
  bytes = first < 0xe0U ? 2 : (first < 0xf0U ? 3 : 4);
  std::uint32_t value = first & (0xffU >> (bytes + 1));
  for (const char c : text.substr(1, bytes - 1)) {
    value = (value << 6U) | (static_cast<unsigned char>(c) & 0x3fU);
  }
  return value;
}

/// A line that begins with one of these would be an instruction.
std::string safe_line(const std::string& line) {
  return line.starts_with('.') || line.starts_with('\'') ? "\\&" + line : line;
}

}  // namespace

std::string roff(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    std::size_t bytes = 1;
    if (text.front() == '\\') {
      result += "\\e";
    } else if (text.front() == '-') {  // a bare one is a hyphen, which no shell takes
      result += "\\-";
    } else if (static_cast<unsigned char>(text.front()) < 0x80U) {
      result += text.front();
    } else {
      result += fmt::format("\\[u{:04X}]", code_point(text, bytes));
    }
    text.remove_prefix(std::min(bytes, text.size()));
  }
  return result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }

std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string sentence(std::string_view text) {
  std::string result;
  for (bool is_code = false;; is_code = !is_code) {
    const std::size_t tick = text.find('`');
    const std::string_view piece = text.substr(0, tick);
    result += is_code ? bold(piece) : roff(piece);
    if (tick == std::string_view::npos) {
      return result;
    }
    text.remove_prefix(tick + 1);
  }
}

std::string beginning(const Title& title, std::string_view meaning) {
  std::string capitals = title.name;
  std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return std::toupper(c); });
  // Names of options and keys are not to be divided, nor spaces widened.
  return fmt::format(".TH \"{}\" {} {} \"Fantail {}\" \"Fantail manual\"\n.nh\n.ad l\n", roff(capitals), title.section,
                     title.date, title.version) +
         heading("NAME") + fmt::format("{} \\- {}\n", roff(title.name), sentence(meaning));
}

std::string heading(std::string_view text) { return fmt::format(".SH {}\n", roff(text)); }

std::string subheading(std::string_view text) { return fmt::format(".SS {}\n", roff(text)); }

std::string paragraph(const std::string& text) { return fmt::format(".PP\n{}\n", safe_line(text)); }

std::string item(const std::string& tag, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", safe_line(tag), text.empty() ? "\\&" : safe_line(text));
}

std::string verbatim(std::string_view lines) {
  std::string result = ".PP\n.RS 4\n.nf\n";
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    result += safe_line(roff(lines.substr(0, end))) + "\n";
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return result + ".fi\n.RE\n";
}

std::string tidied(std::string_view page) {
  std::string result;
  bool after_heading = false;
  while (!page.empty()) {
    const std::size_t end = std::min(page.find('\n'), page.size());
    const std::string_view line = page.substr(0, end);
    if (!after_heading || line != ".PP") {
      result.append(line) += '\n';
    }
    after_heading = line.starts_with(".SH ") || line.starts_with(".SS ");
    page.remove_prefix(std::min(end + 1, page.size()));
  }
  return result;
}

}  // namespace fantail::manual
