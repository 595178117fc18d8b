// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "live/server.hpp"

namespace fantail::live {

/// A page for browsers: served, and brought up to date 40 times a second, by threads of its own.
class Broadcast {
 public:
  /// `frame` is called 40 times a second and makes what every viewer is sent; `greeting` what a new one is sent first.
  /// Both for threads of this. Throws std::runtime_error when the address cannot be listened at.
  Broadcast(const Address& address, Page page, std::function<std::string()> frame,
            const std::function<std::string()>& greeting);
  ~Broadcast();
  Broadcast(const Broadcast&) = delete;
  Broadcast& operator=(const Broadcast&) = delete;

  /// What there is so far is shown, also when the program ends behind it.
  void finish();

  [[nodiscard]] const Address& address() const { return server_.address(); }
  [[nodiscard]] ServerFigures figures() const { return server_.figures(); }

 private:
  void show_next();
  void work();

  std::mutex mutex_;  ///< of the order of frames
  std::function<std::string()> frame_;
  Server server_;
  std::atomic<bool> end_ = false;
  std::thread thread_;
};

}  // namespace fantail::live
