// SPDX-License-Identifier: MIT
#include "flight/messages.hpp"

#include <algorithm>
#include <vector>

#include "input/messages.hpp"

namespace fantail::flight {
namespace {

constexpr std::size_t longest_piece = 48;
constexpr std::size_t most_names = 40;

std::string harmless(std::string_view text) {
  std::string shown{text.substr(0, longest_piece)};
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      c = '?';
    }
  }
  return text.size() > longest_piece ? shown + "..." : shown;
}

}  // namespace

std::string in_quotes(std::string_view text) { return '"' + harmless(text) + '"'; }

std::string missing_column(std::string_view wanted, std::span<const std::string> there) {
  std::vector<std::string> names;
  for (const std::string& name : there.first(std::min(there.size(), most_names))) {
    names.push_back(harmless(name));
  }
  std::string message = "no column " + std::string{wanted};
  if (const auto meant = input::suggestion(wanted, names)) {
    message += " (did you mean " + *meant + "?)";
  }
  message += "; there are: ";
  for (const std::string& name : names) {
    message += name + ", ";
  }
  return there.size() > most_names ? message + "..." : message.substr(0, message.size() - 2);
}

}  // namespace fantail::flight
