// SPDX-License-Identifier: MIT
#include "files/loggers.hpp"

#include <algorithm>
#include <array>

#include <fmt/core.h>

namespace fantail::files {
namespace {

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
    Logger{"altos", "CSV export of AltosUI, .eeprom or .telem (TeleMetrum, TeleMega, EasyMega)",
           "time=time:s,axial_from_rest=acceleration:m/s2,lateral_y=accel_y:m/s2,lateral_z=accel_z:m/s2,"
           "roll_rate=gyro_roll:deg/s,pitch_rate=gyro_pitch:deg/s,yaw_rate=gyro_yaw:deg/s,height=height:m,"
           "speed=speed:m/s",
           "version,serial,flight,time,acceleration", 2147483647.0},
    Logger{"altos_barometer",
           "flash image or telemetry of an Altus Metrum computer without accelerometer (EasyMini, TeleMini)",
           "time=time:s,height=height:m,speed=speed:m/s", "version,serial,flight,time,height"},
    Logger{.name = "cats_logs",
           .about = "IMU as cats-logs writes it, in g",
           .columns = "time=ts:s,axial=-Ay:g,lateral_y=Ax:g,lateral_z=Az:g,roll_rate=-Gy:deg/s,pitch_rate=Gx:deg/s,"
                      "yaw_rate=Gz:deg/s",
           .known_by = "ts,id,Gx,Gy,Gz,Ax,Ay,Az",
           .in_order = true},
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
    Logger{.name = "blueraven",
           .about = "high-rate CSV of a Featherweight Blue Raven, or its raw text",
           .columns =
               "time=Flight_Time_(s):s,axial=Accel_X:g,lateral_y=Accel_Y:g,lateral_z=Accel_Z:g,roll_rate=Gyro_X:deg/s,"
               "pitch_rate=Gyro_Y:deg/s,yaw_rate=Gyro_Z:deg/s",
           .known_by = "Flight_Time_(s),Accel_X,Accel_Y,Accel_Z,Gyro_X",
           .any_mounting = true},
    Logger{"blueraven_low", "low-rate CSV of a Blue Raven",
           "time=Flight_Time_(s):s,height=Baro_Altitude_AGL_(feet):ft,speed=Velocity_Up:ft/s",
           "Flight_Time_(s),Baro_Press_(atm),Velocity_Up"},
    Logger{"raven", "CSV export of a Featherweight Raven",
           "time=time:s,axial=Axial Accel (Gs):g,height=[Altitude (Baro-Ft-AGL)]:ft,"
           "speed=[Velocity (Accel-Ft/Sec)]:ft/s",
           "time,Axial Accel (Gs)"},
    Logger{"arts2", "interpreted export of an ARTS2 of Loki Research",
           "time=MET:s,axial_from_rest=Acc:g,height=pAlt:ft,speed=Vel:ft/s", "MET,Acc,Vel,iAlt,pAlt"},
    Logger{"aimxtra", "CSV export of an Entacore AIM XTRA",
           "time=time:s,axial=acceleration:g,lateral_y=lat. X accel.:g,lateral_z=lat. Y accel.:g,"
           "height=Pressure AGL:m",
           "time,acceleration,Pressure AGL"},
    Logger{.name = "mercury",
           .about = "CSV export of a Mercury of AltimeterCloud",
           .columns = "time=time(ms):ms,axial=0.001*acceleration_x(mG):g,lateral_y=0.001*acceleration_y(mG):g,"
                      "lateral_z=0.001*acceleration_z(mG):g,height=altitude(m):m,speed=velocity_pressure(m/s):m/s",
           .known_by = "time(ms),altitude(m),acceleration_x(mG),acceleration_y(mG),acceleration_z(mG)",
           .any_mounting = true},
    Logger{"perfectflite", "log of a PerfectFlite altimeter (.pf2, or its data as text)",
           "time=Time:s,height=Altitude:ft,speed=Velocity:ft/s", "Time,Altitude,Velocity,Temperature (F),Voltage"},
    Logger{"stratologger", "text export of a PerfectFlite StratoLogger", "time=Time:s,height=Altitude:ft",
           "Time,Altitude,Temp.,Voltage"},
    Logger{.name = "eggtimer",
           .about = "CSV of an Eggtimer",
           .columns = "time=T:ms,height=Alt:ft,speed=Veloc:ft/s",
           .known_by = "T,Alt,Veloc",
           .doubt = "An Eggtimer that is set to metres writes them under the same names: here they are read as feet."},
    Logger{.name = "rrc3",
           .about = "export of an RRC3 of Missile Works",
           .columns = "time=Time:s,height=Altitude:ft,speed=Velocity:ft/s",
           .known_by = "Time,Altitude,Pressure,Velocity,Temperature,Events",
           .doubt = "The file does not say whether its heights are feet or metres: here they are read as feet."},
    Logger{"cats_flight", "flightInfo.csv of a CATS Vega", "time=ts:s,height=height:m,speed=velocity:m/s",
           "ts,height,velocity,acceleration"},
    Logger{"ardupilot", "DataFlash log of ArduPilot (.bin); x axis to the nose",
           "time=TimeUS:us,axial=IMU.AccX:m/s2,lateral_y=IMU.AccY:m/s2,lateral_z=IMU.AccZ:m/s2,"
           "roll_rate=IMU.GyrX:rad/s,pitch_rate=IMU.GyrY:rad/s,yaw_rate=IMU.GyrZ:rad/s,height=BARO.Alt:m",
           "TimeUS,IMU.AccX,IMU.GyrX"},
    Logger{"betaflight", "black box of Betaflight (.bbl, .bfl); x axis to the nose",
           "time=time:us,axial=accSmooth[0]:g,lateral_y=accSmooth[1]:g,lateral_z=accSmooth[2]:g,"
           "roll_rate=gyroADC[0]:deg/s,pitch_rate=gyroADC[1]:deg/s,yaw_rate=gyroADC[2]:deg/s",
           "time,accSmooth[0],gyroADC[0]"},
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

bool has_all(std::span<const std::string> columns, std::string_view names, bool in_order = false) {
  auto from = columns.begin();
  while (!names.empty()) {
    const std::size_t comma = std::min(names.find(','), names.size());
    const auto found = std::find(from, columns.end(), names.substr(0, comma));
    if (found == columns.end()) {
      return false;
    }
    from = in_order ? found : from;
    names.remove_prefix(std::min(comma + 1, names.size()));
  }
  return true;
}

}  // namespace

std::span<const Logger> loggers() { return known_loggers; }

const Logger* find_logger(std::string_view name) {
  const auto found = std::ranges::find(known_loggers, name, &Logger::name);
  return found == known_loggers.end() ? nullptr : &*found;
}

const Logger* logger_of(std::span<const std::string> columns) {
  const auto found = std::ranges::find_if(known_loggers, [&](const Logger& logger) {
    return has_all(columns, logger.known_by, logger.in_order) && !has_any(columns, logger.lacks);
  });
  return found == known_loggers.end() ? nullptr : &*found;
}

bool has_axial(const Logger& logger) { return logger.columns.find("axial") != std::string_view::npos; }

std::string use_without_axial(std::span<const std::string> columns) {
  if (const Logger* const logger = logger_of(columns); logger != nullptr && !has_axial(*logger)) {
    return fmt::format(
        "its columns are those of the {}: no reading of an accelerometer is among them. {}{}Its height can stand "
        "beside a log that has one: --barometer FILE --barometer-columns {}",
        logger->about, logger->doubt, logger->doubt.empty() ? "" : " ", logger->columns);
  }
  constexpr std::string_view arts2_raw = "MET,Acc(HI),Baro(HI)";
  if (has_all(columns, arts2_raw)) {
    return "it has the raw readings of an ARTS2; its program exports them interpreted, too";
  }
  const auto is_exported = [&](const ExportedColumn& known) {
    return std::ranges::any_of(columns, [&](const std::string& column) {
      return column.starts_with(known.name) && column.substr(known.name.size()).starts_with(" (");
    });
  };
  constexpr std::ptrdiff_t enough = 3;  // a time, a height and a speed
  return std::ranges::count_if(exported_columns(), is_exported) >= enough
             ? "it is the trajectory of a simulation; fantail fly SCENARIO --trajectory FILE flies along it"
             : "";
}

}  // namespace fantail::files
