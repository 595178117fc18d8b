// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>

#include <httplib.h>

namespace fantail::live {

/// The library's server with a bound on what a stranger can take: so many connections, each for one request of at most
/// 32 kB, which has to come within five seconds. The library bounds each single read alone: a byte now and then holds a
/// thread for hours, header lines fill the memory, connections wait without end, and each of thousands of ranges asked
/// for becomes a copy of the page.
class HttpServer final : public httplib::Server {
 public:
  /// More connections than that are closed as they come.
  explicit HttpServer(std::size_t most_connections);

  /// Once it is bound: the library lets five wait to be accepted, and whoever comes behind them waits for seconds.
  void let_many_wait() { ::listen(svr_sock_, SOMAXCONN); }
  /// Ends every connection and stops listening. From any thread.
  void end();
  /// Connections that were closed because there were too many.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  bool process_and_close_socket(socket_t socket) override;
  [[nodiscard]] bool enter(socket_t socket);
  void leave(socket_t socket);

  std::atomic<std::uint64_t> refused_ = 0;
  std::mutex mutex_;
  std::set<socket_t> connections_;
  bool ending_ = false;
};

}  // namespace fantail::live
