// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flight/before_burnout.hpp"
#include "sim/scenario.hpp"
#include "sim/world.hpp"

namespace fantail::fly {

/// Looks at a flight from lift-off until its motor has next to nothing left.
class BurnWatch {
 public:
  /// The scenario outlives this object. A path that does not say when its motor burns out is not looked at.
  explicit BurnWatch(const sim::Scenario& scenario);

  /// Each tick, in order; seconds since power-up.
  void look(const sim::World& world, double time_s);

  /// Empty: nothing of it happened. Times since power-up.
  [[nodiscard]] std::optional<flight::BeforeBurnout> found() const;

 private:
  [[nodiscard]] bool is_burnt_out(const sim::World& world, double time_s) const;
  void look_at_attitude(const sim::World& world, double time_s);
  void look_at_height(const sim::World& world, double time_s);
  void look_at_ground(const sim::World& world, double time_s);

  const sim::Scenario& scenario_;
  bool is_over_;
  double highest_m_ = 0.0;
  double highest_s_ = 0.0;
  bool was_up_ = false;
  bool sinks_ = false;  ///< below its highest point, by as much as counts
  flight::BeforeBurnout found_{};
};

}  // namespace fantail::fly
