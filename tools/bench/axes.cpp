// SPDX-License-Identifier: MIT
#include "bench/axes.hpp"

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "link/frame_order.hpp"
#include "link/session.hpp"

namespace fantail::bench {
namespace {

constexpr hal::Microseconds look_period{10'000};
constexpr hal::Microseconds patience{60'000'000};
constexpr hal::Microseconds time_at_rest{1'000'000};
using ReportClock = link::WrappingCounter<1 << 14>;  // GyroReport::time_ms
constexpr double longest_gap_s = 0.1;                // a hand does not turn a rocket there and back in less

sim::Vector3 vector(const core::Vector3& v) {
  return {.x = static_cast<double>(v.x), .y = static_cast<double>(v.y), .z = static_cast<double>(v.z)};
}

/// Hears every report of the sensors.
class Sensors {
 public:
  Sensors(link::Place& place, link::AvionicsLink& link) : place_{place}, link_{link} {}

  /// Until `done` or no longer than `patience`; `gyro` and `accelerometer` take the reports. False: not done.
  template <typename Done, typename OnGyro, typename OnAccelerometer>
  bool listen(Done done, OnGyro gyro, OnAccelerometer accelerometer) {
    link::Timeout timeout{patience, place_.now()};
    while (!done()) {
      link_.expect_one_rocket();
      if (link_.has_fallen_silent()) {
        throw link::LinkError{"the avionics has stopped reporting"};
      }
      if (timeout.expired(place_.now())) {
        return false;
      }
      place_.wait(look_period);
      // One frame at a time: of each kind the link keeps the newest alone.
      for (bool more = true; more;) {
        more = link_.listen(place_.now(), 1);
        if (const auto& heard = link_.newest<protocol::GyroReport>(); heard && heard->count != gyros_) {
          gyros_ = heard->count;
          gyro(heard->message);
        }
        if (const auto& heard = link_.newest<protocol::AccelerometerReport>(); heard && heard->count != forces_) {
          forces_ = heard->count;
          accelerometer(heard->message);
        }
      }
    }
    return true;
  }

  [[nodiscard]] bool at_rest() const {
    const auto& status = link_.newest<protocol::StatusReport>();
    return status && status->message.at_rest;
  }
  [[nodiscard]] hal::Microseconds now() const { return place_.now(); }

 private:
  link::Place& place_;
  link::AvionicsLink& link_;
  std::uint64_t gyros_ = 0;
  std::uint64_t forces_ = 0;
};

class Mean {
 public:
  void add(const sim::Vector3& v) {
    sum_ = sum_ + v;
    count_ += 1.0;
  }
  [[nodiscard]] std::optional<sim::Vector3> value() const {
    return count_ > 0.0 ? std::optional{(1.0 / count_) * sum_} : std::nullopt;
  }

 private:
  sim::Vector3 sum_{};
  double count_ = 0.0;
};

struct Rest {
  sim::Vector3 rate_rad_s;  ///< what the gyro reads of no turn
  ForcesAtRest force_m_s2;
};

Rest rest(Sensors& sensors, const std::string& complaint) {
  Mean rate;
  std::array<Mean, accelerometer_count> force;
  hal::Microseconds since = sensors.now();
  const auto done = [&] {
    if (!sensors.at_rest()) {
      since = sensors.now();
      rate = {};
      force = {};
    }
    return sensors.now() - since >= time_at_rest;
  };
  const bool rested = sensors.listen(
      done,
      [&](const protocol::GyroReport& report) {
        if (report.quality == core::SampleQuality::valid) {
          rate.add(vector(report.rate_rad_s));
        }
      },
      [&](const protocol::AccelerometerReport& report) {
        if (report.quality == core::SampleQuality::valid) {
          force[static_cast<std::size_t>(report.sensor)].add(vector(report.specific_force_m_s2));
        }
      });
  if (!rested) {
    throw NotTurned{complaint};
  }
  const auto bias_rad_s = rate.value();
  if (!bias_rad_s) {
    throw NotTurned{"the avionics reports no valid gyro rate at rest; its firmware may be an older version"};
  }
  return {.rate_rad_s = *bias_rad_s, .force_m_s2 = {force[0].value(), force[1].value()}};
}

/// Adds up the reported rates, by the avionics' own clock.
class Turn {
 public:
  explicit Turn(const sim::Vector3& bias_rad_s) : bias_rad_s_{bias_rad_s} {}

  void add(const protocol::GyroReport& report) {
    if (report.quality == core::SampleQuality::saturated) {
      throw NotTurned{"the rocket was turned faster than its gyro can measure"};
    }
    if (report.quality != core::SampleQuality::valid) {
      return;  // a gap, which is judged by its length
    }
    const sim::Vector3 rate_rad_s = vector(report.rate_rad_s) - bias_rad_s_;
    if (last_) {
      const double step_s = 1e-3 * static_cast<double>(last_->clock.step_to(report.time_ms));
      if (step_s > longest_gap_s) {
        throw NotTurned{fmt::format("the gyro rates have a gap of {:.2f} s", step_s)};
      }
      const sim::Vector3 step_rad = 0.5 * step_s * (rate_rad_s + last_->rate_rad_s);
      angle_rad_ = angle_rad_ + step_rad;
      turned_ = sim::renormalized(turned_ * sim::small_rotation(step_rad));
    }
    last_ = {.clock = ReportClock{report.time_ms}, .rate_rad_s = rate_rad_s};
  }
  [[nodiscard]] const sim::Vector3& angle_rad() const { return angle_rad_; }
  [[nodiscard]] const sim::Quaternion& turned() const { return turned_; }

 private:
  struct Last {
    ReportClock clock;
    sim::Vector3 rate_rad_s;
  };
  sim::Vector3 bias_rad_s_;
  std::optional<Last> last_;
  sim::Vector3 angle_rad_{};
  sim::Quaternion turned_{};
};

}  // namespace

const std::array<AskedTurn, turn_count>& asked_turns() {
  static const std::array<AskedTurn, turn_count> turns{
      {{"roll", "stand the rocket upright and roll it once around, clockwise seen from its tail, back to its mark"},
       {"tilt", "lay it down"},
       {"back", "stand it up again"},
       {"tilt across", "lay it down again, in a direction at right angles to the first"}}};
  return turns;
}

namespace {

TurnsSeen turns_of_one(link::Place& place, link::AvionicsLink& link,
                       const std::function<void(const AskedTurn&)>& tell) {
  Sensors sensors{place, link};
  TurnsSeen seen{};
  Rest before = rest(sensors, "the rocket does not come to rest");
  for (std::size_t i = 0; i < turn_count; ++i) {
    const AskedTurn& asked = asked_turns()[i];
    tell(asked);
    Turn turn{before.rate_rad_s};
    const auto add = [&turn](const protocol::GyroReport& report) { turn.add(report); };
    const auto ignore = [](const protocol::AccelerometerReport&) {};
    if (!sensors.listen([&] { return !sensors.at_rest(); }, add, ignore)) {
      throw NotTurned{fmt::format("the rocket was not turned for \"{}\"", asked.name)};
    }
    const std::string complaint = fmt::format("the rocket did not come to rest after \"{}\"", asked.name);
    if (!sensors.listen([&] { return sensors.at_rest(); }, add, ignore)) {
      throw NotTurned{complaint};
    }
    const Rest after = rest(sensors, complaint);
    seen[i] = {.before_m_s2 = before.force_m_s2,
               .after_m_s2 = after.force_m_s2,
               .angle_rad = turn.angle_rad(),
               .turned = turn.turned()};
    before = after;
  }
  return seen;
}

}  // namespace

TurnsSeen watch_turns(link::Place& place, link::AvionicsLink& link, const std::function<void(const AskedTurn&)>& tell) {
  try {
    return turns_of_one(place, link, tell);
  } catch (const NotTurned&) {
    link::look_for_second_rocket(place, link);
    throw;
  }
}

}  // namespace fantail::bench
