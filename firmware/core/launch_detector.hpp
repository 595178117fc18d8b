// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "core/low_pass.hpp"

namespace fantail::core {

/// Why the detector stands where it stands.
enum class DetectionState : std::uint8_t {
  quiet,        ///< below the threshold
  holding,      ///< above the threshold, not yet for long enough
  detected,     ///< this sample completes the hold
  bad_sample,   ///< a sample was invalid, absent or stale: the hold starts again
  disagreement  ///< the two accelerometers differ: the hold starts again
};

/// Launch detection by axial specific force held above a threshold for a time measured with the samples' own
/// timestamps: it fires at the first sample whose distance from the first one above the threshold is at least the hold.
/// With two accelerometers each has its own hold, and both must be complete.
///
/// Axial specific force is signed: a rocket lying on its side or standing on its nose does not look like a launch.
/// A sample saturated at the positive end counts as above the threshold.
class LaunchDetector {
 public:
  /// A sample older than `stale_time`, of the motion plan, is none.
  LaunchDetector(const LaunchDetectionPlan& plan, Microseconds stale_time);

  /// Once a tick, as long as a launch may be detected. A sample that was seen before changes nothing; one after a gap
  /// longer than the stale time begins a new hold.
  DetectionState update(Microseconds now, const std::array<AccelerometerSample, 2>& samples);

  /// After a detection, in place of update(): false while control must not begin, because in the last quarter of a
  /// second two accelerometers have disagreed. While only one measures, nobody disagrees with it.
  [[nodiscard]] bool agrees(Microseconds now, const std::array<AccelerometerSample, 2>& samples);

  /// Forgets holds and filter states.
  void reset();

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(channels_);
  }

 private:
  enum class Health : std::uint8_t { good, repeated, bad };

  struct Channel {
    explicit Channel(float low_pass_hz) : low_pass{low_pass_hz} {}
    void forget_hold() {
      above_since.reset();
      hold_complete = false;
    }
    [[nodiscard]] DetectionState state() const {
      if (hold_complete) {
        return DetectionState::detected;
      }
      return above_since ? DetectionState::holding : DetectionState::quiet;
    }
    LowPass low_pass;
    std::optional<Microseconds> last_time;
    std::optional<Microseconds> above_since;
    bool saturated = false;
    bool hold_complete = false;

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(low_pass, last_time, above_since, saturated, hold_complete);
    }
  };

  [[nodiscard]] Health health(Microseconds now, const Channel& channel, const AccelerometerSample& sample) const;
  [[gnu::noinline]] Health take(Channel& channel, Microseconds now, const AccelerometerSample& sample) const;
  /// Not written into its two callers, which would cost 200 bytes of flash.
  [[gnu::noinline]] Health feed(Channel& channel, Microseconds now, const AccelerometerSample& sample);
  [[nodiscard]] bool disagree() const;

  LaunchDetectionPlan plan_;
  Microseconds stale_time_;
  std::array<Channel, 2> channels_;
};

}  // namespace fantail::core
