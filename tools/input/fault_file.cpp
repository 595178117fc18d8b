// SPDX-License-Identifier: MIT
#include "input/fault_file.hpp"

#include <algorithm>
#include <cmath>

#include "input/messages.hpp"
#include "sim/servo.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

constexpr auto kinds = std::to_array<FaultText>({
    {"canard_stuck", "the shaft is jammed"},
    {"canard_hardover", "runs to the positive stop and stays there"},
    {"canard_dead", "torn from its servo: the air turns it back to zero"},
    {"canard_slipping", "loses a third of every movement"},
    {"canard_reversed", "turns the other way"},
    {"canard_slow", "four times the lag, a quarter of the rate limit"},
    {"canard_wrong_trim", "the horn was fitted off: the shaft stands away from where the servo believes"},
    {"encoder_unplugged", "does not answer"},
    {"encoder_noisy", "noise instead of that of the vehicle"},
    {"imu_dropout", "hangs: its last sample comes again"},
    {"accelerometer_dropout", "hangs: its last sample comes again"},
    {"imu_frozen", "its gyro's last counts come again and again, as if they were new"},
    {"imu_offset", "its gyro reads another rate about the long axis"},
    {"second_imu_dropout", "as imu_dropout, of the second IMU"},
    {"second_imu_frozen", "as imu_frozen, of the second IMU"},
    {"second_imu_offset", "as imu_offset, of the second IMU"},
    {"reset", "the processor is reset, and the avionics begins anew while the rocket flies on"},
    {"device", "a device misbehaves, for good or for a while or again and again: see the next table"},
});

constexpr auto kind_names = [] {
  std::array<std::string_view, kinds.size()> names{};
  std::ranges::transform(kinds, names.begin(), &FaultText::name);
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

constexpr std::array<std::string_view, sim::devices> all_device_names{
    "imu",   "second_imu", "accelerometer", "encoder", "servo",    "bus",
    "flash", "supply",     "arm_switch",    "memory",  "processor"};
constexpr std::array<std::string_view, sim::behaviours> all_behaviour_names{
    "dead",    "stuck", "repeated", "saturated", "garbage",         "nan",
    "delayed", "slow",  "cut",      "sagging",   "law_bit_flipped", "plan_bit_flipped"};

constexpr Unit number_from_one{.first = 1};

template <sim::FaultKind Kind>
constexpr bool is(sim::FaultKind kind) {
  return kind == Kind;
}
constexpr bool is_any(sim::FaultKind) { return true; }
constexpr bool is_of_one_canard(sim::FaultKind kind) {
  return !sim::is_of_sensor(kind) && !sim::is_reset(kind) && !sim::is_of_device(kind);
}
constexpr bool lasts_for_a_while(sim::FaultKind kind) { return sim::is_of_sensor(kind) || sim::is_of_device(kind); }

// clang-format off: one field a row reads better than one argument a line
#define AT(expression) FANTAIL_PLACE(sim::Fault, expression)
constexpr auto fields = std::to_array<FaultField>({
  {{"faults", "kind", choice(kind_names), must, AT(it.kind), "One of the table below."}, is_any},
  {{"faults", "from_s", number("s", {-600, 3600}), must, AT(it.from_s), "Begins, after ignition (tunnel: after the start command); below zero on the pad; what begins before power-up, as -600, is there from the first tick."}, is_any},
  {{"faults", "until_s", number("s", {-600, 3600}), must, AT(it.until_s), "Ends, after `from_s`."}, lasts_for_a_while},
  {{"faults", "canard", integer(number_from_one, {1, 4}), must, AT(it.canard), "Which canard, servo or encoder."}, is_of_one_canard},
  {{"faults", "angle_deg", number(deg, {-90, 90}), may, AT(it.angle_rad), "Where the shaft is jammed, within the stop of the servo; left out: where it stands."}, is<sim::FaultKind::canard_stuck>},
  {{"faults", "angle_deg", number(deg, {-15, 15}), may, AT(it.angle_rad), "How far off the shaft stands, within the stop of the servo; not 0."}, is<sim::FaultKind::canard_wrong_trim>},
  {{"faults", "noise_counts", number("counts", {1, 1000}), may, AT(it.noise_counts), "Standard deviation of the readings; 16384 counts are a turn."}, is<sim::FaultKind::encoder_noisy>},
  {{"faults", "offset_deg_s", number(deg_s, {-2000, 2000}), must, AT(it.rate_offset_rad_s), "Added to the rate about the long axis."}, sim::is_offset},
  {{"faults", "cause", choice(cause_names), may, AT(it.reset.cause), "What the avionics finds as the cause when it begins anew. It resumes a flight after `watchdog` and `software` only."}, sim::is_reset},
  {{"faults", "gap_s", number("s", {0.001, 10}), may, AT(it.reset.gap_s), "So long there is no tick. The servos get no pulses in its last 0.01 s, while the firmware starts; before that, after `watchdog`, they get what they got, and after the others none. A simulated servo without pulses has no power, and friction holds its shaft."}, sim::is_reset},
  {{"faults", "memory", choice(memory_names), may, AT(it.reset.memory), "What becomes of the backup memory, from which a flight is resumed."}, sim::is_reset},
  {{"faults", "clock_error_s", number("s", {-0.25, 0.25}), may, AT(it.reset.clock_error_s), "By so much the avionics takes the gap for longer than it was."}, sim::is_reset},
  {{"faults", "device", choice(all_device_names), must, AT(it.misbehaviour.device), "Which."}, sim::is_of_device},
  {{"faults", "behaviour", choice(all_behaviour_names), must, AT(it.misbehaviour.behaviour), "How; one of those that the device has."}, sim::is_of_device},
  {{"faults", "canard", integer(number_from_one, {1, 4}), may, AT(it.canard), "Whose encoder or servo."}, sim::is_of_device},
  {{"faults", "on_s", number("s", {0, 3600}), may, AT(it.misbehaviour.on_s), "It comes and goes: there for so long from `from_s` on, whole milliseconds; 0: there all the time."}, sim::is_of_device},
  {{"faults", "off_s", number("s", {0, 3600}), may, AT(it.misbehaviour.off_s), "And then gone for so long, again and again."}, sim::is_of_device},
  {{"faults", "delay_s", number("s", {0.001, sim::longest_misbehaviour_delay_s}), may, AT(it.misbehaviour.delay_s), "Of `delayed`: so late, whole milliseconds."}, sim::is_of_device},
});
// clang-format on

void check(Section& section, const sim::Fault& fault, const sim::Vehicle& vehicle) {
  const double servo_stop_rad = vehicle.servo.stop_rad;
  if (sim::is_of_second_imu(fault.kind) && !vehicle.second_imu_is_fitted) {
    section.refuse("kind",
                   "= " + std::string{name(fault.kind)} + ", and the vehicle has no second IMU (second_imu.fitted)");
  }
  if (lasts_for_a_while(fault.kind) && fault.until_s <= fault.from_s) {
    section.refuse("until_s", "= " + plain_number(fault.until_s) + " is out of range; allowed: later than from_s = " +
                                  plain_number(fault.from_s) + ", up to 3600");
  }
  if (fault.angle_rad && std::abs(*fault.angle_rad) > servo_stop_rad) {
    section.refuse("angle_deg", "= " + plain_number(deg.in_file(*fault.angle_rad)) +
                                    "; allowed: within the servo's stop, " + about(deg.in_file(servo_stop_rad)) +
                                    " either way");
  }
  if (fault.kind == sim::FaultKind::canard_wrong_trim && *fault.angle_rad == 0.0) {
    section.refuse("angle_deg", "= 0; allowed: -15 to 15, but not 0");
  }
}

std::string behaviours_of(sim::Device device) {
  std::string names;
  for (const sim::DeviceBehaviour& one : sim::misbehaviours) {
    if (one.device == device) {
      names += (names.empty() ? "" : ", ") + std::string{name(one.behaviour)};
    }
  }
  return names;
}

void check_device(Section& section, const sim::Fault& fault, const sim::Vehicle& vehicle) {
  const sim::Misbehaviour& how = fault.misbehaviour;
  if (how.device == sim::Device::second_imu && !vehicle.second_imu_is_fitted) {
    section.refuse("device", "= second_imu, and the vehicle has no second IMU (second_imu.fitted)");
  }
  if (!sim::exists(how.device, how.behaviour)) {
    section.refuse("behaviour", "= " + std::string{name(how.behaviour)} + "; allowed for " +
                                    std::string{name(how.device)} + ": " + behaviours_of(how.device));
  }
  if (how.on_s > 0.0 && how.on_s < 0.001) {
    section.refuse("on_s", "= " + plain_number(how.on_s) + "; allowed: 0, or 0.001 to 3600");
  }
  if (how.off_s > 0.0 && how.on_s == 0.0) {
    section.refuse("off_s", "= " + plain_number(how.off_s) + "; allowed without on_s: 0");
  }
}

void check_reset(Section& section, const sim::Fault& fault) {
  if (fault.from_s < 0.0) {
    section.refuse("from_s", "= " + plain_number(fault.from_s) + "; allowed for a reset: 0 to 3600");
  }
}

sim::Fault read_fault(Section& section, const sim::Vehicle& vehicle) {
  sim::Fault read{};
  read_field(section, fields.front().field, read);
  sim::Fault fault = usual_fault(read.kind);
  for (const FaultField& row : fields) {
    if (row.belongs_to(fault.kind)) {
      read_field(section, row.field, fault);
    }
  }
  section.finish();
  check(section, fault, vehicle);
  if (sim::is_reset(fault.kind)) {
    check_reset(section, fault);
  } else if (sim::is_of_device(fault.kind)) {
    check_device(section, fault, vehicle);
  }
  return fault;
}

}  // namespace

std::span<const FaultText> fault_texts() { return kinds; }

std::string_view name(sim::Device device) { return all_device_names[static_cast<std::size_t>(device)]; }

std::string_view name(sim::Behaviour behaviour) { return all_behaviour_names[static_cast<std::size_t>(behaviour)]; }

std::span<const FaultField> fault_fields() { return fields; }

sim::Fault usual_fault(sim::FaultKind kind) {
  sim::Fault fault{.kind = kind, .canard = 0, .from_s = 0.0, .until_s = 0.0};
  if (kind == sim::FaultKind::canard_wrong_trim) {
    fault.angle_rad = sim::usual_wrong_trim_rad;
  }
  return fault;
}

std::vector<sim::Fault> read_faults(const Document& document, const sim::Vehicle& vehicle) {
  std::vector<sim::Fault> faults;
  const TomlNode node = document.root()["faults"];
  if (!node) {
    return faults;
  }
  const auto elements = node.elements();
  if (!elements || elements->empty() || !std::ranges::all_of(*elements, &TomlNode::is_table)) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      document.where("", "faults", node) + ": faults must be written as [[faults]]"};
  }
  for (const TomlNode element : *elements) {
    Section section{document, "faults", element};
    faults.push_back(read_fault(section, vehicle));
  }
  return faults;
}

}  // namespace fantail::input
