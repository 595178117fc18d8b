// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace fantail::live {

/// One browser's frames, put by one thread and taken by another.
class Viewer {
 public:
  using Frame = std::shared_ptr<const std::string>;
  explicit Viewer(std::size_t most_waiting) : most_waiting_{most_waiting} {}

  /// True: an older one had to go.
  bool put(const Frame& frame) {
    const std::scoped_lock lock{mutex_};
    const bool full = waiting_.size() >= most_waiting_;
    if (full) {
      waiting_.pop_front();
    }
    waiting_.push_back(frame);
    news_.notify_one();
    return full;
  }
  /// Before all that waits.
  void put_first(const Frame& frame) {
    const std::scoped_lock lock{mutex_};
    waiting_.push_front(frame);
    news_.notify_one();
  }
  /// Null: nothing has come for a while.
  Frame take() {
    std::unique_lock lock{mutex_};
    constexpr std::chrono::seconds longest_silence{1};
    news_.wait_for(lock, longest_silence, [this] { return !waiting_.empty() || ended_; });
    if (waiting_.empty()) {
      return nullptr;
    }
    Frame frame = std::move(waiting_.front());
    waiting_.pop_front();
    return frame;
  }
  void end() {
    const std::scoped_lock lock{mutex_};
    ended_ = true;
    news_.notify_one();
  }
  [[nodiscard]] bool has_ended() const {
    const std::scoped_lock lock{mutex_};
    return ended_;
  }

 private:
  std::size_t most_waiting_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::deque<Frame> waiting_;
  bool ended_ = false;
};

}  // namespace fantail::live
