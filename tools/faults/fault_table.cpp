// SPDX-License-Identifier: MIT
#include "faults/fault_table.hpp"

#include <algorithm>

// What is safe, device by device, stated before anything was flown. Nothing here is made from what a flight showed; a
// cell that does not keep to it is red, and a red one that nobody can mend stands in known_limits.cpp.
namespace fantail::faults {
namespace {

using sim::Behaviour;
using sim::Device;
using sim::GearFault;
using sim::ServoFault;
using enum Outcome;
using enum Shaft;

constexpr Expected with(Expected expected, double trim_s) {
  expected.trim_s = trim_s;
  return expected;
}

// ---- what is safe, in words that the rows use ----

constexpr Expected unfit = any_of(not_armed, no_control);  // found before arming, or never controlled
constexpr Expected found_or_harmless =
    any_of(not_armed, holds);                 // found by the self-test, or begun after it and harmless
constexpr Expected holds_on = any_of(holds);  // nothing of it is seen in the roll angle
constexpr Expected never = any_of(no_control);
constexpr Expected at_trim_or_holds = any_of(no_control, holds, over);
constexpr Expected not_seen_or_holds = any_of(no_control, holds);  // launch detection needs it
constexpr Expected back_soon = any_of(holds, recovers);
constexpr Expected back_or_over = any_of(no_control, holds, recovers, over);
constexpr Expected some_of_the_time = any_of(no_control, holds, goes_on, over);
constexpr Expected whatever = any_of(not_armed, no_control, holds, recovers, over);
constexpr Expected stays = any_of(over);  // Finished, canards at trim
constexpr Expected beyond_us = any_of(anything);

// A row's five cells: on the pad, armed, launched, controlling, after control.
using Cells = std::array<Expected, phases>;
constexpr Cells sensor_that_decides{unfit, at_trim_or_holds, at_trim_or_holds, at_trim_or_holds, stays};
constexpr Cells sensor_gone_50_ms{found_or_harmless, any_of(no_control, holds, recovers),
                                  any_of(no_control, holds, recovers), back_soon, stays};
constexpr Cells sensor_gone_2_s{whatever, back_or_over, back_or_over, back_or_over, stays};
constexpr Cells sensor_flickers{whatever, some_of_the_time, some_of_the_time, some_of_the_time, stays};
constexpr Cells harmless{found_or_harmless, holds_on, holds_on, holds_on, stays};
constexpr Cells for_detection_only{any_of(not_armed, no_control, holds), not_seen_or_holds, not_seen_or_holds, holds_on,
                                   stays};
constexpr Cells second_gyro{any_of(not_armed, no_control, holds), at_trim_or_holds, at_trim_or_holds, at_trim_or_holds,
                            stays};
constexpr Cells no_servo{beyond_us, beyond_us, beyond_us, beyond_us, stays};
constexpr Cells resumed{any_of(not_armed, holds), any_of(no_control), any_of(no_control, holds, recovers), back_soon,
                        stays};
constexpr Cells not_resumed{any_of(not_armed, holds), never, with(any_of(no_control, over), 0.5),
                            with(any_of(over), 0.5), with(stays, 0.5)};

/// What is safe where a sensor is wrong for good, has spikes, is silent for a while or comes and goes.
struct SensorCells {
  Cells for_good;
  Cells spike;
  Cells silent_3ms;
  Cells silent_50ms;
  Cells silent_2s;
  Cells flickers;
};
constexpr SensorCells of_imu{sensor_that_decides, second_gyro,     harmless,
                             sensor_gone_50_ms,   sensor_gone_2_s, sensor_flickers};
constexpr SensorCells of_second_imu{second_gyro, second_gyro, harmless, harmless, harmless, harmless};
constexpr SensorCells of_accelerometer{for_detection_only, for_detection_only, harmless,
                                       for_detection_only, for_detection_only, for_detection_only};

// clang-format off: a fault a row
constexpr std::array<FaultRow, 14> sensor(std::string_view name, Device device, const SensorCells& safe) {
  return {{
    {name, "dead", "does not answer", broken(device, Behaviour::dead), safe.for_good},
    {name, "stuck", "repeats the counts of its last sample as new ones", broken(device, Behaviour::stuck), safe.for_good},
    {name, "repeated", "repeats its last sample, with its old time", broken(device, Behaviour::repeated), safe.for_good},
    {name, "saturated", "reads the upper end of its range along the long axis", broken(device, Behaviour::saturated), safe.for_good},
    {name, "garbage", "random counts, without an error", broken(device, Behaviour::garbage), safe.for_good},
    {name, "spike", "one sample of random counts in 50", spike(device), safe.spike},
    {name, "slow", "one new sample every 10 ms", slow_samples(device), safe.for_good},
    {name, "delayed", "delivers its samples 20 ms late", broken(device, sim::Delayed{0.02}), safe.for_good},
    {name, "nan", "counts that mean no value, without an error", broken(device, Behaviour::nan), safe.for_good},
    {name, "silent_3ms", "does not answer for 3 ms", silent_for(0.003, device), safe.silent_3ms},
    {name, "silent_50ms", "does not answer for 50 ms", silent_for(0.05, device), safe.silent_50ms},
    {name, "silent_2s", "does not answer for 2 s", silent_for(2.0, device), safe.silent_2s},
    {name, "flickers_3ms", "does not answer for 3 ms of every 30", again(device, Behaviour::dead, 0.003, 0.027), safe.flickers},
    {name, "flickers_100ms", "does not answer for 0.1 s of every 0.5 s", again(device, Behaviour::dead, 0.1, 0.4), safe.flickers},
  }};
}

constexpr std::array<FaultRow, 2> offsets(std::string_view name, Device device, const Cells& safe) {
  return {{
    {name, "offset_100", "its gyro reads 100 deg/s more about the long axis", offset(device, 100.0), safe},
    {name, "offset_15", "its gyro reads 15 deg/s more about the long axis", offset(device, 15.0), safe},
  }};
}

// Nothing begins or ends on a barometer alone.
constexpr auto of_barometer = std::to_array<FaultRow>({
  {"barometer", "dead", "does not answer", broken(Device::barometer, Behaviour::dead), harmless},
  {"barometer", "stuck", "repeats the pressure of its last sample as a new one", broken(Device::barometer, Behaviour::stuck), harmless},
  {"barometer", "hangs", "repeats its last sample, with its old time", broken(Device::barometer, Behaviour::hangs), harmless},
  {"barometer", "garbage", "random pressures, without an error", broken(Device::barometer, Behaviour::garbage), harmless},
  {"barometer", "spike", "one random pressure in 5", again(Device::barometer, Behaviour::garbage, 0.01, 0.04), harmless},
  {"barometer", "blocked", "its static ports are closed", broken(Device::barometer, Behaviour::blocked), harmless},
  {"barometer", "lit", "sunlight: reads 125 m too high", broken(Device::barometer, Behaviour::lit), harmless},
  {"barometer", "lit_100ms", "sunlight for 0.1 s of every 0.5 s", again(Device::barometer, Behaviour::lit, 0.1, 0.4), harmless},
  {"barometer", "silent_50ms", "does not answer for 50 ms", silent_for(0.05, Device::barometer), harmless},
  {"barometer", "silent_2s", "does not answer for 2 s", silent_for(2.0, Device::barometer), harmless},
  {"barometer", "flickers_100ms", "does not answer for 0.1 s of every 0.5 s", again(Device::barometer, Behaviour::dead, 0.1, 0.4), harmless},
});

constexpr auto others = std::to_array<FaultRow>({
  {"encoder", "dead", "does not answer", broken(Device::encoder, Behaviour::dead), harmless},
  {"encoder", "stuck", "repeats its last reading", broken(Device::encoder, Behaviour::stuck), harmless},
  {"encoder", "saturated", "reads the last count of its turn", broken(Device::encoder, Behaviour::saturated), harmless},
  {"encoder", "garbage", "random readings, without an error", broken(Device::encoder, Behaviour::garbage), harmless},
  {"encoder", "spike", "one random reading in 50", spike(Device::encoder), harmless},
  {"encoder", "delayed", "delivers its readings 0.1 s late", broken(Device::encoder, sim::Delayed{0.1}), harmless},
  {"encoder", "nan", "readings beyond a turn, without an error", broken(Device::encoder, Behaviour::nan), harmless},
  {"encoder", "silent_3ms", "does not answer for 3 ms", silent_for(0.003, Device::encoder), harmless},
  {"encoder", "silent_50ms", "does not answer for 50 ms", silent_for(0.05, Device::encoder), harmless},
  {"encoder", "silent_2s", "does not answer for 2 s", silent_for(2.0, Device::encoder), harmless},
  {"encoder", "flickers_3ms", "does not answer for 3 ms of every 30", again(Device::encoder, Behaviour::dead, 0.003, 0.027), harmless},
  {"encoder", "flickers_1s", "does not answer for 1 s of every 2 s", again(Device::encoder, Behaviour::dead, 1.0, 1.0), harmless},
  {"encoder", "all_dead", "all four do not answer", all(Device::encoder, Behaviour::dead), harmless},
  {"encoder", "all_stuck", "all four repeat their last readings", all(Device::encoder, Behaviour::stuck), harmless},

  {"servo", "dead", "receives no pulses; friction holds the shaft", broken(Device::servo, Behaviour::dead), harmless, stays_short},
  {"servo", "torn_off", "the air turns the shaft back to zero", gear(ServoFault::dead), harmless, stays_short},
  {"servo", "stuck", "jammed where it stands", broken(Device::servo, GearFault{ServoFault::stuck}), harmless, stays_short},
  {"servo", "hardover", "runs to its positive stop", hardover, harmless, runs_away},
  {"servo", "hardover_back", "stands at its negative stop", hardover_back, harmless, runs_away},
  {"servo", "slipping", "loses a third of every movement", gear(ServoFault::slipping), harmless, stays_short},
  {"servo", "repeated", "receives its last pulse again and again", broken(Device::servo, Behaviour::repeated), harmless, stays_short},
  {"servo", "garbage", "receives random pulses of 500 to 2500 us", broken(Device::servo, Behaviour::garbage), harmless, runs_away},
  {"servo", "spike", "receives random pulses for 3 ms of every 100", again(Device::servo, Behaviour::garbage, 0.003, 0.097), harmless, jolts},
  {"servo", "cut_pulse", "receives pulses cut short at random", broken(Device::servo, Behaviour::cut), harmless, runs_away},
  {"servo", "cut_once", "receives pulses cut short at random for 3 ms", broken(Device::servo, Behaviour::cut, 0.003), harmless, jolts},
  {"servo", "nan", "receives pulses without width", broken(Device::servo, Behaviour::nan), harmless, stays_short},
  {"servo", "slow", "four times the lag, a quarter of the rate limit", broken(Device::servo, GearFault{ServoFault::slow}), harmless, late},
  {"servo", "delayed", "receives its pulses 0.1 s late", broken(Device::servo, sim::Delayed{0.1}), harmless, late},
  {"servo", "silent_50ms", "receives no pulses for 50 ms", silent_for(0.05, Device::servo), harmless, stays_short},
  {"servo", "silent_2s", "receives no pulses for 2 s", silent_for(2.0, Device::servo), harmless, stays_short},
  {"servo", "flickers_3ms", "receives no pulses for 3 ms of every 30", again(Device::servo, Behaviour::dead, 0.003, 0.027), harmless, late},
  {"servo", "flickers_1s", "receives no pulses for 1 s of every 2 s", again(Device::servo, Behaviour::dead, 1.0, 1.0), harmless, stays_short},
  {"servo", "all_dead", "none of the four receives pulses", all(Device::servo, Behaviour::dead), no_servo, stays_short},
  {"servo", "all_50ms", "none of the four receives pulses for 50 ms", all(Device::servo, Behaviour::dead, 0.05), {found_or_harmless, back_soon, back_soon, back_soon, stays}, stays_short},
  {"servo", "all_cut_once", "all four receive pulses cut short at random for 3 ms", all(Device::servo, Behaviour::cut, 0.003), {found_or_harmless, back_soon, back_soon, back_soon, stays}, jolts},

  {"bus", "dead", "carries nothing", broken(Device::bus, Behaviour::dead), harmless},
  {"bus", "flooded", "30 random frames a millisecond", broken(Device::bus, Behaviour::garbage), harmless},
  {"bus", "repeated", "earlier frames are sent again, nine a millisecond", broken(Device::bus, Behaviour::repeated), harmless},
  {"bus", "silent_2s", "carries nothing for 2 s", silent_for(2.0, Device::bus), harmless},
  {"bus", "flickers_30ms", "carries nothing for 30 ms of every 60", again(Device::bus, Behaviour::dead, 0.03, 0.03), harmless},

  {"flash", "dead", "does not answer", broken(Device::flash, Behaviour::dead), harmless},
  {"flash", "busy", "stays busy", broken(Device::flash, Behaviour::stuck), harmless},
  {"flash", "slow", "busy for 3 ms of every 4", again(Device::flash, Behaviour::stuck, 0.003, 0.001), harmless},
  {"flash", "silent_50ms", "does not answer for 50 ms", silent_for(0.05, Device::flash), harmless},
  {"flash", "silent_2s", "does not answer for 2 s", silent_for(2.0, Device::flash), harmless},

  {"supply", "sagging", "the board finds it too low from then on", broken(Device::supply, Behaviour::sagging), harmless},
  {"supply", "sags_50ms", "the board finds it too low for 50 ms", broken(Device::supply, Behaviour::sagging, 0.05), harmless},
  {"supply", "flickers_30ms", "the board finds it too low for 30 ms of every 0.3 s", again(Device::supply, Behaviour::sagging, 0.03, 0.27), harmless},
  {"supply", "brown_out", "resets the processor, which is back 60 ms later", reset(hal::ResetCause::brown_out, 0.06), not_resumed},

  {"arm_switch", "open", "opens", broken(Device::arm_switch, Behaviour::dead), {unfit, never, not_seen_or_holds, holds_on, stays}},
  {"arm_switch", "stuck", "stays as it stands", broken(Device::arm_switch, Behaviour::stuck), harmless},
  {"arm_switch", "chatters", "open for 30 ms of every 60", again(Device::arm_switch, Behaviour::dead, 0.03, 0.03), harmless},
  {"arm_switch", "open_50ms", "open for 50 ms", silent_for(0.05, Device::arm_switch), {any_of(not_armed, no_control, holds), never, not_seen_or_holds, holds_on, stays}},

  {"abort_input", "dead", "its wire is broken: the contact is open", broken(Device::abort_input, Behaviour::dead), {any_of(not_armed, no_control, holds), not_seen_or_holds, any_of(no_control, holds, over), any_of(holds, over), stays}},
  {"abort_input", "pressed", "asks to abort", broken(Device::abort_input, Behaviour::pressed), {unfit, never, any_of(no_control, over), stays, stays}},
  {"abort_input", "chatters", "asks to abort for 30 ms of every 60", again(Device::abort_input, Behaviour::pressed, 0.03, 0.03), harmless},

  {"memory", "flight_law", "one bit of the flight law flips", broken(Device::memory, Behaviour::law_bit_flipped), {whatever, at_trim_or_holds, at_trim_or_holds, at_trim_or_holds, stays}},
  {"memory", "plan", "one bit of the plan flips", broken(Device::memory, Behaviour::plan_bit_flipped), {whatever, at_trim_or_holds, at_trim_or_holds, at_trim_or_holds, stays}},

  {"processor", "watchdog", "hangs for 50 ms, and is reset and back 10 ms later", reset(hal::ResetCause::watchdog, 0.06), resumed},
  {"processor", "crash", "crashes, and is back 15 ms later", reset(hal::ResetCause::software, 0.015), resumed},
  {"processor", "long_gap", "is reset by its watchdog, and back 0.4 s later", reset(hal::ResetCause::watchdog, 0.4), {any_of(not_armed, holds), never, with(any_of(no_control, over), 1.0), with(any_of(over), 1.0), with(stays, 1.0)}},
  {"processor", "reset_button", "is reset, and back 60 ms later", reset(hal::ResetCause::pin, 0.06), not_resumed},
  {"processor", "memory_lost", "is reset by its watchdog, and its backup memory is empty", reset(hal::ResetCause::watchdog, 0.06, 1, sim::MemoryAfterReset::lost), not_resumed},
  {"processor", "boot_loop", "is reset by its watchdog six times, 0.2 s apart", reset(hal::ResetCause::watchdog, 0.06, 6), {any_of(not_armed, holds), never, with(any_of(no_control, holds, recovers, over), 1.6), with(any_of(holds, recovers, over), 1.6), with(stays, 1.6)}},
  {"processor", "stands_3ms", "has no ticks for 3 ms", silent_for(0.003, Device::processor), harmless},
  {"processor", "stands_45ms", "has no ticks for 45 ms", silent_for(0.045, Device::processor), {any_of(not_armed, no_control, holds), any_of(no_control, holds), any_of(no_control, holds, over), any_of(over), stays}},
  {"processor", "flickers_3ms", "has no ticks for 3 ms of every 30", again(Device::processor, Behaviour::dead, 0.003, 0.027), {any_of(not_armed, no_control, holds, over), any_of(no_control, over), any_of(no_control, over), with(any_of(over), 1.0), stays}},
});
// clang-format on

template <std::size_t... sizes>
constexpr auto joined(const std::array<FaultRow, sizes>&... parts) {
  std::array<FaultRow, (sizes + ...)> all;
  auto* at = all.data();
  ((at = std::ranges::copy(parts, at).out), ...);
  return all;
}

constexpr auto table = joined(sensor("imu", Device::imu, of_imu), offsets("imu", Device::imu, of_imu.for_good),
                              sensor("second_imu", Device::second_imu, of_second_imu),
                              offsets("second_imu", Device::second_imu, of_second_imu.for_good),
                              sensor("accelerometer", Device::accelerometer, of_accelerometer), of_barometer, others);

}  // namespace

std::span<const FaultRow> fault_table() { return table; }

}  // namespace fantail::faults
