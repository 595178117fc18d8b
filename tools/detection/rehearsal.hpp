// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/tick_record.hpp"
#include "detection/event_models.hpp"
#include "detection/readings.hpp"
#include "detection/rule.hpp"
#include "detection/screen.hpp"

namespace fantail::detection {

/// What one rule made of one event. Steps are milliseconds from the beginning of the event.
struct Answer {
  /// The first time that it detected a launch; of a flight that comes down, after the flight.
  std::optional<std::size_t> detected{};
  std::optional<std::size_t> controlling{};  ///< from here on the canards may move
  /// How far a detection came towards the gate of height and speed: at 1 it opens. Of the two the smaller share.
  float nearness = 0.0F;
  /// Beyond the gate, and kept from control by accelerometers that disagree.
  static constexpr float held_back = 0.999F;
  // Of flights that come down.
  bool flown = false;        ///< control began in the flight, rightly: what comes after is no event for this rule
  Part part = Part::launch;  ///< in which control began otherwise
  // Of launches.
  float tilt_error_rad = 0.0F;            ///< estimated less true tilt, at detection
  std::optional<std::size_t> crossing{};  ///< the thrust alone is first at the rule's threshold
  float distance_error_m = 0.0F;          ///< estimated less true distance along the guide, at control start
  float distance_m = 0.0F;                ///< the true one
};

/// Which way an event goes through the flight law.
enum class Path : std::uint8_t {
  /// Nothing where no noise can make a rule fire; else the product's launch detector alone; and the whole law only
  /// where that fires, or where a detector that was shut off for a while might. Of launches the whole law.
  fast,
  full,  ///< the whole law always
};

/// Does the launch detector of this plan fire in an event of so many steps?
[[nodiscard]] bool fires(const core::FlightPlan& plan, const Readings& readings, std::size_t length);

/// Events, one after the other, through several rules. Holds the room that an event takes: one for each thread.
class Rehearsal {
 public:
  /// The rules outlive it.
  explicit Rehearsal(std::span<const Rule> rules);

  /// What happens depends on seed, kind and number alone. An answer for each rule, valid until the next event.
  const std::vector<Answer>& play(std::uint64_t seed, Kind kind, std::uint64_t event, Path path = Path::fast);

  /// Shows every tick of the event, of each rule; the pad before it is left out. Set before play() with Path::full.
  std::function<void(std::size_t rule, std::size_t step, const core::TickRecord& record)> on_tick{};

  /// Of the last event; across the axis as far as it was needed.
  [[nodiscard]] const Motion& motion() const { return *motion_; }
  [[nodiscard]] const Readings& readings() const { return *readings_; }

 private:
  [[nodiscard]] bool any_fires(sim::Random& axial);
  void fly(const std::vector<bool>& wanted, sim::Random others);
  void follow(std::size_t rule, std::size_t step, const core::TickRecord& record);

  std::span<const Rule> rules_;
  std::unique_ptr<Motion> motion_;
  std::unique_ptr<Readings> readings_;
  std::vector<Answer> answers_;
  std::vector<bool> wanted_;
  std::vector<Screened> screened_;
  std::vector<bool> is_in_flight_;  ///< each rule, in the launch of a flight that comes down
};

}  // namespace fantail::detection
