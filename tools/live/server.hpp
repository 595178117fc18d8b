// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace fantail::live {

/// Where a page is served. By default only this computer reaches it.
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

/// Does this Host header belong to a request for this address? A web site whose own name leads to this computer
/// would read the page otherwise (DNS rebinding), and no browser would stop it. `own_name` is what the computer is
/// called.
[[nodiscard]] bool may_ask(const Address& address, std::string_view host_header, std::string_view own_name);

/// The fate of the frames, over all viewers so far.
struct ServerFigures {
  std::size_t viewers = 0;           ///< now
  std::size_t most_viewers = 0;      ///< at the same time
  std::uint64_t frames_sent = 0;     ///< to one viewer each
  std::uint64_t frames_dropped = 0;  ///< because a viewer did not take them in time
  std::uint64_t bytes_sent = 0;
  std::uint64_t refused = 0;  ///< viewers and other connections that were too many
};

struct Page {
  std::string html{};
  /// What tells a browser whose page this is, in one line: another program may be served where it had its page from.
  std::string about{};
};

/// Serves one page, and to each browser that shows it the same frames as server-sent events. Read-only: GET / and GET
/// /events are answered, and everything else is refused. Whoever calls show() never waits for a viewer.
class Server {
 public:
  static constexpr std::size_t most_viewers = 32;
  /// Of a viewer that takes nothing, for about a second of frames; then the oldest is dropped.
  static constexpr std::size_t most_waiting = 40;

  /// `greeting` makes what a viewer is sent first; it is called in the server's threads. Throws std::runtime_error when
  /// the address cannot be listened at.
  Server(const Address& address, Page page, std::function<std::string()> greeting);
  /// Ends every connection.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// With the port that was found.
  [[nodiscard]] const Address& address() const;
  /// One frame, without a line break, to each viewer.
  void show(const std::string& frame);
  [[nodiscard]] ServerFigures figures() const;

 private:
  struct Http;
  std::unique_ptr<Http> http_;
};

}  // namespace fantail::live
