// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/inputs.hpp"
#include "link/avionics_link.hpp"
#include "protocol/bus_messages.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::bench {

inline constexpr double widest_request_deg = 20.47;  ///< that fits into a frame

using link::Each;

/// The range in which the canards may be moved. Shaft angles.
struct Bounds {
  Each<double> limit_rad{};   ///< largest angle that the avionics commands, both ways
  Each<double> centre_rad{};  ///< the trim: where a canard stands without a request
};

/// `trims` beyond a limit are clamped to it, as in the avionics.
[[nodiscard]] Bounds bounds(const protocol::LimitReport& limits, const Each<core::Angle>& trims);

enum class ExerciseKind : std::uint8_t { limits, step, sine };
[[nodiscard]] std::string_view name(ExerciseKind kind);

/// What a stretch of an exercise is for.
enum class Part : std::uint8_t {
  settle,
  ramp_positive,  ///< slowly from the centre to beyond the positive limit
  hold_positive,
  return_from_positive,
  centre_from_above,
  ramp_negative,
  hold_negative,
  return_from_negative,
  centre_from_below,
  step_out,     ///< at once, from the centre to the positive limit
  step_across,  ///< to the negative limit
  step_home,    ///< back to the centre
  sine,
};

/// A piece of an exercise in which every angle asked changes evenly.
struct Stretch {
  Part part{};
  double begin_s = 0.0;
  double end_s = 0.0;
  Each<double> from_rad{};
  Each<double> to_rad{};
  Each<bool> asked{};
};

/// Consecutive stretches that exercise one canard alone, or all of them together.
struct Turn {
  std::optional<std::size_t> canard{};  ///< empty: all together
  std::size_t first = 0;                ///< stretch
  std::size_t last = 0;                 ///< stretch, included
};

/// The requested canard angles over time: a pure function of the time since its start. It ends with a request to centre
/// every canard.
class Exercise {
 public:
  /// Each canard alone and then all together: beyond both limits and back at 20 deg/s, then at once to the positive
  /// limit, the negative one, and home. 22 s for limits of 6 deg, 36 s for 20 deg.
  [[nodiscard]] static Exercise limits(const Bounds& bounds);
  /// The same of all four together, without the turns alone.
  [[nodiscard]] static Exercise limits_together(const Bounds& bounds);
  /// The same of one canard alone.
  [[nodiscard]] static Exercise limits_of(const Bounds& bounds, std::size_t canard);
  /// To an angle at once, and home after half a second. Throws std::invalid_argument when it is beyond what the bus
  /// can carry (20.47 deg).
  [[nodiscard]] static Exercise step(const Bounds& bounds, std::size_t canard, double to_rad);
  struct Wave {
    double amplitude_rad;  ///< about the centre
    double frequency_hz;   ///< 0.05 to 50
    int cycles;            ///< 1 or more; together 0.1 to 60 s
  };
  /// Throws std::invalid_argument for a value outside its range.
  [[nodiscard]] static Exercise sine(const Bounds& bounds, std::size_t canard, const Wave& wave);

  [[nodiscard]] protocol::PerCanard asked(double time_s) const;
  [[nodiscard]] double duration_s() const { return stretches_.back().end_s; }

  [[nodiscard]] ExerciseKind kind() const { return kind_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] const std::optional<Wave>& wave() const { return wave_; }
  [[nodiscard]] std::span<const Stretch> stretches() const { return stretches_; }
  [[nodiscard]] std::span<const Turn> turns() const { return turns_; }

  /// The stretch that a time belongs to: what Tick::stretch of the ticks received then should be.
  [[nodiscard]] std::size_t stretch_at(double time_s) const;

  /// How many of its turns are over when this stretch is done.
  [[nodiscard]] std::size_t turns_before(std::size_t stretch) const;
  /// Its first turns, one at least, as an exercise of their own.
  [[nodiscard]] Exercise beginning(std::size_t first_turns) const;
  /// What happens in it, for people: "canard 2 alone: slowly beyond the + limit".
  [[nodiscard]] std::string doing(std::size_t stretch) const;

 private:
  Exercise(ExerciseKind kind, const Bounds& bounds) : kind_{kind}, bounds_{bounds} {}
  void begin_turn(std::optional<std::size_t> canard);
  void go(Part part, double duration_s, const Each<double>& to_rad);
  void jump(Part part, double duration_s, const Each<double>& to_rad);
  void limits_turn(std::optional<std::size_t> canard);

  ExerciseKind kind_;
  Bounds bounds_;
  std::optional<Wave> wave_;
  std::vector<Stretch> stretches_;
  std::vector<Turn> turns_;
  Each<bool> asked_{};
  Each<double> now_rad_{};
};

/// A smaller step from the trim shows nothing: within its tolerances, a canard that does not move at all would have
/// reached the angle.
[[nodiscard]] double least_step_rad(const sim::CanardTolerances& tolerances);
/// A smaller amplitude shows nothing: most of the movement of a canard that is just fast enough could be missing.
/// Infinite if it moves less than that at any amplitude.
[[nodiscard]] double least_amplitude_rad(double frequency_hz, const sim::CanardTolerances& tolerances);

/// Throws std::invalid_argument, for a person, when a step or a sine, within the limit, is smaller.
void expect_enough_movement(const Exercise& exercise, std::size_t canard, const sim::CanardTolerances& tolerances);

}  // namespace fantail::bench
