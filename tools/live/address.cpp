// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

#include <arpa/inet.h>
#include <fmt/core.h>

#include "live/server.hpp"

namespace fantail::live {
namespace {

constexpr int highest_port = 65'535;

bool is_ip(const std::string& host) {
  std::array<unsigned char, 16> bytes{};
  return ::inet_pton(AF_INET, host.c_str(), bytes.data()) == 1 ||
         ::inet_pton(AF_INET6, host.c_str(), bytes.data()) == 1;
}

bool is_wildcard(const std::string& host) { return host == "0.0.0.0" || host == "::"; }

bool is_name(std::string_view host) {
  return !host.empty() && host.size() <= 253 && host.front() != '-' && host.front() != '.' &&
         std::ranges::all_of(
             host, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.'; });
}

std::optional<int> port_in(std::string_view text) {
  int port = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  const bool is_number = error == std::errc{} && end == text.data() + text.size() && text.front() != '-';
  return is_number && port <= highest_port ? std::optional{port} : std::nullopt;
}

struct Parts {
  std::string host;
  std::string port;
};

std::optional<Parts> split(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) {
    return std::nullopt;
  }
  std::string_view host = text.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
    if (host.find(':') == std::string_view::npos) {
      return std::nullopt;
    }
  } else if (host.find(':') != std::string_view::npos) {
    return std::nullopt;
  }
  return Parts{std::string{host}, std::string{text.substr(colon + 1)}};
}

std::string lower(std::string_view text) {
  std::string result{text};
  std::ranges::transform(result, result.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return result;
}

bool is_loopback(std::string_view host) { return host == "localhost" || host == "127.0.0.1" || host == "::1"; }

}  // namespace

bool Address::is_of_this_computer_alone() const { return is_loopback(host) || host.starts_with("127."); }

std::string Address::url() const {
  const std::string shown = is_wildcard(host)                     ? "localhost"
                            : host.find(':') == std::string::npos ? host
                                                                  : "[" + host + "]";
  return fmt::format("http://{}:{}/", shown, port);
}

std::string objection_to_address(const std::string& text) {
  const auto parts = split(text);
  if (!parts || !(is_ip(parts->host) || is_name(parts->host)) || parts->port.empty() || !port_in(parts->port)) {
    return "\"" + text +
           "\" is not an address; allowed: HOST:PORT, for example 127.0.0.1:8080, [::1]:8080 or 0.0.0.0:8080, port 0 "
           "to "
           "65535";
  }
  return {};
}

Address address_of(const std::string& text) {
  const Parts parts = *split(text);
  return {.host = parts.host, .port = *port_in(parts.port)};
}

bool may_ask(const Address& address, std::string_view host_header, std::string_view own_name) {
  const std::string header = lower(host_header);
  // Without a port it is that of HTTP.
  const bool has_port = header.find(':') != std::string::npos && !header.ends_with(']');
  const auto parts = split(has_port ? header : header + ":80");
  if (!parts || parts->port.empty() || port_in(parts->port) != address.port) {
    return false;
  }
  const std::string& host = parts->host;
  if (host == lower(address.host) || (address.is_of_this_computer_alone() && is_loopback(host))) {
    return true;
  }
  // Of a name only this computer's own: a number leads nobody to another place than it says.
  const std::string own = lower(own_name);
  return is_wildcard(address.host) &&
         (is_ip(host) || host == "localhost" || (!own.empty() && (host == own || host == own + ".local")));
}

}  // namespace fantail::live
