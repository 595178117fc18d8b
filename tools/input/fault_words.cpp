// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <stdexcept>
#include <variant>

#include "input/fault_file.hpp"

// Every fault that can be flown, with its words and what it does, and every key that a file may say of one. Reading,
// refusals, sentences, playground and manual are made of these tables.
namespace fantail::input {
namespace {

using sim::Behaviour;
using sim::Device;
using sim::How;
using sim::ServoFault;

// Of no end, and of one that the file gives.
constexpr sim::Fault stays(Device device, How how) { return {.device = device, .how = how}; }
constexpr sim::Fault ends(Device device, How how) { return {.device = device, .how = how, .until_s = 0.0}; }
constexpr sim::Fault gear(ServoFault fault) { return stays(Device::servo, sim::GearFault{fault}); }
constexpr FaultWords by_device(Device device, std::string_view behaviour, std::string_view meaning, How how) {
  return {"device", behaviour, meaning, ends(device, how)};
}

// clang-format off: a fault a row
constexpr auto kinds = std::to_array<FaultWords>({
  {"canard_stuck", "", "the shaft is jammed", gear(ServoFault::stuck)},
  {"canard_hardover", "", "runs to the positive stop and stays there", gear(ServoFault::hardover)},
  {"canard_dead", "", "torn from its servo: the air turns it back to zero", gear(ServoFault::dead)},
  {"canard_slipping", "", "loses a third of every movement", gear(ServoFault::slipping)},
  {"canard_reversed", "", "turns the other way", gear(ServoFault::reversed)},
  {"canard_slow", "", "four times the lag, a quarter of the rate limit", gear(ServoFault::slow)},
  {"canard_wrong_trim", "", "the horn is fitted off-centre: the shaft is offset from the angle of the servo", stays(Device::servo, sim::GearFault{ServoFault::wrong_trim, sim::usual_wrong_trim_rad})},
  {"encoder_unplugged", "", "does not answer", stays(Device::encoder, Behaviour::dead)},
  {"encoder_noisy", "", "other noise than that of the vehicle", stays(Device::encoder, sim::Noisy{})},
  {"imu_dropout", "", "hangs and repeats its last sample", ends(Device::imu, Behaviour::hangs)},
  {"accelerometer_dropout", "", "hangs and repeats its last sample", ends(Device::accelerometer, Behaviour::hangs)},
  {"imu_frozen", "", "its gyro repeats its last counts as if they were new", ends(Device::imu, Behaviour::gyro_frozen)},
  {"imu_offset", "", "its gyro reads a wrong rate about the long axis", ends(Device::imu, sim::RateOffset{})},
  {"second_imu_dropout", "", "as imu_dropout, of the second IMU", ends(Device::second_imu, Behaviour::hangs)},
  {"second_imu_frozen", "", "as imu_frozen, of the second IMU", ends(Device::second_imu, Behaviour::gyro_frozen)},
  {"second_imu_offset", "", "as imu_offset, of the second IMU", ends(Device::second_imu, sim::RateOffset{})},
  {"reset", "", "the processor is reset, and the avionics restart while the rocket flies on", stays(Device::processor, sim::Reset{})},
  {"device", "", "a device fails for good, for a while or repeatedly: see the next table", ends(Device::imu, Behaviour::dead)},
});

constexpr auto of_devices = std::to_array<FaultWords>({
  by_device(Device::imu, "dead", "does not answer", Behaviour::dead),
  by_device(Device::imu, "stuck", "repeats the counts of its last sample, with new times", Behaviour::stuck),
  by_device(Device::imu, "repeated", "repeats its last sample, with its old time", Behaviour::repeated),
  by_device(Device::imu, "saturated", "the x axes of gyro and accelerometer read their upper ends", Behaviour::saturated),
  by_device(Device::imu, "garbage", "random counts on every axis, with new times and no error", Behaviour::garbage),
  by_device(Device::imu, "nan", "counts at the lower end on every axis, with new times and no error", Behaviour::nan),
  by_device(Device::imu, "delayed", "delivers its samples `delay_s` late, with their own times", sim::Delayed{}),
  by_device(Device::second_imu, "dead", "as `imu`", Behaviour::dead),
  by_device(Device::second_imu, "stuck", "as `imu`", Behaviour::stuck),
  by_device(Device::second_imu, "repeated", "as `imu`", Behaviour::repeated),
  by_device(Device::second_imu, "saturated", "as `imu`", Behaviour::saturated),
  by_device(Device::second_imu, "garbage", "as `imu`", Behaviour::garbage),
  by_device(Device::second_imu, "nan", "as `imu`", Behaviour::nan),
  by_device(Device::second_imu, "delayed", "as `imu`", sim::Delayed{}),
  by_device(Device::accelerometer, "dead", "as `imu`, of the second accelerometer", Behaviour::dead),
  by_device(Device::accelerometer, "stuck", "as `imu`", Behaviour::stuck),
  by_device(Device::accelerometer, "repeated", "as `imu`", Behaviour::repeated),
  by_device(Device::accelerometer, "saturated", "as `imu`", Behaviour::saturated),
  by_device(Device::accelerometer, "garbage", "as `imu`", Behaviour::garbage),
  by_device(Device::accelerometer, "nan", "as `imu`", Behaviour::nan),
  by_device(Device::accelerometer, "delayed", "as `imu`", sim::Delayed{}),
  by_device(Device::encoder, "dead", "does not answer", Behaviour::dead),
  by_device(Device::encoder, "stuck", "repeats its last reading", Behaviour::stuck),
  by_device(Device::encoder, "saturated", "reads the last count of its turn", Behaviour::saturated),
  by_device(Device::encoder, "garbage", "random readings without an error", Behaviour::garbage),
  by_device(Device::encoder, "nan", "readings beyond a turn, without an error", Behaviour::nan),
  by_device(Device::encoder, "delayed", "delivers its readings `delay_s` late", sim::Delayed{}),
  by_device(Device::servo, "dead", "receives no pulses: without power, friction holds its shaft", Behaviour::dead),
  by_device(Device::servo, "stuck", "its shaft is jammed where it stands", sim::GearFault{ServoFault::stuck}),
  by_device(Device::servo, "repeated", "receives its last pulse again and again", Behaviour::repeated),
  by_device(Device::servo, "saturated", "runs to its positive stop, whatever pulses it receives", sim::GearFault{ServoFault::hardover}),
  by_device(Device::servo, "garbage", "receives random pulses of 500 to 2500 us", Behaviour::garbage),
  by_device(Device::servo, "nan", "receives pulses without width, which it ignores", Behaviour::nan),
  by_device(Device::servo, "delayed", "receives its pulses `delay_s` late", sim::Delayed{}),
  by_device(Device::servo, "slow", "four times the lag, a quarter of the rate limit", sim::GearFault{ServoFault::slow}),
  by_device(Device::servo, "cut", "receives each pulse cut short at a random part of its width", Behaviour::cut),
  by_device(Device::bus, "dead", "carries nothing", Behaviour::dead),
  by_device(Device::bus, "repeated", "a node repeats the frames that it has received, nine a millisecond", Behaviour::repeated),
  by_device(Device::bus, "garbage", "a node sends 30 frames of random content a millisecond", Behaviour::garbage),
  by_device(Device::flash, "dead", "does not answer", Behaviour::dead),
  by_device(Device::flash, "stuck", "stays busy", Behaviour::stuck),
  by_device(Device::supply, "sagging", "the board finds the supply of its processor too low", Behaviour::sagging),
  by_device(Device::arm_switch, "dead", "is open", Behaviour::dead),
  by_device(Device::arm_switch, "stuck", "stays as it stands", Behaviour::stuck),
  by_device(Device::abort_input, "dead", "its wire is broken: the contact is open", Behaviour::dead),
  by_device(Device::abort_input, "pressed", "asks to abort: its contact opens or closes, as `run.abort_input` says", Behaviour::pressed),
  by_device(Device::memory, "law_bit_flipped", "one random bit of the flight law flips, once", Behaviour::law_bit_flipped),
  by_device(Device::memory, "plan_bit_flipped", "one random bit of the plan flips, once", Behaviour::plan_bit_flipped),
  by_device(Device::processor, "dead", "has no ticks; nothing resets it, and the servos receive the last pulses", Behaviour::dead),
  by_device(Device::barometer, "dead", "does not answer", Behaviour::dead),
  by_device(Device::barometer, "stuck", "repeats the pressure of its last sample, with new times", Behaviour::stuck),
  by_device(Device::barometer, "hangs", "measures nothing and repeats its last sample, with its old time", Behaviour::hangs),
  by_device(Device::barometer, "garbage", "random pressures of 300 to 1100 hPa, with new times and no error", Behaviour::garbage),
  by_device(Device::barometer, "blocked", "its static ports are closed: the bay keeps its pressure", Behaviour::blocked),
  by_device(Device::barometer, "lit", "sunlight: reads 1500 Pa too low, at the ground 125 m too high", Behaviour::lit),
});
// clang-format on

constexpr auto kind_names = [] {
  std::array<std::string_view, kinds.size()> names{};
  std::ranges::transform(kinds, names.begin(), &FaultWords::kind);
  return names;
}();
constexpr auto cause_names = [] {
  std::array<std::string_view, hal::reset_causes> names{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = hal::name(static_cast<hal::ResetCause>(i));
  }
  return names;
}();
constexpr auto memory_names = std::to_array<std::string_view>({"kept", "lost"});

constexpr std::array<std::string_view, sim::devices> device_names{
    "imu",    "second_imu", "accelerometer", "encoder", "servo",     "bus",      "flash",
    "supply", "arm_switch", "abort_input",   "memory",  "processor", "barometer"};
constexpr auto behaviour_names = std::to_array<std::string_view>(
    {"dead", "stuck", "repeated", "saturated", "garbage", "nan", "delayed", "slow", "cut", "sagging", "pressed",
     "law_bit_flipped", "plan_bit_flipped", "hangs", "blocked", "lit"});

constexpr Unit number_from_one{.first = 1};

constexpr bool any(const FaultWords&) { return true; }
constexpr bool lasts_for_a_while(const FaultWords& words) { return words.fault.until_s.has_value(); }
constexpr bool is_by_device(const FaultWords& words) { return words.kind == "device"; }
constexpr bool is_of_one_canard(const FaultWords& words) { return sim::is_of_canard(words.fault.device); }
template <typename How>
constexpr bool has(const FaultWords& words) {
  return std::holds_alternative<How>(words.fault.how);
}
template <sim::ServoFault Fault>
constexpr bool breaks(const FaultWords& words) {
  return has<sim::GearFault>(words) && std::get<sim::GearFault>(words.fault.how).fault == Fault;
}

// Every device may be given one; of those that are not delayed it says nothing.
constexpr Place<sim::Fault> delay{.set =
                                      [](sim::Fault& fault, std::size_t, double inside) {
                                        if (auto* delayed = std::get_if<sim::Delayed>(&fault.how)) {
                                          delayed->delay_s = inside;
                                        }
                                      },
                                  .get =
                                      [](const sim::Fault& fault, std::size_t) {
                                        const auto* delayed = std::get_if<sim::Delayed>(&fault.how);
                                        return (delayed == nullptr ? sim::Delayed{} : *delayed).delay_s;
                                      }};

// clang-format off: one field a row reads better than one argument a line
#define AT(expression) FANTAIL_PLACE(sim::Fault, expression)
constexpr auto fields = std::to_array<FaultField>({
  {{"faults", "kind", choice(kind_names), must, {}, "A kind from the table below."}, any},
  {{"faults", "from_s", number("s", {-600, 3600}), must, AT(it.from_s), "Start of the fault, after ignition (tunnel: after the start command). Below zero: on the pad; before power-up: from the first tick."}, any},
  {{"faults", "until_s", number("s", {-600, 3600}), must, AT(it.until_s), "End of the fault; later than `from_s`."}, lasts_for_a_while},
  {{"faults", "canard", integer(number_from_one, {1, 4}), must, AT(it.canard), "Which canard, servo or encoder."}, is_of_one_canard},
  {{"faults", "angle_deg", number(deg, {-90, 90}), may, AT(std::get<sim::GearFault>(it.how).angle_rad), "Angle at which the shaft jams, within the stop of the servo; left out: where it stands."}, breaks<sim::ServoFault::stuck>},
  {{"faults", "angle_deg", number(deg, {-15, 15}), may, AT(std::get<sim::GearFault>(it.how).angle_rad), "Offset of the shaft, within the stop of the servo; not 0."}, breaks<sim::ServoFault::wrong_trim>},
  {{"faults", "noise_counts", number("counts", {1, 1000}), may, AT(std::get<sim::Noisy>(it.how).noise_counts), "Standard deviation of the readings; 16384 counts are a turn."}, has<sim::Noisy>},
  {{"faults", "offset_deg_s", number(deg_s, {-2000, 2000}), must, AT(std::get<sim::RateOffset>(it.how).rate_rad_s), "Added to the rate about the long axis."}, has<sim::RateOffset>},
  {{"faults", "cause", choice(cause_names), may, AT(std::get<sim::Reset>(it.how).cause), "Cause that the avionics read when they restart. They resume a flight after `watchdog` and `software` only."}, has<sim::Reset>},
  {{"faults", "gap_s", number("s", {0.001, 10}), may, AT(std::get<sim::Reset>(it.how).gap_s), "Time without ticks. The servos get no pulses, except after `watchdog` until the last 0.01 s. Without pulses friction holds a simulated shaft."}, has<sim::Reset>},
  {{"faults", "memory", choice(memory_names), may, AT(std::get<sim::Reset>(it.how).memory), "Whether the backup memory survives the reset."}, has<sim::Reset>},
  {{"faults", "clock_error_s", number("s", {-0.25, 0.25}), may, AT(std::get<sim::Reset>(it.how).clock_error_s), "Error of the gap that the avionics measure; above zero: longer than it was."}, has<sim::Reset>},
  {{"faults", "device", choice(device_names), must, AT(it.device), "The device that fails."}, is_by_device},
  {{"faults", "behaviour", choice(behaviour_names), must, {}, "How it fails; one of the behaviours of this device."}, is_by_device},
  {{"faults", "canard", integer(number_from_one, {1, 4}), may, AT(it.canard), "The canard to which the encoder or servo belongs."}, is_by_device},
  {{"faults", "on_s", number("s", {0, 3600}), may, AT(it.on_s), "For a fault that comes and goes: how long it is there, in whole milliseconds; 0: all the time."}, is_by_device},
  {{"faults", "off_s", number("s", {0, 3600}), may, AT(it.off_s), "How long it is then gone; both repeat."}, is_by_device},
  {{"faults", "delay_s", number("s", {0.001, sim::Delayed::longest_s}), may, delay, "Delay of `delayed`, in whole milliseconds."}, is_by_device},
});
// clang-format on

}  // namespace

std::span<const FaultWords> fault_kinds() { return kinds; }

std::span<const FaultWords> device_faults() { return of_devices; }

const FaultWords& words_of(const sim::Fault& fault) {
  const auto has_its_end = [&](const FaultWords& words) {
    return words.fault.until_s.has_value() == fault.until_s.has_value();
  };
  const FaultWords* found = nullptr;
  for (const std::span<const FaultWords> table : {device_faults(), fault_kinds()}) {
    for (const FaultWords& words : table) {
      if (sim::is_same_kind(words.fault, fault) && (found == nullptr || (has_its_end(words) && !has_its_end(*found)))) {
        found = &words;
      }
    }
  }
  if (found == nullptr) {
    throw std::logic_error{"a fault that no table has"};
  }
  return *found;
}

std::string_view name(sim::Device device) { return device_names[static_cast<std::size_t>(device)]; }

std::span<const FaultField> fault_fields() { return fields; }

}  // namespace fantail::input
