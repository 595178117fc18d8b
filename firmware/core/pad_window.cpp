// SPDX-License-Identifier: MIT
#include "core/pad_window.hpp"

#include "core/finite.hpp"

namespace fantail::core {
namespace {

void add(Vector3& sum, const Vector3& v) {
  sum.x += v.x;
  sum.y += v.y;
  sum.z += v.z;
}

Vector3 divide(const Vector3& sum, float count) { return {sum.x / count, sum.y / count, sum.z / count}; }

float square(const Vector3& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

// Compares squares: no square root for a yes or no.
bool is_one_g(float force_squared, float tolerance) {
  const float least = standard_gravity_m_s2 - tolerance;
  const float most = standard_gravity_m_s2 + tolerance;
  return force_squared >= least * least && force_squared <= most * most;
}

}  // namespace

bool PadWindow::update(Microseconds time, const Vector3& rate_rad_s, const Vector3& specific_force_m_s2) {
  // What happened while nobody watched is unknown: it is not rest, and no average reaches across it.
  if (last_time_ && (time < *last_time_ || time - *last_time_ > plan_.stale_time)) {
    restart();
  }
  last_time_ = time;
  const float force_squared = force_squared_.update(time, square(specific_force_m_s2));
  const bool still =
      is_within(rate_rad_s, plan_.quiet_rate_rad_s) && is_one_g(force_squared, plan_.rest_tolerance_m_s2);
  if (!still) {
    rest_since_.reset();
    open_.still = false;  // the block that this sample may close, too
  } else if (!rest_since_) {
    rest_since_ = time;
  }
  const bool renewed = go_on(time);
  open_.still = open_.still && still;
  add(open_.rate_sum, rate_rad_s);
  add(open_.force_sum, specific_force_m_s2);
  open_.samples += 1.0F;
  return renewed && still;
}

void PadWindow::interrupt(Microseconds time) {
  rest_since_.reset();
  open_.still = false;
  go_on(time);
}

bool PadWindow::go_on(Microseconds time) {
  if (!open_since_) {
    open_since_ = time;
  }
  sum_one_more();
  if (time - *open_since_ < block_time) {
    return false;
  }
  judge_movement(time - *open_since_);
  const bool renewed = close_block();
  open_since_ = time;
  return renewed;
}

void PadWindow::restart() {
  rest_since_.reset();
  open_since_.reset();
  open_.clear();
  closed_ = still_ = 0;
  next_ = 0;
  forget_window();
}

void PadWindow::forget_window() {
  window_.clear();
  summed_ = 0;
}

Microseconds PadWindow::at_rest_for(Microseconds now) const {
  return rest_since_ ? now - *rest_since_ : Microseconds{0};
}

bool PadWindow::close_block() {
  while (summed_ < window_blocks) {
    sum_one_more();
  }
  const Block window = window_;
  forget_window();
  still_ = !open_.still || !movement_.is_supported() ? 0 : still_ < blocks_.size() ? still_ + 1 : still_;
  blocks_[next_] = open_;
  open_.clear();
  next_ = (next_ + 1) % blocks_.size();
  closed_ = closed_ < blocks_.size() ? closed_ + 1 : closed_;
  if (closed_ < blocks_.size() || !window.still) {
    return false;
  }
  const Vector3 mean_rate_rad_s = divide(window.rate_sum, window.samples);
  if (!is_within(mean_rate_rad_s, largest_gyro_bias_rad_s(plan_))) {
    return false;
  }
  average_ = PadAverage{mean_rate_rad_s, divide(window.force_sum, window.samples)};
  if (still_ == blocks_.size()) {
    movement_.rest();
  }
  return true;
}

// While no bias is known, no turn is either.
void PadWindow::judge_movement(Microseconds length) {
  if (open_.samples < 1.0F) {
    return movement_.miss();
  }
  const Vector3 mean_rate_rad_s = divide(open_.rate_sum, open_.samples);
  movement_.take(seconds(length), average_ ? minus(mean_rate_rad_s, average_->gyro_bias_rad_s) : Vector3{},
                 divide(open_.force_sum, open_.samples));
}

// Oldest first; the oldest of all gives way to the block that closes, and the newest are the guard.
void PadWindow::sum_one_more() {
  if (summed_ == window_blocks) {
    return;
  }
  const Block& block = blocks_[(next_ + 1 + summed_) % blocks_.size()];
  window_.still = window_.still && block.still && block.samples >= 1.0F;
  add(window_.rate_sum, block.rate_sum);
  add(window_.force_sum, block.force_sum);
  window_.samples += block.samples;
  ++summed_;
}

}  // namespace fantail::core
