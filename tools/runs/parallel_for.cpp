// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "runs/runner.hpp"

namespace fantail::runs {
namespace {

struct Pool {
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::condition_variable changed;
  unsigned busy = 0;             ///< under the mutex, as the next
  std::exception_ptr trouble{};  ///< the first
};

void work_on(Pool& pool, std::size_t count, const std::function<void(std::size_t)>& work) {
  try {
    for (std::size_t i = pool.next++; i < count && !pool.stop; i = pool.next++) {
      work(i);
      ++pool.done;
    }
  } catch (...) {
    const std::lock_guard lock{pool.mutex};
    pool.trouble = pool.trouble ? pool.trouble : std::current_exception();
    pool.stop = true;
  }
  const std::lock_guard lock{pool.mutex};
  --pool.busy;
  pool.changed.notify_one();
}

/// Leaves nobody working for a caller who has gone.
struct StopAtEnd {
  Pool& pool;
  ~StopAtEnd() { pool.stop = true; }
};

}  // namespace

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& look) {
  const std::size_t at_once = std::max(1U, std::thread::hardware_concurrency());
  // More would not be faster: each would only take longer for its piece, and to come to an end.
  const std::size_t wanted = std::min<std::size_t>(threads > 0 ? threads : at_once, 4 * at_once);
  Pool pool;
  std::vector<std::jthread> threads_at_work;
  const StopAtEnd stop_at_end{pool};
  for (std::size_t i = 0; i < std::min(wanted, count); ++i) {
    {
      const std::lock_guard lock{pool.mutex};
      ++pool.busy;
    }
    threads_at_work.emplace_back([&pool, count, &work] { work_on(pool, count, work); });
  }
  for (bool over = false; !over;) {
    {
      std::unique_lock lock{pool.mutex};
      over = pool.changed.wait_for(lock, std::chrono::milliseconds{100}, [&pool] { return pool.busy == 0; });
    }
    look(pool.done);
  }
  if (pool.trouble) {
    std::rethrow_exception(pool.trouble);
  }
}

}  // namespace fantail::runs
