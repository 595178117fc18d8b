// SPDX-License-Identifier: MIT
#include "runs/runner.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include <fmt/core.h>

#include "sim/random.hpp"

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

/// The parts that are taken without a gap before them, and how many of all are enough.
class InOrder {
 public:
  explicit InOrder(const Flights& flights) : flights_{flights}, taken_(flights.parts.size(), false) {}

  [[nodiscard]] std::size_t end() const { return end_; }

  void took(std::size_t part) {
    if (!flights_.is_enough) {
      return;
    }
    const std::lock_guard lock{mutex_};
    taken_[part] = true;
    for (; next_ < end_ && taken_[next_]; ++next_) {
      if (flights_.is_enough(next_)) {
        end_ = next_ + 1;
      }
    }
  }

 private:
  const Flights& flights_;
  std::mutex mutex_;
  std::vector<bool> taken_;
  std::size_t next_ = 0;
  std::atomic<std::size_t> end_{taken_.size()};
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

std::uint64_t key_of_run(std::uint64_t master_seed, std::uint64_t run) { return sim::Random{master_seed, run}.bits(); }

std::uint64_t seed_of_run(std::uint64_t master_seed, std::uint64_t run) { return key_of_run(master_seed, run) >> 11U; }

Stretch share_of(const Shard& shard, std::uint64_t flights, std::uint64_t of_a_part) {
  const std::uint64_t parts = (flights + of_a_part - 1) / of_a_part;
  const auto begin_of = [&](std::uint64_t number) {
    return std::min(parts * (number - 1) / shard.of * of_a_part, flights);
  };
  const std::uint64_t first = begin_of(shard.number);
  return {.first = first, .count = begin_of(shard.number + 1) - first};
}

std::vector<Part> parts_of(const Stretch& flights, std::uint64_t of_a_part, const std::string& name) {
  std::vector<Part> parts;
  const std::uint64_t end = flights.first + flights.count;
  for (std::uint64_t first = flights.first; first < end; first += of_a_part) {
    parts.push_back({.name = fmt::format("{}{:08}", name, first),
                     .flights = {.first = first, .count = std::min(of_a_part, end - first)}});
  }
  return parts;
}

Summary run(const Flights& flights, const Folder* folder, unsigned threads,
            const std::function<void(std::uint64_t done)>& look) {
  struct Stopped {};
  InOrder order{flights};
  std::atomic<std::uint64_t> stored{0};
  std::atomic<std::uint64_t> flown{0};
  std::atomic<bool> stop{false};
  const std::function<void()> flew_one = [&] {
    ++flown;
    if (stop) {
      throw Stopped{};  // whoever looks has thrown, which is what comes out
    }
  };
  parallel_for(
      flights.parts.size(), threads,
      [&](std::size_t i) {
        if (i >= order.end()) {
          return;  // the parts before it are enough
        }
        const Part& part = flights.parts[i];
        const auto there = folder != nullptr ? folder->stored(part.name) : std::nullopt;
        if (there && flights.take(i, *there)) {
          stored += part.flights.count;
        } else {
          const std::string text = flights.fly(i, flew_one);
          if (folder != nullptr) {
            folder->store(part.name, text);
          }
          if (!flights.take(i, text)) {
            throw std::logic_error{"part " + part.name + " is not what was flown"};
          }
        }
        order.took(i);
      },
      [&](std::size_t) {
        try {
          look(stored + flown);
        } catch (...) {
          stop = true;
          throw;
        }
      });
  return {.parts = order.end(),
          .flights = stored + flown,
          .flown = flown,
          .damaged = folder != nullptr ? folder->damaged() : 0};
}

}  // namespace fantail::runs
