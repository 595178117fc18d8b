// SPDX-License-Identifier: MIT
#include "bench/axes.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "json/value.hpp"
#include "link/session.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::fixed;
using text::radians;

constexpr hal::Microseconds look_period{10'000};
constexpr hal::Microseconds patience{60'000'000};

constexpr double scale_tolerance = 0.03;  // of a whole turn: 11 degrees, more than a hand misses its mark by
constexpr double seen_share = 0.1;        // of a turn across: a gyro that stands askew by 6 degrees
constexpr double swapped_share = 0.5;

bool at_rest(const link::AvionicsLink& link) {
  const auto& status = link.newest<protocol::StatusReport>();
  return status && status->message.at_rest;
}

/// Sums up the reported roll rate, by the times at which the reports came.
class RollSum {
 public:
  void look(const link::AvionicsLink& link) {
    const auto& motion = link.newest<protocol::MotionReport>();
    if (!motion || motion->count == count_) {
      return;
    }
    const auto rate_rad_s = static_cast<double>(motion->message.roll_rate_rad_s);
    if (count_ > 0) {
      angle_rad_ += 0.5 * (rate_rad_s_ + rate_rad_s) * 1e-6 * static_cast<double>((motion->time - time_).count());
    }
    count_ = motion->count;
    time_ = motion->time;
    rate_rad_s_ = rate_rad_s;
  }
  [[nodiscard]] double angle_rad() const { return angle_rad_; }

 private:
  std::uint64_t count_ = 0;
  hal::Microseconds time_{};
  double rate_rad_s_ = 0.0;
  double angle_rad_ = 0.0;
};

void await_rest(link::Place& place, link::AvionicsLink& link, bool rest, RollSum& sum, const std::string& complaint) {
  link::Timeout timeout{patience, place.now()};
  while (at_rest(link) != rest) {
    if (link.has_fallen_silent()) {
      throw link::LinkError{"the avionics has fallen silent"};
    }
    if (timeout.expired(place.now())) {
      throw NotTurned{complaint};
    }
    place.wait(look_period);
    while (link.listen(place.now())) {
    }
    sum.look(link);
  }
}

// The person may tip the nose to either side, so the sense says nothing.
std::string across(const AskedTurn& turn, double seen_rad) {
  const double share = std::abs(seen_rad) / turn.angle_rad;
  if (share > swapped_share) {
    return fmt::format("The gyro's roll axis sees the {}: it lies across the rocket. Axes are swapped.", turn.axis);
  }
  return fmt::format("The gyro's roll axis sees {} % of the {}: it stands askew by about {} degrees.",
                     fixed(100.0 * share, 0), turn.axis, fixed(degrees(std::asin(share)), 0));
}

std::string along(const AskedTurn& turn, double seen_rad) {
  const double share = seen_rad / turn.angle_rad;
  if (std::abs(share) < seen_share) {
    return fmt::format("The roll by {} degrees was not seen ({} degrees).", fixed(degrees(turn.angle_rad), 0),
                       fixed(degrees(seen_rad), 1));
  }
  if (share < 0.0) {
    return fmt::format("The roll is reversed: {} degrees clockwise were seen as {}.", fixed(degrees(turn.angle_rad), 0),
                       fixed(degrees(seen_rad), 1));
  }
  return std::abs(share - 1.0) > scale_tolerance
             ? fmt::format("The scale is wrong: {} degrees of roll were seen as {}, {} times as many.",
                           fixed(degrees(turn.angle_rad), 0), fixed(degrees(seen_rad), 1), fixed(share, 3))
             : "";
}

}  // namespace

const std::array<AskedTurn, 3>& asked_turns() {
  static const std::array<AskedTurn, 3> turns{
      {{"roll", "stand the rocket upright, and roll it once around, clockwise as seen from its tail, back to its mark",
        radians(360.0)},
       {"pitch", "tip its nose by about 45 degrees in a plane through the long axis, and hold it there", radians(45.0)},
       {"yaw", "tip it back and, without a stop, by about 45 degrees in the plane across that one, and hold it there",
        radians(45.0)}}};
  return turns;
}

RollSeen watch_turns(link::Place& place, link::AvionicsLink& link, const std::function<void(const AskedTurn&)>& tell) {
  RollSeen seen{};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const AskedTurn& turn = asked_turns()[i];
    RollSum before;
    await_rest(place, link, true, before, "the rocket does not come to rest");
    tell(turn);
    RollSum during;
    await_rest(place, link, false, during, fmt::format("the rocket was not turned for the {}", turn.axis));
    await_rest(place, link, true, during, fmt::format("the rocket did not come to rest after the {}", turn.axis));
    seen[i] = during.angle_rad();
  }
  return seen;
}

AxesResult judge_axes(const RollSeen& seen_rad) {
  AxesResult result{.seen_rad = seen_rad};
  const auto& turns = asked_turns();
  if (std::string wrong = along(turns[0], seen_rad[0]); !wrong.empty()) {
    result.sentences.push_back(std::move(wrong));
  }
  for (std::size_t i = 1; i < seen_rad.size(); ++i) {
    if (std::abs(seen_rad[i]) > seen_share * turns[i].angle_rad) {
      result.sentences.push_back(across(turns[i], seen_rad[i]));
    }
  }
  result.right = result.sentences.empty();
  if (result.right) {
    result.sentences.emplace_back("The roll axis of the gyro is right: axis, sense and scale.");
  }
  return result;
}

std::string_view what_the_bus_does_not_report() {
  return "Not checked: the other two axes of the gyro, and the accelerometers. The bus reports neither their rates nor "
         "specific forces; a flight log holds them.";
}

std::string axes_text(const AxesResult& result) {
  std::string text;
  for (std::size_t i = 0; i < result.seen_rad.size(); ++i) {
    const AskedTurn& turn = asked_turns()[i];
    text += fmt::format("  {:<6} turned by {:>5} deg: roll seen {:>7} deg\n", turn.axis,
                        fixed(degrees(turn.angle_rad), 0), fixed(degrees(result.seen_rad[i]), 1));
  }
  for (const std::string& sentence : result.sentences) {
    text += sentence + "\n";
  }
  return text + std::string{what_the_bus_does_not_report()} + "\n";
}

std::string axes_json(const AxesResult& result) {
  json::Value turns = json::Value::array();
  for (std::size_t i = 0; i < result.seen_rad.size(); ++i) {
    turns.push_back({{"axis", std::string{asked_turns()[i].axis}},
                     {"asked_deg", json::rounded(degrees(asked_turns()[i].angle_rad), 3)},
                     {"roll_seen_deg", json::rounded(degrees(result.seen_rad[i]), 3)}});
  }
  return json::Value{{"right", result.right},
                     {"turns", turns},
                     {"sentences", result.sentences},
                     {"not_checked", std::string{what_the_bus_does_not_report()}}}
             .dump() +
         "\n";
}

}  // namespace fantail::bench
