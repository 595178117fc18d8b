// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <thread>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include "live/server.hpp"
#include "test.hpp"

namespace fantail::live {

/// A browser of the plainest kind.
class Browser {
 public:
  explicit Browser(int port) : socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
    const sockaddr_in place{.sin_family = AF_INET,
                            .sin_port = htons(static_cast<std::uint16_t>(port)),
                            .sin_addr = {htonl(INADDR_LOOPBACK)},
                            .sin_zero = {}};
    const timeval patience{.tv_sec = 10, .tv_usec = 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    // So that a viewer that takes nothing is full soon.
    constexpr int small = 4096;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place),
              0);  // NOLINT: the call's own way
  }
  Browser(Browser&& other) noexcept : socket_{std::exchange(other.socket_, -1)}, read_{std::move(other.read_)} {}
  ~Browser() {
    if (socket_ >= 0) {
      ::close(socket_);
    }
  }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// False: the other side has closed the connection.
  bool ask(const std::string& text) const {  // NOLINT(modernize-use-nodiscard)
    return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
  }
  void get(const std::string& path, const std::string& host) const {
    ask("GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
  }

  /// All up to and with `end`, or what came before the connection was closed or patience ended.
  std::string read_to(const std::string& end) {
    for (;;) {
      if (const std::size_t at = read_.find(end); at != std::string::npos) {
        std::string text = read_.substr(0, at + end.size());
        read_.erase(0, text.size());
        return text;
      }
      std::array<char, 4096> piece{};
      const ssize_t size = ::recv(socket_, piece.data(), piece.size(), 0);
      if (size <= 0) {
        return std::exchange(read_, {});
      }
      read_.append(piece.data(), static_cast<std::size_t>(size));
    }
  }

 private:
  int socket_;
  std::string read_;
};

struct Served {
  explicit Served(std::string greeting = "hello")
      : server{{.port = 0},
               {.html = "<p>the page</p>", .about = "whose"},
               [greeting = std::move(greeting)] { return greeting; }},
        port{server.address().port},
        host{"127.0.0.1:" + std::to_string(port)} {}

  [[nodiscard]] Browser open(const std::string& path) const {
    Browser browser{port};
    browser.get(path, host);
    return browser;
  }
  [[nodiscard]] std::string status(const std::string& request) const {
    Browser browser{port};
    browser.ask(request);
    return browser.read_to("\r\n");
  }
  [[nodiscard]] std::string status_of(const std::string& method, const std::string& path,
                                      const std::string& asked) const {
    return status(method + " " + path + " HTTP/1.1\r\nHost: " + asked + "\r\nContent-Length: 0\r\n\r\n");
  }
  void wait_for_viewers(std::size_t count) const {
    for (int i = 0; i < 1000 && server.figures().viewers != count; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    EXPECT_EQ(server.figures().viewers, count);
  }

  Server server;
  int port;
  std::string host;
};

}  // namespace fantail::live
