// SPDX-License-Identifier: MIT
#include "telemetry/url.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fantail::telemetry {
namespace {

constexpr std::string_view network_scheme = "udpm://";
constexpr std::string_view file_scheme = "file://";
constexpr const char* allowed =
    "allowed: udpm://ADDRESS:PORT with a multicast address (224.0.0.0 to 239.255.255.255), or file:///PATH";

template <typename Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional{value} : std::nullopt;
}

bool is_multicast(const std::string& address) {
  in_addr parsed{};
  return inet_pton(AF_INET, address.c_str(), &parsed) == 1 && IN_MULTICAST(ntohl(parsed.s_addr));
}

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument{what + "; " + allowed}; }

}  // namespace

Url::Url(std::string text) : text_{std::move(text)} {
  const std::size_t question = text_.find('?');
  const std::string place = text_.substr(0, question);
  if (place.starts_with(network_scheme)) {
    read_network(place.substr(network_scheme.size()));
  } else if (place.starts_with(file_scheme)) {
    path_ = place.substr(file_scheme.size());
    if (path_.empty()) {
      refuse('"' + text_ + "\" does not name a file");
    }
  } else {
    refuse('"' + text_ + "\" is not an LCM URL that Fantail can use");
  }
  if (question != std::string::npos) {
    read_options(text_.substr(question + 1));
  }
}

// "", "ADDRESS" or "ADDRESS:PORT": what is left out is what LCM's own tools take.
void Url::read_network(const std::string& place) {
  const std::size_t colon = place.find(':');
  if (!place.empty()) {
    address_ = place.substr(0, colon);
  }
  if (!is_multicast(address_)) {
    refuse('"' + address_ + "\" is not a multicast address");
  }
  if (colon != std::string::npos) {
    const auto port = number<std::uint16_t>(std::string_view{place}.substr(colon + 1));
    if (!port || *port == 0) {
      refuse('"' + place.substr(colon + 1) + "\" is not a port (1 to 65535)");
    }
    port_ = *port;
  }
}

// LCM only warns of an option that it does not know, and goes on without it.
void Url::read_options(const std::string& options) {
  for (std::size_t begin = 0; begin <= options.size();) {
    const std::size_t end = std::min(options.find('&', begin), options.size());
    const std::string option = options.substr(begin, end - begin);
    const std::size_t equals = std::min(option.find('='), option.size());
    const std::string_view value = std::string_view{option}.substr(std::min(equals + 1, option.size()));
    if (!read_option(std::string_view{option}.substr(0, equals), value)) {
      throw std::invalid_argument{'"' + option + "\" is not an option of \"" + text_ + "\"; allowed: " +
                                  (is_file() ? "speed=FACTOR (for reading; 0: as fast as possible)"
                                             : "ttl=HOPS (0 to 255, 0: this computer only), recv_buf_size=BYTES")};
    }
    begin = end + 1;
  }
}

bool Url::read_option(std::string_view key, std::string_view value) {
  if (is_file()) {
    const auto speed = number<double>(value);
    speed_ = speed.value_or(speed_);
    return key == "speed" && speed && *speed >= 0.0;
  }
  const auto whole = number<int>(value);
  if (key == "recv_buf_size") {
    receive_buffer_bytes_ = whole;
    return whole && *whole > 0 && *whole <= 1 << 30;
  }
  return key == "ttl" && whole && *whole >= 0 && *whole <= 255;  // the sender's
}

std::string objection_to_url(const std::string& text) {
  try {
    const Url url{text};
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

// A connection of UDP sends nothing; it only looks for the way.
void require_route(const Url& url) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(url.port());
  (void)inet_pton(AF_INET, url.address().c_str(), &address.sin_addr);
  const int probe = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool open = probe >= 0 && ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  const int error = errno;
  if (probe >= 0) {
    ::close(probe);
  }
  if (!open && (error == ENETUNREACH || error == EHOSTUNREACH)) {
    throw TelemetryError{url.text() +
                         ": multicast has no route on this computer. Connect it to a network; or keep the messages on "
                         "this computer: sudo ip link set lo up; sudo ip route add 224.0.0.0/4 dev lo"};
  }
  if (!open) {
    throw TelemetryError{url.text() + ": " + std::strerror(error)};
  }
}

}  // namespace fantail::telemetry
