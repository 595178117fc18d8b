// SPDX-License-Identifier: MIT
#include "protocol/log_schema.hpp"

#include "protocol/log_notes.hpp"
#include "protocol/log_tick.hpp"

namespace fantail::protocol {

static_assert(log_tick_size == 50 && second_gyro_size == 9 && pressure_size == 6 && log_event_size == 8 &&
                  log_health_size == 23,
              "the lines below say so");

namespace {

// In one piece: a log of one gyro has all but the last of its records.
constexpr std::string_view all =
    "tick 50\n"
    "0 u16:0.3 phase\n"
    "0 u16:3.2 command_status\n"
    "0 u16:5.2 imu_status\n"
    "0 u16:7.2 accelerometer_status\n"
    "0 u16:9.1 arm_switch_closed\n"
    "0 u16:10.1 arm_command\n"
    "0 u16:11.1 start_command\n"
    "0 u16:12.1 saturated\n"
    "0 u16:13.1 timing_fault\n"
    "0 u16:14.1 abort\n"
    "2 u16 imu_age us\n"
    "4 i16 rate_x count\n"
    "6 i16 rate_y count\n"
    "8 i16 rate_z count\n"
    "10 i16 specific_force_x count\n"
    "12 i16 specific_force_y count\n"
    "14 i16 specific_force_z count\n"
    "16 u16 accelerometer_age us\n"
    "18 i16 accelerometer_x count\n"
    "20 i16 accelerometer_y count\n"
    "22 i16 accelerometer_z count\n"
    "24 u16:0.14 encoder_1 count\n"
    "24 u16:14.2 encoder_1_status\n"
    "26 u16:0.14 encoder_2 count\n"
    "26 u16:14.2 encoder_2_status\n"
    "28 u16:0.14 encoder_3 count\n"
    "28 u16:14.2 encoder_3_status\n"
    "30 u16:0.14 encoder_4 count\n"
    "30 u16:14.2 encoder_4_status\n"
    "32 f32 command rad\n"
    "36 i16 command_1 mdeg\n"
    "38 i16 command_2 mdeg\n"
    "40 i16 command_3 mdeg\n"
    "42 i16 command_4 mdeg\n"
    "44 u16 duration_before us\n"
    "46 u32 digest\n"
    "event 8\n"
    "0 u8 kind\n"
    "1 u8 value\n"
    "2 u8 detail\n"
    "3 u8 index\n"
    "4 u32 number\n"
    "health 23\n"
    "0 u8 verdict_1\n"
    "1 u8 verdict_2\n"
    "2 u8 verdict_3\n"
    "3 u8 verdict_4\n"
    "4 u8 gyro_state\n"
    "5 u8 accelerometer_state\n"
    "6 u8 bus_state\n"
    "7 u16 longest_tick us\n"
    "9 u16 longest_queue tick\n"
    "11 u32 ticks_dropped tick\n"
    "15 u32 unsent frame\n"
    "19 u32 bus_errors frame\n"
    "second_gyro 9\n"
    "0 u16 age us\n"
    "2 i16 rate_x count\n"
    "4 i16 rate_y count\n"
    "6 i16 rate_z count\n"
    "8 u8 status\n";

constexpr std::string_view of_barometer =
    "barometer 6\n"
    "0 u16 age us\n"
    "2 u32 pressure Pa\n";

}  // namespace

std::string_view log_schema() { return all.substr(0, all.find("second_gyro")); }

std::string_view log_schema_of_two_gyros() { return all; }

std::string_view log_schema_of_barometer() { return of_barometer; }

}  // namespace fantail::protocol
