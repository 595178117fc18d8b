// SPDX-License-Identifier: MIT
// Prints one hash a part of the flight law, over inputs made of integers only. See same_bits.cmake.
#include <bit>
#include <cstdint>
#include <cstdio>

#include "core/canard_mixer.hpp"
#include "core/canard_monitor.hpp"
#include "core/chirp.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/gain_schedule.hpp"
#include "core/offset_estimator.hpp"
#include "core/pd_controller.hpp"
#include "core/roll_reference.hpp"
#include "core/trig.hpp"

namespace {

using namespace fantail::core;

// FNV-1a over whole words. Every NaN counts as the same one: their bits are the processor's own affair.
class Hash {
 public:
  void add(std::uint32_t word) { value_ = (value_ ^ word) * 1099511628211U; }
  void add(float number) { add(number == number ? std::bit_cast<std::uint32_t>(number) : 0x7FC00000U); }
  void add(Angle angle) { add(angle.radians()); }
  void print(const char* name) const { std::printf("%s %016llx ", name, static_cast<unsigned long long>(value_)); }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

// A float with random bits: all sizes, infinities and NaN.
float any_float(std::uint32_t i) {
  std::uint32_t h = i * 0x9E3779B1U;
  h = (h ^ (h >> 15U)) * 0x85EBCA77U;
  return std::bit_cast<float>(h ^ (h >> 13U));
}

void hash_trig() {
  Hash hash;
  for (std::uint32_t i = 0; i < 1'000'000; ++i) {
    const float bits = any_float(i);
    const float number = static_cast<float>(static_cast<std::int32_t>(i) - 500'000) * 0.02F;
    for (const float x : {bits, number}) {
      hash.add(sin(Angle::from_radians(x)));
      hash.add(cos(Angle::from_radians(x)));
      hash.add(sin_turns(x));
      hash.add(atan2(x, any_float(i + 1)));
      hash.add(atan2(x, 3.0F));
    }
  }
  hash.print("trig");
}

void hash_law() {
  Hash hash;
  FlightPlan plan = default_plan();
  plan.reference.kind = ReferenceKind::square_wave;
  plan.reference.square_wave_frequency_hz = 0.7F;
  plan.excitation.amplitude_variation = Angle::from_degrees(1.0F);
  plan.excitation.frequency_variation_hz = 0.5F;
  plan.canards.each[1].direction = Direction::reversed;
  plan.canards.each[2].trim = Angle::from_degrees(1.7F);
  for (const ExcitationForm form : {ExcitationForm::product, ExcitationForm::sweep}) {
    plan.excitation.form = form;
    Chirp chirp{plan.excitation};
    CanardMixer mixer{plan.canards, plan.controller.canard_limit};
    CanardMonitor monitor{plan.monitor, plan.canards};
    Angle roll_angle;
    float roll_rate_rad_s = 0.0F;
    EncoderAngles encoders{Angle{}, Angle{}, Angle{}, Angle{}};
    for (Microseconds t{0}; t < Microseconds{10'000'000}; t += Microseconds{1000}) {
      const Angle reference = roll_reference(plan.reference, t);
      const RollCommand command =
          pd_controller(plan.controller, reference, roll_angle, roll_rate_rad_s, chirp.update(t));
      CanardCommands canards;
      mixer.mix(t, command.command, std::nullopt, encoders, canards);
      for (std::size_t i = 0; i < canard_count; ++i) {
        encoders[i] = canards[i].angle;
        hash.add(canards[i].pulse_us);
        hash.add(static_cast<std::uint32_t>(monitor.update(t, canards, encoders)[i]));
      }
      roll_rate_rad_s += 0.001F * (60.0F * mixer.canard_angle(encoders)->radians() - 5.0F * roll_rate_rad_s);
      roll_angle += Angle::from_radians(0.001F * roll_rate_rad_s);
      hash.add(command.unclamped);
      hash.add(roll_angle);
    }
  }
  for (const PlanField& field : flight_plan_fields()) {
    for (std::size_t slot = 0; slot < field.slots; ++slot) {
      hash.add(field.get_bits(plan, slot));
      hash.add(field.get(plan, slot));
    }
  }
  hash.print("law");
}

void hash_modes() {
  Hash hash;
  FlightPlan plan = default_plan();
  plan.roll_model = {.roll_inertia_kg_m2 = 0.00393F,
                     .reference_area_m2 = 5.0265e-5F,
                     .damping_m2 = 23.0F,
                     .torque_m = 9.0F,
                     .density_kg_m3 = 1.225F};
  plan.gain_schedule = {
      .speeds_count = 3, .speeds_m_s = {15.0F, 40.0F, 80.0F}, .factors_count = 3, .factors = {1.5F, 1.1F, 0.7F}};
  for (const OffsetRejection rejection : {OffsetRejection::integral, OffsetRejection::observer}) {
    plan.offset.rejection = rejection;
    OffsetEstimator estimator{plan};
    Motion motion;
    motion.gyro = SensorState::fresh;
    for (std::uint32_t i = 0; i < 10'000; ++i) {
      motion.speed_m_s = 0.01F * static_cast<float>(i);
      const Angle reference =
          Angle::from_degrees(static_cast<float>(static_cast<std::int32_t>(i / 500 % 3) - 1) * 10.0F);
      const float factor = gain_factor(plan.gain_schedule, motion.speed_m_s, false);
      estimator.update(motion, reference - motion.roll_angle, factor,
                       {-plan.controller.canard_limit, plan.controller.canard_limit});
      const RollCommand command = pd_controller(plan.controller, reference, motion.roll_angle, motion.roll_rate_rad_s,
                                                Angle{}, {factor, estimator.estimate()});
      estimator.remember(command);
      motion.roll_rate_rad_s += 0.001F * (60.0F * (command.command.radians() - 0.08F) - 5.0F * motion.roll_rate_rad_s);
      motion.roll_angle += Angle::from_radians(0.001F * motion.roll_rate_rad_s);
      hash.add(command.unclamped);
      hash.add(estimator.estimate());
    }
  }
  hash.print("modes");
}

}  // namespace

int main() {
  hash_trig();
  hash_law();
  hash_modes();
}
