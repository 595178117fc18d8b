// SPDX-License-Identifier: MIT
#include "live/sheet_feed.hpp"

#include <utility>

#include "json/value.hpp"
#include "text/degrees.hpp"

namespace fantail::live {
namespace {

using Json = json::Value;
using text::in_degrees;

}  // namespace

void SheetFeed::begin(double duration_s, const Each<double>& limit_rad) {
  const std::scoped_lock lock{mutex_};
  duration_s_ = duration_s;
  limit_rad_ = limit_rad;
}

void SheetFeed::move(double time_s, double done_s, std::string_view now, const Each<std::optional<double>>& command_rad,
                     const Each<std::optional<double>>& encoder_rad) {
  std::array<std::optional<double>, signal_count> sample;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    sample[2 * i] = in_degrees(command_rad[i]);
    sample[2 * i + 1] = in_degrees(encoder_rad[i]);
  }
  const std::scoped_lock lock{mutex_};
  done_s_ = done_s;
  now_ = now;
  command_rad_ = command_rad;
  encoder_rad_ = encoder_rad;
  plots_.add(std::chrono::duration_cast<hal::Microseconds>(std::chrono::duration<double>{time_s}), sample);
}

void SheetFeed::fill(std::string html) {
  const std::scoped_lock lock{mutex_};
  sheet_html_ = std::move(html);
  sheet_is_new_ = true;
}

void SheetFeed::end(std::string why) {
  const std::scoped_lock lock{mutex_};
  ended_ = true;
  why_ = std::move(why);
}

std::string SheetFeed::frame() {
  const std::scoped_lock lock{mutex_};
  number_ += 1;
  Json frame = now_json();
  frame["plot"] = plots_.take_news();
  if (std::exchange(sheet_is_new_, false)) {
    frame["sheet"] = sheet_html_;
  }
  return frame.dump();
}

std::string SheetFeed::greeting() const {
  const std::scoped_lock lock{mutex_};
  Json frame = now_json();
  frame["first"] = true;
  frame["plot"] = plots_.all_told();
  if (!sheet_html_.empty()) {
    frame["sheet"] = sheet_html_;
  }
  return frame.dump();
}

Json SheetFeed::now_json() const {
  Json canards = Json::array();
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    canards.push_back({{"command_deg", json::printed(in_degrees(command_rad_[i]), 2)},
                       {"encoder_deg", json::printed(in_degrees(encoder_rad_[i]), 2)},
                       {"limit_deg", json::printed(text::degrees(limit_rad_[i]), 2)}});
  }
  return {{"frame", number_},
          {"time_s", json::printed(done_s_, 1)},
          {"of_s", json::printed(duration_s_, 1)},
          {"now", now_},
          {"ended", ended_},
          {"why", why_},
          {"canards", std::move(canards)}};
}

}  // namespace fantail::live
