// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/compensated_sum.hpp"
#include "core/flight_plan.hpp"
#include "core/gyro_gate.hpp"
#include "core/gyro_pair.hpp"
#include "core/inputs.hpp"
#include "core/low_pass.hpp"
#include "core/pad_window.hpp"
#include "core/vector3.hpp"

namespace fantail::core {

/// What is known of the rocket's motion at one instant.
struct Motion {
  Angle roll_angle;                     ///< zero at launch detection (tunnel: at control start); not wrapped
  float roll_rate_rad_s = 0.0F;         ///< gyro bias taken off
  Vector3 gyro_bias_rad_s;              ///< what is taken off: the mean of three still seconds; zero before the first
  Vector3 specific_force_m_s2;          ///< the sample that was integrated
  float height_m = 0.0F;                ///< above the place of lift-off, as far as `height_origin` lets it be known
  float horizontal_distance_m = 0.0F;   ///< from the same place
  float distance_along_guide_m = 0.0F;  ///< from the same place, in the direction that the guide had
  float speed_m_s = 0.0F;               ///< along the guide
  float vertical_speed_m_s = 0.0F;      ///< earth frame, positive up
  float speed_squared_m2_s2 = 0.0F;     ///< of all of the velocity
  Angle tilt;                           ///< of the rocket's axis from the vertical
  /// Of the same from where it pointed at rest on the pad; empty where the plan counts from the vertical.
  std::optional<Angle> tilt_from_guide;
  SensorState gyro = SensorState::failed;
  SensorState accelerometer = SensorState::failed;
  /// The gyro stood at the end of its range: the rocket turns faster than this, in this sense.
  bool rate_is_lower_bound = false;
  /// Since its zero the roll angle has gone through rates that nobody measured: a gap longer than the plan's stale
  /// time, or a gyro at the end of its range.
  bool roll_is_bridged = false;
  /// Since lift-off an accelerometer stood at the end of its range while no other measured: height and speed are at
  /// least these.
  bool speed_is_lower_bound = false;
  Microseconds at_rest_for{};  ///< on the pad, up to now; zero while the rocket moves or a sensor has failed
  bool has_moved = false;      ///< on the pad, and has not rested since: the attitude may be another one
  bool has_fallen = false;     ///< likewise: it was weightless for so long that it has flown
  /// Start of the integrated window: where the specific force left the pad's 1 g.
  Microseconds thrust_since{};
};

/// Attitude, roll, height and speed from a gyro and a three-axis accelerometer.
///
/// The gyro rate turns the attitude (a quaternion, body to earth) and is summed into the unwrapped roll angle. That is
/// the integral of a rate about an axis of the body: where the axis goes around a cone of half-angle theta f times a
/// second, a camera on the rocket sees another one, by 2 pi f (1 - cos theta). The
/// specific force is turned into the earth frame, gravity is removed, and the rest is integrated twice. Attitude and
/// gyro bias begin with the averages of a still window on the pad, so a tilted guide costs nothing.
///
/// Height origin. A launch is known only after the detector's hold; by then the rocket has speed and height. While the
/// rocket waits, this class integrates every sample since the low-passed axial specific force was last below 1.2 g and
/// starts again whenever it falls below. At detection that running integral is exactly the replayed hold window: the
/// same figures as a replay out of a buffer, with no buffer and no long tick.
///   replay         keeps height and speed of the window
///   velocity_only  keeps its speed and counts height from detection (what the published flight did)
///   from_detection keeps neither
///
/// Of two accelerometers the first that measures is integrated. One at the end of its range reads too little: it is
/// integrated only while no other measures, and from then on height and speed are lower bounds.
///
/// Which samples of the gyro are believed is said in gyro_gate.hpp, and which of two gyros in gyro_pair.hpp. Over a gap
/// in flight the rate is taken to have gone evenly from the last sample to the next.
///
/// Between detection and guide clearance a rocket that reads 1 g again stands: nothing flies at 1 g, so height and
/// speed start over. Without that a knock would leave a speed behind, and the speed would in time become a cleared
/// guide.
class MotionEstimator {
 public:
  /// Parts of a plan that has passed validate(); copied. Without `sensors` it follows one gyro.
  [[gnu::cold]] explicit MotionEstimator(const MotionPlan& plan, const SensorsPlan& sensors = {},
                                         TiltOrigin tilt_from = TiltOrigin::vertical);

  /// One tick. Sensors may be late, repeated or missing.
  void update(const Inputs& inputs) {
    return votes_ ? follow(inputs, choose_gyro(inputs)) : follow(inputs, inputs.gyro);
  }

  /// Launch detection: the roll angle is zero now, the bias is frozen, the height origin applied.
  void begin_flight(Microseconds now);

  /// The guide is clear: from here on nothing can bring the rocket to a stand.
  void leave_guide() { place_ = Place::free; }

  /// Control start in the tunnel: the roll angle is zero now, the bias is frozen.
  void begin_tunnel_run(Microseconds now) {
    place_ = Place::free;
    zero_roll(now);
  }

  /// A detection that turned out to be none: wait on the pad again.
  void return_to_pad();

  /// Nobody called update() for a while, and now the gyro of `inputs` is there: the rate is taken to have gone evenly
  /// from the last one to this one (to have stayed, when this one cannot be used), so that roll angle and attitude go
  /// on. What an accelerometer reads bridges any gap by itself. Longer than the plan's stale time, at most a second.
  void bridge(const Inputs& inputs);

  /// The estimate at `now`; the last rate bridges the time since the last gyro sample, at most the plan's stale time.
  void motion(Microseconds now, Motion& motion) const;
  [[nodiscard]] Motion motion(Microseconds now) const {
    Motion made;
    motion(now, made);
    return made;
  }

  /// Between two gyros, as the plan asks.
  [[nodiscard]] bool votes() const { return votes_; }
  /// Which of them flew in this tick; says nothing unless votes().
  [[nodiscard]] GyroVote gyro_vote() const { return gyro_pair_.vote(); }

  /// Where what is of use in flight ends, which begins at the beginning.
  [[nodiscard]] const void* end_of_flight_memory() const { return &pad_window_.average() + 1; }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(pad_window_, axial_, supported_since_, gyro_gate_, rate_rad_s_, rate_is_lower_bound_, roll_angle_rad_,
          roll_is_bridged_, accelerometer_time_, specific_force_m_s2_, pad_, trajectory_);
    visit.below(places, place_);
    visit.below(sensor_states, gyro_, accelerometer_);
    if (votes_) {  // as the plan says: a law with one gyro has no memory of two
      visit(gyro_pair_);
    }
  }

 private:
  enum class Place : std::uint8_t { pad, guide, free };
  static constexpr std::size_t places = 3;

  struct Quaternion {
    float w = 1.0F, x = 0.0F, y = 0.0F, z = 0.0F;

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(w, x, y, z);
    }
  };

  struct Trajectory {
    Quaternion attitude;  ///< body to earth
    Vector3 guide_axis;   ///< earth frame
    Vector3 velocity_m_s;
    Vector3 position_m;
    Vector3 acceleration_m_s2;  ///< of the last sample, gravity removed
    Microseconds since{};
    bool is_lower_bound = false;  ///< velocity and position

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(attitude, guide_axis, velocity_m_s, position_m, acceleration_m_s2, since, is_lower_bound);
    }
  };

  void follow(const Inputs& inputs, const GyroSample& gyro);
  [[nodiscard]] GyroSample choose_gyro(const Inputs& inputs) {
    return gyro_pair_.choose(inputs, place_ != Place::pad, rate_rad_s_, gyro_gate_);
  }
  void follow_gyro(Microseconds now, const GyroSample& sample);
  void follow_accelerometer(const Inputs& inputs);
  [[nodiscard]] bool follow_accelerometers_that_are(SampleQuality quality, const Inputs& inputs);
  void turn_evenly(Microseconds gap, const Vector3& last_rate_rad_s);
  void turn(float dt_s, const Vector3& first_rate_rad_s, const Vector3& last_rate_rad_s);
  void watch_pad(Microseconds now, const GyroSample& gyro);
  void integrate(Microseconds time);
  [[nodiscard]] bool stands(Microseconds time, Microseconds previous, float axial_m_s2);
  void set_pad_upright();
  [[nodiscard]] Vector3 acceleration() const;
  [[nodiscard]] float bridged_roll_rad(Microseconds now) const;
  void zero_roll(Microseconds now);
  [[nodiscard]] Vector3 without_bias(const Vector3& rate_rad_s) const;

  MotionPlan plan_;
  bool votes_;             ///< between two gyros
  bool tilts_from_guide_;  ///< by the plan
  LowPass axial_{16.0F};
  std::optional<Microseconds> supported_since_;
  Place place_ = Place::pad;

  SensorState gyro_ = SensorState::failed;
  GyroGate gyro_gate_;
  Vector3 rate_rad_s_;  ///< bias taken off
  bool rate_is_lower_bound_ = false;
  CompensatedSum roll_angle_rad_;
  bool roll_is_bridged_ = false;

  SensorState accelerometer_ = SensorState::failed;
  std::optional<Microseconds> accelerometer_time_;
  Vector3 specific_force_m_s2_;

  Trajectory trajectory_;
  Trajectory pad_;        ///< at rest, as the pad window last saw it
  PadWindow pad_window_;  // large, so nearly last: what lies beyond 1 kB costs the Cortex-M4 an address each time
  GyroPair gyro_pair_;
};

}  // namespace fantail::core
