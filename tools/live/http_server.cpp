// SPDX-License-Identifier: MIT
#include "live/http_server.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include <poll.h>

namespace fantail::live {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::chrono::seconds request_timeout{5};
// The library takes lines and bytes without a limit. A browser sends a tenth of it.
constexpr std::size_t longest_request = 32U << 10U;
constexpr std::chrono::seconds write_timeout{3};

bool is_ready(socket_t socket, short events, milliseconds at_most) {
  pollfd one{.fd = socket, .events = events, .revents = 0};
  return ::poll(&one, 1, static_cast<int>(std::max(at_most, milliseconds{0}).count())) > 0;
}

class Connection final : public httplib::Stream {
 public:
  explicit Connection(socket_t socket) : socket_{socket} {}

  // Nor is one that always has something when its time is over.
  [[nodiscard]] bool is_readable() const override {
    return left() > milliseconds{0} && is_ready(socket_, POLLIN, left());
  }
  [[nodiscard]] bool is_writable() const override { return is_ready(socket_, POLLOUT, write_timeout); }
  ssize_t read(char* to, std::size_t size) override {
    const std::size_t most = std::min(size, longest_request - taken_);
    const ssize_t count = most > 0 && is_readable() ? ::recv(socket_, to, most, MSG_DONTWAIT) : -1;
    taken_ += count > 0 ? static_cast<std::size_t>(count) : 0;
    return count;
  }
  ssize_t write(const char* from, std::size_t size) override {
    return is_writable() ? ::send(socket_, from, size, MSG_DONTWAIT | MSG_NOSIGNAL) : -1;
  }
  // Nobody asks here who the other side is.
  void get_remote_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  void get_local_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  [[nodiscard]] socket_t socket() const override { return socket_; }

 private:
  [[nodiscard]] milliseconds left() const {
    return std::chrono::duration_cast<milliseconds>(begin_ + request_timeout - Clock::now());
  }

  socket_t socket_;
  std::size_t taken_ = 0;
  Clock::time_point begin_ = Clock::now();
};

// What the library of Debian 12 does not say, and that of Debian 13 does: whether there was room.
using Enqueued = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));

// Of the thread that accepts connections.
thread_local bool is_one_too_many = false;

/// A thread for each connection, so none waits for one.
class Threads final : public httplib::TaskQueue {
 public:
  explicit Threads(std::size_t count) : count_{count}, pool_{count} {}

  Enqueued enqueue(std::function<void()> task) override {
    if (busy_ >= count_) {
      is_one_too_many = true;
      task();
      is_one_too_many = false;
      return static_cast<Enqueued>(true);
    }
    busy_ += 1;
    return pool_.enqueue([this, task = std::move(task)] {
      task();
      busy_ -= 1;
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  std::size_t count_;
  std::atomic<std::size_t> busy_ = 0;
  httplib::ThreadPool pool_;
};

}  // namespace

HttpServer::HttpServer(std::size_t most_connections) {
  new_task_queue = [most_connections] { return new Threads{most_connections}; };  // NOLINT: the library deletes it
}

bool HttpServer::process_and_close_socket(socket_t socket) {
  bool is_answered = false;
  if (is_one_too_many) {
    refused_ += 1;
  } else if (enter(socket)) {
    Connection connection{socket};
    bool is_closed = false;
    const auto without_ranges = [](httplib::Request& request) { request.ranges.clear(); };
    is_answered = [&](auto& server) {
      if constexpr (requires { server.process_request(connection, true, is_closed, without_ranges); }) {
        return server.process_request(connection, true, is_closed, without_ranges);
      } else {  // that of Debian 13 wants to know who the two sides are
        return server.process_request(connection, "", 0, "", 0, true, is_closed, without_ranges);
      }
    }(*this);
    leave(socket);
  }
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return is_answered;
}

bool HttpServer::enter(socket_t socket) {
  const std::scoped_lock lock{mutex_};
  return !ending_ && connections_.insert(socket).second;
}

void HttpServer::leave(socket_t socket) {
  const std::scoped_lock lock{mutex_};
  connections_.erase(socket);
}

void HttpServer::end() {
  {
    const std::scoped_lock lock{mutex_};
    ending_ = true;
    for (const socket_t socket : connections_) {
      ::shutdown(socket, SHUT_RDWR);
    }
  }
  stop();
}

}  // namespace fantail::live
