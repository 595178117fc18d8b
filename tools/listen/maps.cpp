// SPDX-License-Identifier: MIT
#include "listen/maps.hpp"

#include <algorithm>
#include <array>

namespace fantail::listen {
namespace {

// AltOS: `acceleration` is the accelerometer of the flight computer with its pad reading taken off; the IMU of a
// TeleMega or EasyMega gives the rest. CATS: the Vega upright with its y axis down. PX4: the x axis of the autopilot to
// the nose.
constexpr std::array shipped_maps{
    Map{"altos", "CSV export of AltosUI (TeleMetrum, TeleMega, EasyMega)",
        "time=time:s,axial_from_rest=acceleration:m/s2,lateral_y=accel_y:m/s2,lateral_z=accel_z:m/s2,"
        "roll_rate=gyro_roll:deg/s,pitch_rate=gyro_pitch:deg/s,yaw_rate=gyro_yaw:deg/s,height=height:m,speed=speed:m/s",
        "version,serial,flight,time,acceleration"},
    Map{"cats", "imu.csv of a CATS Vega",
        "time=ts:s,axial=-Ay:m/s2,lateral_y=Ax:m/s2,lateral_z=Az:m/s2,roll_rate=-Gy:deg/s,pitch_rate=Gx:deg/s,"
        "yaw_rate=Gz:deg/s",
        "ts,Ax,Ay,Az,Gx,Gy,Gz"},
    Map{"px4", "ULog of PX4, or its topic sensor_combined as CSV",
        "time=timestamp:us,axial=accelerometer_m_s2[0]:m/s2,lateral_y=accelerometer_m_s2[1]:m/s2,"
        "lateral_z=accelerometer_m_s2[2]:m/s2,roll_rate=gyro_rad[0]:rad/s,pitch_rate=gyro_rad[1]:rad/s,"
        "yaw_rate=gyro_rad[2]:rad/s,height=baro_alt_meter:m",
        "timestamp,accelerometer_m_s2[0],gyro_rad[0]"},
    Map{"fantail", "flight.csv of fantail fly and of fantail log export",
        "time=time_s:s,axial=specific_force_m_s2:m/s2,roll_rate=roll_rate_deg_s:deg/s,height=true_height_m:m,"
        "speed=true_speed_m_s:m/s",
        "time_s,specific_force_m_s2"},
};

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

std::span<const Map> maps() { return shipped_maps; }

const Map* find_map(std::string_view name) {
  const auto found = std::ranges::find(shipped_maps, name, &Map::name);
  return found == shipped_maps.end() ? nullptr : &*found;
}

const Map* map_of(std::span<const std::string> columns) {
  const auto found = std::ranges::find_if(shipped_maps, [&](const Map& map) { return has_all(columns, map.known_by); });
  return found == shipped_maps.end() ? nullptr : &*found;
}

Sources sources_of(const Map& map) {
  Sources sources = parse_columns(map.columns, std::string{map.name});
  for (Source& source : sources) {
    source.must_be_there = source.quantity == Quantity::time || source.quantity == Quantity::axial;
  }
  return sources;
}

}  // namespace fantail::listen
