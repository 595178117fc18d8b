// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/gyro_gate.hpp"
#include "core/inputs.hpp"
#include "core/time.hpp"
#include "core/vector3.hpp"

namespace fantail::core {

/// Which of two gyros flies.
enum class GyroVote : std::uint8_t {
  both,      ///< they agree, and the first is used
  first,     ///< the first is used, and the second is rejected
  second,    ///< the second is used, and the first is rejected
  disagree,  ///< both are plausible but differ: neither is used
  neither,   ///< none is plausible
};
/// How many values GyroVote has: one that is read must be below.
inline constexpr std::size_t gyro_votes = 5;

/// Makes of two gyros the one that is flown on.
///
/// One that says nothing, hangs, repeats itself while the other turns, or jumps to the end of its range is put aside,
/// and the other is used in the same tick. Two that differ for longer than a moment are both put aside: nobody can say
/// which one is wrong. Until then the one is used that goes on from the last rate, so that a spike in one costs
/// nothing. Whoever was put aside is believed again when it has agreed with the other for a moment.
///
/// What they differ by on the pad is taken off the second, so that it reads as the first would: its bias is then the
/// first one's, and to change from one to the other steps neither angle nor rate. The mean needs no still rocket, for
/// both turn alike.
class GyroPair {
 public:
  /// Of the plan it takes `gyro_disagreement_rad_s`, and half the `stale_time`: by so much one may lag behind the
  /// other.
  GyroPair(const SensorsPlan& sensors, const MotionPlan& motion)
      : disagreement_rad_s_{sensors.gyro_disagreement_rad_s}, late_{motion.stale_time / 2} {}

  /// The sample to fly on; an absent one where neither is used. `rate_rad_s`: the last one that was (the bias that is
  /// taken off it is small beside what is a disagreement). `gate`: what could be believed of one gyro alone.
  [[nodiscard]] GyroSample choose(const Inputs& inputs, bool flies, const Vector3& rate_rad_s, const GyroGate& gate);

  /// Of the last choose(); GyroVote::neither before the first.
  [[nodiscard]] GyroVote vote() const { return vote_; }

  /// See core/state_visitor.hpp. What was voted is made anew in every tick.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(history_, difference_rad_s_, differences_, since_);
    visit.below(4, doubted_);
  }

 private:
  /// Of one gyro: its last sample, and how often it has said the same.
  struct History {
    Microseconds time{};
    Vector3 rate_rad_s;
    std::uint32_t repeats = 0;

    void note(Microseconds measured, const Vector3& rate);

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(time, rate_rad_s, repeats);
    }
  };
  enum class Doubted : std::uint8_t { nobody, first, second, both };

  struct CouldBe {
    bool first;
    bool second;
  };

  /// Which of the two could be true, by what each says of itself and by its last samples.
  CouldBe could_be(Microseconds now, const GyroSample& first, const GyroSample& second, const Vector3& as_read,
                   float roll_rate_rad_s, const GyroGate& gate);
  [[nodiscard]] bool is_first_better(const GyroSample& first, const GyroSample& second,
                                     const Vector3& rate_rad_s) const;
  /// Within this share of what they may differ by.
  [[nodiscard]] bool agree(const GyroSample& first, const GyroSample& second, float share) const;
  void put_aside(Doubted who);
  void judge(Microseconds now, bool agree);
  void learn_difference(const Vector3& first, const Vector3& second);

  float disagreement_rad_s_;
  Microseconds late_;
  GyroVote vote_ = GyroVote::neither;
  Doubted doubted_ = Doubted::nobody;
  std::optional<Microseconds> since_;  ///< since when they say the opposite of what is believed of them
  Vector3 difference_rad_s_;           ///< second less first, mean on the pad
  std::uint32_t differences_ = 0;      ///< samples in that mean
  std::array<History, 2> history_{};
};

}  // namespace fantail::core
