// SPDX-License-Identifier: MIT
#include "fantail/bench_page.hpp"

#include <chrono>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "bench/trace.hpp"
#include "live/broadcast.hpp"
#include "live/panel.hpp"
#include "live/sheet_feed.hpp"
#include "page/page.hpp"

namespace fantail::tool {

class BenchPage::Work {
 public:
  Work(const PageOptions& options, const std::string& source)
      : page_{address_of(options),
              live::sheet_panel({.source = source, .command = page::made_by_command(), .version = FANTAIL_VERSION}),
              [this] { return feed_.frame(); }, [this] { return feed_.greeting(); }} {}
  ~Work() { stop(); }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  void begin(const bench::Exercise& exercise, const sim::CanardTolerances& tolerances, const bench::Heading& heading) {
    exercise_ = exercise;
    tolerances_ = tolerances;
    heading_ = heading;
    feed_.begin(exercise.duration_s(), exercise.bounds().limit_rad);
    thread_ = std::thread{[this] { run(); }};
  }

  void take(const link::Tick& tick) {
    const std::scoped_lock lock{mutex_};
    waiting_.push_back(tick);
  }

  void finish(std::string sheet_html) {
    stop();
    feed_.fill(std::move(sheet_html));
    feed_.end();
    page_.finish();
  }

  [[nodiscard]] const live::Broadcast& page() const { return page_; }

 private:
  void stop() {
    {
      const std::scoped_lock lock{mutex_};
      end_ = true;
    }
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  // True: go on.
  bool take_waiting(std::vector<link::Tick>& ticks) {
    ticks.clear();
    const std::scoped_lock lock{mutex_};
    std::swap(ticks, waiting_);
    return !end_;
  }

  void run() {
    constexpr std::chrono::milliseconds between_looks{20};
    std::vector<link::Tick> ticks;
    while (take_waiting(ticks)) {
      for (const link::Tick& tick : ticks) {
        (void)recording_.add(tick);
        const double done_s = bench::tick_s * static_cast<double>(tick.number - recording_.ticks().front().number);
        feed_.move(done_s, exercise_->doing(done_s), tick.command_rad, tick.encoder_rad);
        fill_sheet(exercise_->turns_over_at(done_s));
      }
      std::this_thread::sleep_for(between_looks);
    }
  }

  void fill_sheet(std::size_t turns_over) {
    const std::size_t all = exercise_->turns().size();
    if (turns_over <= turns_shown_ || turns_over == all) {
      return;  // the whole sheet comes with its verdict
    }
    turns_shown_ = turns_over;
    const bench::Exercise first = exercise_->beginning(turns_over);
    const bench::Sheet sheet = bench::examine(recording_, first, tolerances_, heading_);
    feed_.fill(bench::sheet_so_far_html(sheet, recording_, first, all - turns_over));
  }

  live::SheetFeed feed_;
  live::Broadcast page_;
  std::optional<bench::Exercise> exercise_;
  sim::CanardTolerances tolerances_;
  bench::Heading heading_;
  std::mutex mutex_;
  std::vector<link::Tick> waiting_;
  bool end_ = false;
  link::Recording recording_;  ///< of the thread
  std::size_t turns_shown_ = 0;
  std::thread thread_;
};

BenchPage::BenchPage(const PageOptions& options, const std::string& source) {
  if (options.wanted()) {
    work_ = std::make_unique<Work>(options, source);
    say_where(work_->page());
  }
}

BenchPage::~BenchPage() = default;

void BenchPage::wait_for_viewer() const {
  if (work_) {
    tool::wait_for_viewer(work_->page());
  }
}

void BenchPage::begin(const bench::Exercise& exercise, const sim::CanardTolerances& tolerances,
                      const bench::Heading& heading) {
  if (work_) {
    work_->begin(exercise, tolerances, heading);
  }
}

void BenchPage::take(const link::Tick& tick) {
  if (work_) {
    work_->take(tick);
  }
}

std::string BenchPage::finish(const bench::Sheet& sheet, const link::Recording& recording,
                              const bench::Exercise& exercise) {
  if (!work_) {
    return {};
  }
  work_->finish(bench::sheet_inner_html(sheet, recording, exercise));
  return viewers_text(work_->page().figures());
}

}  // namespace fantail::tool
