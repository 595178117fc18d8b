// SPDX-License-Identifier: MIT
#include "files/quantities.hpp"

#include <algorithm>

namespace fantail::files {
namespace {

using D = Dimension;
using Q = Quantity;

constexpr std::array all_quantities{
    KnownQuantity{"time", Q::time, D::time, "time_s"},
    KnownQuantity{"phase", Q::phase, {}, "phase"},
    KnownQuantity{"roll_angle", Q::roll_angle, D::angle, "roll_angle_deg"},
    KnownQuantity{"roll_rate", Q::roll_rate, D::angular_rate, "roll_rate_deg_s"},
    KnownQuantity{"reference", Q::reference, D::angle, "reference_deg"},
    KnownQuantity{"excitation", Q::excitation, D::angle, "excitation_deg"},
    KnownQuantity{"offset_estimate", Q::offset_estimate, D::angle, "offset_estimate_deg"},
    KnownQuantity{"command", Q::command, D::angle, "command_deg"},
    KnownQuantity{"saturated", Q::saturated, {}, "saturated"},
    KnownQuantity{"command_1", Q::command_1, D::angle, "command_1_deg"},
    KnownQuantity{"command_2", Q::command_2, D::angle, "command_2_deg"},
    KnownQuantity{"command_3", Q::command_3, D::angle, "command_3_deg"},
    KnownQuantity{"command_4", Q::command_4, D::angle, "command_4_deg"},
    KnownQuantity{"encoder_1", Q::encoder_1, D::angle, "encoder_1_deg"},
    KnownQuantity{"encoder_2", Q::encoder_2, D::angle, "encoder_2_deg"},
    KnownQuantity{"encoder_3", Q::encoder_3, D::angle, "encoder_3_deg"},
    KnownQuantity{"encoder_4", Q::encoder_4, D::angle, "encoder_4_deg"},
    KnownQuantity{"canard", Q::canard, D::angle, "canard_deg"},
    KnownQuantity{"axial", Q::axial, D::acceleration, "specific_force_m_s2"},
    KnownQuantity{"specific_force", Q::axial, D::acceleration, "specific_force_m_s2"},
    KnownQuantity{"axial_from_rest", Q::axial, D::acceleration, {}, true},
    KnownQuantity{"height", Q::height, D::length, "height_m"},
    KnownQuantity{"speed", Q::speed, D::speed, "speed_m_s"},
    KnownQuantity{"disturbance", Q::disturbance, D::angle, "disturbance_deg"},
    KnownQuantity{"geometric_roll", Q::geometric_roll, D::angle, "geometric_roll_deg"},
    KnownQuantity{"second_axial", Q::second_axial, D::acceleration},
    KnownQuantity{"second_axial_from_rest", Q::second_axial, D::acceleration, {}, true},
    KnownQuantity{"lateral_y", Q::lateral_y, D::acceleration},
    KnownQuantity{"lateral_z", Q::lateral_z, D::acceleration},
    KnownQuantity{"pitch_rate", Q::pitch_rate, D::angular_rate, "pitch_rate_deg_s"},
    KnownQuantity{"yaw_rate", Q::yaw_rate, D::angular_rate},
    KnownQuantity{"pitch", Q::pitch, D::angle, "pitch_deg"},
    KnownQuantity{"fan", Q::fan, {}, "fan_rpm"},
    KnownQuantity{"wind_speed", Q::wind_speed, D::speed, "wind_speed_m_s"},
    KnownQuantity{"height_above_the_sea", Q::height_above_the_sea, D::length},
    KnownQuantity{"total_speed", Q::total_speed, D::speed},
    KnownQuantity{"vertical_speed", Q::vertical_speed, D::speed},
    KnownQuantity{"horizontal_speed", Q::horizontal_speed, D::speed},
    KnownQuantity{"speed_to_the_east", Q::speed_to_the_east, D::speed},
    KnownQuantity{"speed_to_the_north", Q::speed_to_the_north, D::speed},
    KnownQuantity{"air_speed", Q::air_speed, D::speed},
    KnownQuantity{"angle_of_attack", Q::angle_of_attack, D::angle},
    KnownQuantity{"air_density", Q::air_density, D::density},
    KnownQuantity{"temperature", Q::temperature, D::temperature},
    KnownQuantity{"pressure", Q::pressure, D::pressure},
    KnownQuantity{"tilt", Q::tilt, D::angle},
    KnownQuantity{"acceleration_along_the_axis", Q::acceleration_along_the_axis, D::acceleration},
};

// AltOS: `acceleration` is the accelerometer of the flight computer with its pad reading taken off; the IMU of a
// TeleMega or EasyMega gives the rest. CATS: the Vega upright with its y axis down. PX4: the x axis of the autopilot to
// the nose.
constexpr std::array known_loggers{
    Logger{
        "easymini", "CSV export of AltosUI of a computer without accelerometer or radio (EasyMini)",
        "time=time:s,axial_from_rest=acceleration:m/s2,height=height:m,speed=speed:m/s",
        "version,serial,flight,time,acceleration", 2147483647.0, "call,accel_x",
        "This computer has no accelerometer: its acceleration is made from the barometer, and is late and smooth. What "
        "a launch detector would have done with it says nothing of one with an accelerometer."},
    Logger{"altos", "CSV export of AltosUI (TeleMetrum, TeleMega, EasyMega)",
           "time=time:s,axial_from_rest=acceleration:m/s2,lateral_y=accel_y:m/s2,lateral_z=accel_z:m/s2,"
           "roll_rate=gyro_roll:deg/s,pitch_rate=gyro_pitch:deg/s,yaw_rate=gyro_yaw:deg/s,height=height:m,"
           "speed=speed:m/s",
           "version,serial,flight,time,acceleration", 2147483647.0},
    Logger{"cats", "imu.csv of a CATS Vega",
           "time=ts:s,axial=-Ay:m/s2,lateral_y=Ax:m/s2,lateral_z=Az:m/s2,roll_rate=-Gy:deg/s,pitch_rate=Gx:deg/s,"
           "yaw_rate=Gz:deg/s",
           "ts,Ax,Ay,Az,Gx,Gy,Gz"},
    Logger{"px4", "ULog of PX4, or its topic sensor_combined as CSV",
           "time=timestamp:us,axial=accelerometer_m_s2[0]:m/s2,lateral_y=accelerometer_m_s2[1]:m/s2,"
           "lateral_z=accelerometer_m_s2[2]:m/s2,roll_rate=gyro_rad[0]:rad/s,pitch_rate=gyro_rad[1]:rad/s,"
           "yaw_rate=gyro_rad[2]:rad/s,height=baro_alt_meter:m",
           "timestamp,accelerometer_m_s2[0],gyro_rad[0]"},
    Logger{"fantail", "flight.csv of fantail fly and of fantail log export",
           "time=time_s:s,axial=specific_force_m_s2:m/s2,roll_rate=roll_rate_deg_s:deg/s,height=true_height_m:m,"
           "speed=true_speed_m_s:m/s",
           "time_s,specific_force_m_s2"},
};

// OpenRocket's: FlightDataType. RocketPy's: the second name of each Function of Flight.
constexpr std::array known_exports{
    ExportedColumn{"Time", Q::time, "OpenRocket, RocketPy"},
    ExportedColumn{"Altitude", Q::height, "OpenRocket"},
    ExportedColumn{"Altitude AGL", Q::height, "RocketPy, \"altitude\""},
    ExportedColumn{"Altitude above sea level", Q::height_above_the_sea, "OpenRocket"},
    ExportedColumn{"Z", Q::height_above_the_sea, "RocketPy, \"z\""},
    ExportedColumn{"Total velocity", Q::total_speed, "OpenRocket"},
    ExportedColumn{"Speed - Velocity Magnitude", Q::total_speed, "RocketPy, \"speed\""},
    ExportedColumn{"Vertical velocity", Q::vertical_speed, "OpenRocket"},
    ExportedColumn{"Vz", Q::vertical_speed, "RocketPy, \"vz\""},
    ExportedColumn{"Lateral velocity", Q::horizontal_speed, "OpenRocket"},
    ExportedColumn{"Horizontal Speed", Q::horizontal_speed, "RocketPy, \"horizontal_speed\""},
    ExportedColumn{"Vx", Q::speed_to_the_east, "RocketPy, \"vx\""},
    ExportedColumn{"Vy", Q::speed_to_the_north, "RocketPy, \"vy\""},
    ExportedColumn{"Freestream Speed", Q::air_speed, "RocketPy, \"free_stream_speed\""},
    ExportedColumn{"Angle of attack", Q::angle_of_attack, "both"},
    ExportedColumn{"Air density", Q::air_density, "OpenRocket"},
    ExportedColumn{"Density", Q::air_density, "RocketPy, \"density\""},
    ExportedColumn{"Air temperature", Q::temperature, "OpenRocket"},
    ExportedColumn{"Air pressure", Q::pressure, "OpenRocket"},
    ExportedColumn{"Pressure", Q::pressure, "RocketPy, \"pressure\""},
    ExportedColumn{"Vertical orientation (zenith)", Q::tilt, "OpenRocket"},
    ExportedColumn{"Attitude Angle", Q::tilt, "RocketPy, \"attitude_angle\""},
    ExportedColumn{"Axial Acceleration", Q::acceleration_along_the_axis, "RocketPy, \"axial_acceleration\""},
};

bool has_any(std::span<const std::string> columns, std::string_view names) {
  while (!names.empty()) {
    const std::size_t comma = std::min(names.find(','), names.size());
    if (std::ranges::find(columns, names.substr(0, comma)) != columns.end()) {
      return true;
    }
    names.remove_prefix(std::min(comma + 1, names.size()));
  }
  return false;
}

bool has_all(std::span<const std::string> columns, std::string_view names) {
  while (!names.empty()) {
    const std::size_t comma = std::min(names.find(','), names.size());
    if (std::ranges::find(columns, names.substr(0, comma)) == columns.end()) {
      return false;
    }
    names.remove_prefix(std::min(comma + 1, names.size()));
  }
  return true;
}

}  // namespace

std::span<const KnownQuantity> known_quantities() { return all_quantities; }

const KnownQuantity& known(Quantity quantity) {
  return *std::ranges::find(all_quantities, quantity, &KnownQuantity::quantity);
}

const KnownQuantity* of_own_column(std::string_view column) {
  const auto found = std::ranges::find(all_quantities, column, &KnownQuantity::column);
  return found == all_quantities.end() || column.empty() ? nullptr : &*found;
}

std::string word(Quantity quantity) {
  std::string words{known(quantity).name};
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::span<const Logger> loggers() { return known_loggers; }

const Logger* find_logger(std::string_view name) {
  const auto found = std::ranges::find(known_loggers, name, &Logger::name);
  return found == known_loggers.end() ? nullptr : &*found;
}

const Logger* logger_of(std::span<const std::string> columns) {
  const auto found = std::ranges::find_if(known_loggers, [&](const Logger& logger) {
    return has_all(columns, logger.known_by) && !has_any(columns, logger.lacks);
  });
  return found == known_loggers.end() ? nullptr : &*found;
}

std::span<const ExportedColumn> exported_columns() { return known_exports; }

}  // namespace fantail::files
