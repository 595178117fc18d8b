// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::live {

/// Where a page is served. Without a word from the user nobody but this computer reaches it.
struct Address {
  std::string host = "127.0.0.1";  ///< a number or a name; without the brackets of IPv6
  int port = 8080;                 ///< 1 to 65535; 0: one that is free

  [[nodiscard]] bool is_of_this_computer_alone() const;
  /// "http://[::1]:8080/", of a wildcard that of this computer.
  [[nodiscard]] std::string url() const;
};

/// "127.0.0.1:8080", "[::1]:8080", "rocket-pc:9000"; empty when `text` is one of these.
[[nodiscard]] std::string objection_to_address(const std::string& text);
/// Of a text without objection.
[[nodiscard]] Address address_of(const std::string& text);

/// Is this Host header that of somebody who asked for this address? A web site whose own name leads to this computer
/// would read the page otherwise (DNS rebinding), and no browser would stop it. `own_name` is what the computer is
/// called.
[[nodiscard]] bool may_ask(const Address& address, std::string_view host_header, std::string_view own_name);

}  // namespace fantail::live
