// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/angle.hpp"
#include "core/time.hpp"

namespace fantail::core {

// Of a FlightPlan, what says when control begins and ends.

/// How control begins.
enum class Start : std::uint8_t {
  launch,  ///< when a launch has been detected and the guide is clear
  tunnel,  ///< in a wind tunnel: on command, from rest
};

/// What a canard that the monitor has judged does to control.
enum class CanardFaultPolicy : std::uint8_t {
  continue_control,  ///< nothing: it is recorded
  end_control,       ///< ends it
  share,             ///< control goes on, and the healthy canards carry what a faulty one does not do
};

/// What the tilt limit is counted from.
enum class TiltOrigin : std::uint8_t {
  vertical,
  guide,  ///< the direction in which the axis pointed at rest on the pad
};

/// What a contact between a pin, which has a pull-up, and ground does.
enum class AbortInput : std::uint8_t {
  none,           ///< nothing: no contact is fitted
  open_aborts,    ///< a broken wire aborts, too
  closed_aborts,  ///< a broken wire does not abort
};

/// When control begins and ends.
struct RunPlan {
  Start start;
  Microseconds control_time;  ///< control ends this long after control start
  Angle tilt_limit;           ///< the flight is over for control when the axis has turned this far ...
  TiltOrigin tilt_from;       ///< ... from here
  CanardFaultPolicy canard_fault;
  std::uint16_t overrun_limit;  ///< control ticks that may fail to come in a flight, and before it is armed
  AbortInput abort_input;
};

/// When a rocket has left its launch guide.
struct GuidePlan {
  float length_m;
  float clearance_m;            ///< control starts this far beyond the end of the guide ...
  float minimum_speed_m_s;      ///< ... and faster than this ...
  Microseconds clearance_time;  ///< ... within this time of launch detection
};

/// Until when canards stay at trim, see DormancyGate.
enum class DormantUntil : std::uint8_t {
  guide,  ///< until the guide is clear, as published
  burn_out,
  max_dynamic_pressure,
  height,
  burn_out_and_height,
  max_dynamic_pressure_and_height,
};

/// What a range asks a rocket to wait for before it moves its canards.
struct DormancyPlan {
  DormantUntil until;
  float height_m;           ///< above the place of lift-off
  Microseconds burn_time;   ///< of the motor, from first to last thrust
  float burn_clock_factor;  ///< burn-out is believed after this many burn times
  float scale_error;        ///< of the accelerometer that height is integrated from: a share of what it reads ...
  float bias_error_m_s2;    ///< ... and this, at most
};

}  // namespace fantail::core
