// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fantail::telemetry {

/// The network or the log file did not accept or deliver messages. what() tells what to do about it.
class TelemetryError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where messages go or come from: "udpm://239.255.76.67:7667?ttl=0", or a log file, "file:///tmp/flight.lcmlog".
class Url {
 public:
  /// Throws std::invalid_argument with what is wrong, and what is allowed.
  explicit Url(std::string text);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool is_file() const { return !path_.empty(); }
  [[nodiscard]] const std::string& path() const { return path_; }        ///< of a file, without options
  [[nodiscard]] const std::string& address() const { return address_; }  ///< of a network
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] double speed() const { return speed_; }  ///< of a file; 0: as fast as possible
  [[nodiscard]] const std::optional<int>& receive_buffer_bytes() const { return receive_buffer_bytes_; }

 private:
  void read_network(const std::string& place);
  void read_options(const std::string& options);
  [[nodiscard]] bool read_option(std::string_view key, std::string_view value);

  std::string text_;
  std::string path_;
  std::string address_ = "239.255.76.67";
  std::uint16_t port_ = 7667;
  double speed_ = 1.0;
  std::optional<int> receive_buffer_bytes_{};
};

/// Empty when the text is a URL: for the command line.
[[nodiscard]] std::string objection_to_url(const std::string& text);

/// Throws TelemetryError, with the command that corrects it, if multicast packets have no route out of this computer.
void require_route(const Url& url);

}  // namespace fantail::telemetry
