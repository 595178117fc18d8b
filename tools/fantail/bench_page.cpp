// SPDX-License-Identifier: MIT
#include "fantail/bench_page.hpp"

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "bench/sheet.hpp"
#include "bench/trace.hpp"
#include "live/broadcast.hpp"
#include "live/panel.hpp"
#include "live/sheet_feed.hpp"
#include "page/page.hpp"

namespace fantail::tool {

class BenchPage::Work {
 public:
  Work(const PageOptions& options, const std::string& source)
      : source_{source},
        page_{address_of(options),
              live::sheet_panel({.source = source, .command = page::made_by_command(), .version = FANTAIL_VERSION}),
              [this] { return feed_.frame(); }, [this] { return feed_.greeting(); }} {}
  ~Work() { stop(); }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  void begin(const bench::Exercise& exercise, const sim::CanardTolerances& tolerances, const bench::Heading& heading) {
    exercise_ = exercise;
    sheet_.emplace(exercise, tolerances, heading);
    feed_.begin(exercise.duration_s(), exercise.bounds().limit_rad);
    thread_ = std::thread{[this] { run(); }};
  }

  void take(const link::Tick& tick) {
    const std::scoped_lock lock{mutex_};
    waiting_.push_back(tick);
  }

  void progress(double done_s) {
    const std::scoped_lock lock{mutex_};
    done_s_ = done_s;
  }

  void finish(std::string sheet_html) {
    stop();
    end(std::move(sheet_html), "");
  }

  void give_up(const std::string& why, bool turns_count) {
    if (ended_) {
      return;
    }
    stop();
    end(sheet_ && turns_count ? sheet_->given_up(why) : bench::no_sheet_html(source_, why), why);
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

  void end(std::string sheet_html, const std::string& why) {
    ended_ = true;
    feed_.fill(std::move(sheet_html));
    feed_.end(why);
    page_.finish();
  }

  // True: go on behind them.
  bool take_waiting(std::vector<link::Tick>& ticks, double& done_s) {
    ticks.clear();
    const std::scoped_lock lock{mutex_};
    std::swap(ticks, waiting_);
    done_s = done_s_;
    return !end_;
  }

  void run() {
    constexpr std::chrono::milliseconds between_looks{20};
    std::vector<link::Tick> ticks;
    double done_s = 0.0;
    for (bool more = true; more;) {
      more = take_waiting(ticks, done_s);
      for (const link::Tick& tick : ticks) {
        first_tick_ = first_tick_.value_or(tick.number);
        feed_.move(bench::tick_s * static_cast<double>(tick.number - *first_tick_), done_s,
                   exercise_->doing(tick.stretch), tick.command_rad, tick.encoder_rad);
        if (auto html = sheet_->take(tick)) {
          feed_.fill(std::move(*html));
        }
      }
      std::this_thread::sleep_for(more ? between_looks : std::chrono::milliseconds{0});
    }
  }

  std::string source_;
  live::SheetFeed feed_;
  live::Broadcast page_;
  std::optional<bench::Exercise> exercise_;
  bool ended_ = false;
  std::mutex mutex_;
  std::vector<link::Tick> waiting_;
  double done_s_ = 0.0;
  bool end_ = false;
  std::optional<bench::FillingSheet> sheet_;  ///< of the thread, while it runs
  std::optional<std::int64_t> first_tick_;    ///< of the thread
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

void BenchPage::progress(double done_s) {
  if (work_) {
    work_->progress(done_s);
  }
}

void BenchPage::give_up(const std::string& why, bool turns_count) {
  if (work_) {
    work_->give_up(why, turns_count);
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
