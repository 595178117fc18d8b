// SPDX-License-Identifier: MIT
#include "faults.hpp"

namespace fantail::devices {

std::optional<int> duration_ms(Fault fault) {
  return fault == Fault::for_50_ms ? std::optional{50} : fault == Fault::for_2_s ? std::optional{2'000} : std::nullopt;
}

namespace {

/// Temporary ones are silence.
Answers answers(Fault fault) {
  switch (fault) {
    case Fault::late: return Answers::late;
    case Fault::repeats: return Answers::repeated;
    case Fault::flips: return Answers::flipped;
    case Fault::other: return Answers::right;
    default: return Answers::none;
  }
}

void set_imu(WholeBoard& board, Fault fault, bool on) {
  board.imu_wire.answers = on ? answers(fault) : Answers::right;
  board.imu_device.id = on && fault == Fault::other ? 0x12 : 0x47;
}
void set_line(WholeBoard& board, Fault fault, bool on) {
  board.imu_line_is_on = !on || fault == Fault::flips;
  board.imu_line_storms = on && fault == Fault::flips;
}
void set_accelerometer(WholeBoard& board, Fault fault, bool on) {
  board.accelerometer_wire.answers = on ? answers(fault) : Answers::right;
  board.accelerometer_device.id = on && fault == Fault::other ? 0x12 : 0x46;
}
void set_encoder(WholeBoard& board, Fault fault, bool on) {
  board.encoder_wires[0].answers = on ? answers(fault) : Answers::right;
  board.encoder_of[0] = on && fault == Fault::other ? 1 : 0;
}
void set_encoders(WholeBoard& board, Fault fault, bool on) {
  for (WireFault& wire : board.encoder_wires) {
    wire.answers = on ? answers(fault) : Answers::right;
  }
}
void set_servo(WholeBoard& board, Fault fault, bool on) {
  board.servo_dead[0] = on && (fault == Fault::never || duration_ms(fault));
  board.servo_jammed[0] = on && fault == Fault::repeats;
  board.servo_lag_ms[0] = on && fault == Fault::late ? 400.0 : 20.0;
  board.driven_by =
      on && fault == Fault::other ? std::array<std::size_t, 4>{1, 0, 2, 3} : std::array<std::size_t, 4>{0, 1, 2, 3};
}
void set_flash(WholeBoard& board, Fault fault, bool on) {
  board.flash_wire.answers = on ? answers(fault) : Answers::right;
  board.flash_device.id[0] = on && fault == Fault::other ? 0xC8 : 0xEF;
}
void set_bus(WholeBoard& board, Fault, bool on) {
  board.can.set_state(on ? hal::CanState::bus_off : hal::CanState::error_active);
}
void set_switch(WholeBoard& board, Fault fault, bool on) {
  board.switch_chatters = on && fault == Fault::flips;
  board.switch_is_stuck = on && fault == Fault::repeats;
  board.switch_wire_is_off = on && fault != Fault::flips && fault != Fault::repeats;
}
void set_battery(WholeBoard& board, Fault, bool on) { board.battery_answers = !on; }

const std::vector<Fault> all{Fault::never, Fault::late,      Fault::repeats, Fault::flips,
                             Fault::other, Fault::for_50_ms, Fault::for_2_s};
const std::vector<Fault> silences{Fault::never, Fault::for_50_ms, Fault::for_2_s};
}  // namespace

const std::map<std::string, Fault> faults{{"never answers", Fault::never},
                                          {"answers late", Fault::late},
                                          {"repeats its last answer", Fault::repeats},
                                          {"flips bits", Fault::flips},
                                          {"has thousands of edges", Fault::flips},
                                          {"chatters", Fault::flips},
                                          {"answers for another", Fault::other},
                                          {"silent for 50 ms", Fault::for_50_ms},
                                          {"silent for 2 s", Fault::for_2_s}};

const std::map<std::string, Device> devices{
    {"IMU", {set_imu, all}},
    {"IMU, its data-ready line", {set_line, {Fault::never, Fault::flips, Fault::for_50_ms, Fault::for_2_s}}},
    {"second accelerometer", {set_accelerometer, all}},
    {"encoder 1", {set_encoder, all}},
    {"all encoders", {set_encoders, silences}},
    {"servo 1",
     {set_servo, {Fault::never, Fault::late, Fault::repeats, Fault::other, Fault::for_50_ms, Fault::for_2_s}}},
    {"flash", {set_flash, all}},
    {"CAN bus", {set_bus, silences}},
    {"arm switch", {set_switch, {Fault::never, Fault::repeats, Fault::flips, Fault::for_50_ms, Fault::for_2_s}}},
    {"battery", {set_battery, silences}},
};

}  // namespace fantail::devices
