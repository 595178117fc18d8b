// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/canard_mixer.hpp"
#include "core/flight_plan.hpp"
#include "core/inputs.hpp"

namespace fantail::core {

enum class CanardVerdict : std::uint8_t {
  healthy,
  dead,         ///< its encoder has been silent for the plan's timeout
  stalled,      ///< far from where the command should have brought it, and not moving
  slipping,     ///< far from where the command should have brought it, though it moves
  disagreeing,  ///< near enough by itself, but not where the other canards stand
};

/// Compares each canard's command with its encoder. The command first passes a model of the servo (a first-order lag),
/// so that fast excitation is not mistaken for a fault; a difference has to last for the plan's hold.
class CanardMonitor {
 public:
  CanardMonitor(const MonitorPlan& monitor, const CanardsPlan& canards);

  const std::array<CanardVerdict, canard_count>& update(Microseconds time, const CanardCommands& commands,
                                                        const EncoderAngles& encoders);

 private:
  struct Channel {
    std::optional<Angle> expected;
    std::optional<Microseconds> silent_since;
    std::optional<Microseconds> off_since;
    std::optional<Microseconds> apart_since;
    Angle lowest;  ///< encoder angles since off_since
    Angle highest;
  };

  CanardVerdict judge(Microseconds time, std::size_t canard, float moved_share, const CanardCommand& command,
                      const EncoderAngles& encoders);
  [[nodiscard]] bool stands_apart(std::size_t canard, const EncoderAngles& encoders) const;
  bool lasts(std::optional<Microseconds>& since, bool condition, Microseconds time) const;

  MonitorPlan plan_;
  CanardsPlan canards_;
  std::array<Channel, canard_count> channels_{};
  std::array<CanardVerdict, canard_count> verdicts_{};
  std::optional<Microseconds> last_time_;
};

}  // namespace fantail::core
