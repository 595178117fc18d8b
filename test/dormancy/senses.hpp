// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/inputs.hpp"
#include "dormancy/ascent.hpp"
#include "random_stream.hpp"

namespace fantail::dormancy {

using Axes = std::array<double, 3>;

/// Of what the devices of one rocket are off.
struct Errors {
  std::array<Axes, 2> bias_m_s2{};  ///< of each accelerometer, 60 mg at most
  std::array<double, 2> scale{};    ///< 1 % at most
  Axes turned_rad{};                ///< board against the rocket's axis, 0.7 degrees at most
  Axes rate_bias_rad_s{};
  Axes rate_drift_rad_s2{};  ///< from ignition on
  double rate_scale = 0.0;
};
[[nodiscard]] Errors draw_errors(core::RandomStream& random);

/// The device whose samples go wrong.
enum class Part : unsigned char { none, imu, accelerometer_1, accelerometer_2, gyro, encoder, clock, arm_switch };
inline constexpr std::size_t parts = 8;
[[nodiscard]] std::string_view name(Part part);

enum class How : unsigned char { silent, error, stuck, repeated, full_range, garbage, no_number, late, shifted };
inline constexpr std::size_t hows = 9;
[[nodiscard]] std::string_view name(How how);

struct Fault {
  Part part = Part::none;
  How how = How::silent;
  double from_s = 0.0;  ///< after ignition
  double until_s = 0.0;
  double size = 0.0;  ///< -1 to 1: which way something is shifted, and how far
  std::size_t canard = 0;
};
[[nodiscard]] Fault draw_fault(double burn_s, core::RandomStream& random);

/// What shakes this flight.
struct Shaking {
  double rms_m_s2 = 0.0;       ///< at the full thrust, 2 g at most; a fifth of it comes with the dynamic pressure
  double frequency_hz = 40.0;  ///< of the middle of its band
  double white_m_s2 = 0.0;     ///< rms of what each accelerometer adds by itself
  double lost = 0.0;           ///< share of the samples that do not come
};
[[nodiscard]] Shaking draw_shaking(core::RandomStream& random);

/// What the devices read, a tick after the other.
class Senses {
 public:
  Senses(const Errors& errors, const Shaking& shaking, const Fault& fault, double top_pressure,
         core::RandomStream& random);

  /// At rest and before ignition the ascent has not advanced.
  const core::Inputs& read(core::Microseconds now, const Ascent& ascent, double gravity_m_s2);

  core::EncoderAngles shafts{};  ///< where the canards stand

 private:
  double normal();
  double shake();
  void spoil(const Ascent& ascent);
  void spoil_sample(core::Vector3& value, core::Microseconds& time, core::SampleQuality& quality, float range);

  Errors errors_;
  Shaking shaking_;
  Fault fault_;
  double top_pressure_;
  core::RandomStream* random_;
  core::Inputs inputs_{};
  core::Inputs before_{};  ///< as the fault began
  core::Inputs shown_{};
  double roll_rad_ = 0.0;
  double keep_last_ = 0.0;
  double keep_one_before_ = 0.0;
  double drive_ = 1.0;
  std::array<double, 2> resonance_{};
  double spare_ = 0.0;
  bool has_spare_ = false;
  int lost_for_ = 0;
};

}  // namespace fantail::dormancy
